// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/unseen_sink.h"

#include "hooks/hookbeh/hull.h"
#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// m; noise and waves move a depth by less, a vehicle that is driven by more.
constexpr double kMovesM = 1;
/// m; noise and waves move it by less to and fro.
constexpr double kRegainsM = 3;
/// cc; with less to either side the pump does not say which way the vehicle goes.
constexpr double kDrivesCc = 60;
/// s; so long the pump takes from one side to the other, and the vehicle to turn.
constexpr double kTurnsSecs = 20;
/// s; after so long a vehicle whose pump goes out may rise.
constexpr double kLiftsSecs = 12;
/// Flatter than this a vehicle sinks as at this pitch, rad.
constexpr double kFlatRad = 0.3;
/// m/s; a vehicle whose pump is about neutral sinks no faster in water that it is not trimmed for.
constexpr double kAdriftMps = 0.1;

double magnitude(double value) {
  return value < 0 ? -value : value;
}

/// The fastest a vehicle moves up or down at this pitch, m/s.
double rateAt(double pitch_rad) {
  const double steep = magnitude(pitch_rad);
  return kHull.vertical_rate_m_s * (steep > kFlatRad ? steep : kFlatRad) / kHull.steepest_pitch_rad;
}

}  // namespace

void UnseenSink::observe(double depth_m, double step_s, const VerticalCommand& last) {
  out_s_ = last.pump_cc >= kDrivesCc ? out_s_ + step_s : 0;
  const bool rises = out_s_ > kTurnsSecs;
  const bool sinks = last.pump_cc <= -kDrivesCc || (out_s_ > 0 && !rises);
  in_s_ = sinks ? in_s_ + step_s : 0;
  if (isFinite(last.pump_cc)) {
    const double rate = sinks   ? rateAt(last.pitch_rad)
                        : rises ? -rateAt(last.pitch_rad)
                                : kAdriftMps;
    metres_ += rate * step_s;
    metres_ = metres_ > 0 ? metres_ : 0;
  }
  if (isFinite(depth_m)) {
    seek(depth_m);
  }
}

/// Whether the depth has moved: down where the vehicle is driven down, else either way.
void UnseenSink::seek(double depth_m) {
  const double gained = depth_m - seen_m_;
  highest_m_ = depth_m < highest_m_ ? depth_m : highest_m_;
  const bool down = !(gained < kMovesM) || depth_m - highest_m_ >= kRegainsM;
  const bool up = gained <= -kMovesM && (!(in_s_ > 0) || out_s_ >= kLiftsSecs);
  // After a turn it rises on for a while, which is no sign of sinking.
  const bool turns = gained < 0 && in_s_ > 0 && in_s_ <= kTurnsSecs && !(out_s_ > 0);
  if (down || up) {
    metres_ = 0;
  }
  if (down || up || turns) {  // or it is the first of all
    seen_m_ = highest_m_ = depth_m;
  }
}

}  // namespace glider::hooks
