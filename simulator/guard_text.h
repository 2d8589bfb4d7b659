// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace glider::simulator {

/// Explains case `fired_case` of `list` (hooks::CaseList) in mission state `state`: the guard's
/// text and the platform's numbers of the sensors in it.
struct GuardText {
  std::string guard;
  std::vector<uint16_t> sensors;
};
using GuardResolver = std::function<GuardText(uint32_t list, uint32_t state, uint32_t fired_case)>;

}  // namespace glider::simulator
