// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/evidence/needed_assumptions.h"

#include <cstddef>
#include <utility>

namespace glider::ir::prove {

std::vector<uint32_t> neededAssumptions(
    std::vector<uint32_t> named,
    const std::function<bool(const std::vector<uint32_t>& fewer)>& proves) {
  for (size_t i = named.size(); i-- > 0;) {
    std::vector<uint32_t> fewer = named;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (proves(fewer)) {
      named = std::move(fewer);
    }
  }
  return named;
}

}  // namespace glider::ir::prove
