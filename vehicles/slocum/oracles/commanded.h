// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/hookbeh.h"
#include "vehicles/slocum/oracles/depth_trust.h"
#include "vehicles/slocum/oracles/judge_setup.h"
#include "vehicles/slocum/oracles/names.h"

/// Properties of a cycle's commands that the checks of a flight need.
namespace glider::slocum::oracles {

inline constexpr double kPumpError = 1e-3;  ///< cc; commands that differ by less are the same

inline bool climbs(const hooks::HookbehOutputs& out) {
  return out.pitch_rad > 0 && out.pump_cc > 0;
}

/// True if hookbeh climbs to check whether the depth follows; no guard is active then.
inline bool checksDepth(const hooks::HookbehOutputs& out) {
  return out.doing == hooks::Doing::CheckDepth;
}

/// True if a guard of this kind may have its reason in a limit that is near. Guard 2 turns a dive
/// before the limit is reached, by up to 4 m, and between echoes it counts on a bottom that rises.
/// For guard 1 a CTD that reads too deep is a reason.
inline bool isNearLimit(const JudgeSetup& setup, const CycleView& view, hooks::HookGuard guard,
                        double echo_age_s) {
  constexpr double kNear = 2, kTurnsSooner = 4, kOldEcho = 40;  // m, m, s
  const bool of_bottom = guard == hooks::HookGuard::NearBottom;
  const double low_m = kNear + (of_bottom ? kTurnsSooner : 0);
  const bool low =
      setup.args.least_altitude_m >= 0 && view.clearance_m < setup.args.least_altitude_m + low_m;
  const double ctd_m = ctdDepth(view);
  const double deepest_m =
      guard == hooks::HookGuard::TooDeep && ctd_m > view.true_depth_m ? ctd_m : view.true_depth_m;
  return deepest_m > setup.args.greatest_depth_m - kNear || low ||
         (of_bottom && !(echo_age_s < kOldEcho));
}

/// True if hookbeh climbs against any instruction of the SBC.
inline bool climbsByItself(const hooks::HookbehOutputs& out) {
  return out.guard != hooks::HookGuard::None || checksDepth(out);
}

}  // namespace glider::slocum::oracles
