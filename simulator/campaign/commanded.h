// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/hookbeh.h"

#include <string_view>

/// Properties of a cycle's commands that the checks of a flight need.
namespace glider::simulator {

inline constexpr double kPumpError = 1e-3;  ///< cc; commands that differ by less are the same

inline bool climbs(const hooks::HookbehOutputs& out) {
  return out.pitch_rad > 0 && out.pump_cc > 0;
}

/// True if hookbeh climbs to check whether the depth follows; no guard is active then.
inline bool checksDepth(const hooks::HookbehOutputs& out) {
  return out.doing == std::string_view("check depth");
}

/// True if hookbeh climbs against any instruction of the SBC.
inline bool climbsByItself(const hooks::HookbehOutputs& out) {
  return out.guard != hooks::HookGuard::None || checksDepth(out);
}

}  // namespace glider::simulator
