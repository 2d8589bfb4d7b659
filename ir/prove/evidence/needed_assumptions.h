// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace glider::ir::prove {

/// The assumptions among `named`, all of which a proof may rest on, that it needs: as few as
/// leaving out one after the other finds, the last first, so the same ones each time. `proves`:
/// whether there is also a proof that rests only on these; it is asked again only with fewer.
std::vector<uint32_t> neededAssumptions(
    std::vector<uint32_t> named,
    const std::function<bool(const std::vector<uint32_t>& fewer)>& proves);

}  // namespace glider::ir::prove
