// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/behaviours/refusal_text.h"

#include <fmt/format.h>

#include <cmath>

namespace glider::simulator {

using hooks::HookAnswer;
using hooks::HookVertical;

namespace {

bool is(double value, HookVertical vertical) {
  return value == static_cast<double>(vertical);
}

const char* wordFor(double vertical) {
  return is(vertical, HookVertical::Descend)  ? "a dive"
         : is(vertical, HookVertical::Ascend) ? "a climb"
                                              : "a hover";
}

std::string degrees(double rad) {
  constexpr double kDegrees = 57.29577951308232;
  return fmt::format("{:.4g} deg", rad * kDegrees);
}

/// A dive is commanded with its nose down; the limits are magnitudes in the commanded direction.
std::string pitchText(const hooks::HookbehInputs& in, const hooks::HookbehArgs& args) {
  const bool dives = is(in.words.vertical, HookVertical::Descend);
  const double steepness = dives ? -in.words.hook_pitch_rad : in.words.hook_pitch_rad;
  if (!(steepness > 0)) {
    return fmt::format("{} at a pitch of {} points the wrong way", wordFor(in.words.vertical),
                       degrees(in.words.hook_pitch_rad));
  }
  const bool steep = steepness > args.steepest_pitch_rad;
  return fmt::format("{} {} refuses {} at {}", steep ? "max_pitch" : "min_pitch",
                     degrees(steep ? args.steepest_pitch_rad : args.shallowest_pitch_rad),
                     wordFor(in.words.vertical), degrees(steepness));
}

}  // namespace

std::string refusalText(HookAnswer answer, const hooks::HookbehInputs& in,
                        const hooks::HookbehArgs& args) {
  switch (answer) {
    case HookAnswer::BadCheck:
      return "its words have not arrived whole: the check value does not match";
    case HookAnswer::TooDeep:
      return fmt::format("max_depth {:.6g} m refuses {} to {:.6g} m", args.greatest_depth_m,
                         wordFor(in.words.vertical), in.words.hook_depth_m);
    case HookAnswer::BadPitch:
      return pitchText(in, args);
    case HookAnswer::BadCommand:
      return fmt::format(
          "vertical {:.6g}, depth {:.6g} m, lateral {:.6g}, heading {} is not a valid "
          "command",
          in.words.vertical, in.words.hook_depth_m, in.words.lateral,
          degrees(in.words.hook_heading_rad));
    case HookAnswer::NotOnEarth:
      return fmt::format("waypoint {:.8g}, {:.8g} (ddmm.mmmm) is not a position on Earth",
                         in.words.hook_latitude_ddmm, in.words.hook_longitude_ddmm);
    case HookAnswer::WrongSession:
      return "it is from a session that is not in control";
    case HookAnswer::NotReady:
      return "hookbeh is not ready";
    case HookAnswer::OldSequence:
      return "its number is older than one already processed";
    case HookAnswer::BadFin:
      return fmt::format("max_fin {} refuses a fin at {}", degrees(args.greatest_fin_rad),
                         degrees(in.words.hook_heading_rad));
    case HookAnswer::BadPump:
      return fmt::format("max_pump {:.4g} cc refuses a pump at {:.4g} cc", args.greatest_pump_cc,
                         in.words.hook_depth_m);
    case HookAnswer::BadBattery:
      return fmt::format("max_battery {:.4g} in refuses a pitch battery at {:.4g} in",
                         args.greatest_battery_in, in.words.hook_pitch_rad);
    case HookAnswer::None:
      return "it is from before hookbeh started";
    case HookAnswer::Accepted:
      return "it is in force";
  }
  return "hookbeh gives an unknown answer";
}

}  // namespace glider::simulator
