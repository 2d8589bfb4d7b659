// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

/// What the checks of a flight allow, each number with its reason. scenarios/README.md has the same
/// as a table (judge_table.h), which a test compares with these.
namespace glider::slocum::oracles::limits {

// Depth, while the flight controller is down: the motors stay at their last commands.
/// m/s at 45 degrees, the steepest pitch; in proportion at smaller ones, but never less than at 17
/// degrees. A dive at 45 degrees sinks at 0.41 m/s in the simulator.
inline constexpr double kSinkMps = 0.44;
inline constexpr double kSinkPitch = 0.7854, kFlattestPitch = 0.297;  // rad
/// m/s; a vehicle that is driven neither up nor down, and is a little heavy.
inline constexpr double kLevelSinkMps = 0.1;
/// m; how far it sinks on while the pump is reversed: at 45 degrees 5.2 m in the simulator, and up
/// to a cycle passes before that.
inline constexpr double kTurnM = 7;

// Bottom.
/// m; the vehicle touches the bottom.
inline constexpr double kTouchM = 0.05;
/// m and m; the contacts in this radius are of one place, over a bottom that rises by no more:
/// so far hookbeh counts on a bottom that it has touched (hooks/hookbeh/README.md).
inline constexpr double kPlaceM = 3000, kRiseM = 4;
/// s; a contact must last so long to be known: hookbeh takes a dive that gains no depth for 24 s
/// for one, and a vehicle that turns needs up to 20 s to leave the bottom. Below: so many shorter
/// ones at one place may come.
inline constexpr double kNoticedSecs = 48;
inline constexpr int kShortTouches = 3;
/// m and s; a vehicle cannot dive, and so not fly away, over a bottom as shallow as that, or as its
/// least altitude and the second: hookbeh forgets it after this time.
inline constexpr double kShallowM = 12, kOverShallowM = 8, kShallowSecs = 1800;
/// Whether water of that depth is as shallow, m.
inline bool isShallow(double water_m, double least_altitude_m) {
  return water_m <= kShallowM || water_m <= least_altitude_m + kOverShallowM;
}
/// Echoes, and s between them on average; an altimeter whose echoes are rarer shows the bottom only
/// after so many of them. In a dive of 130 s through its range it may receive none at all.
inline constexpr int kEchoesToKnow = 3;
/// Times the usual gap; after so long a silence under water hookbeh believes that there is no
/// bottom within range. One gap in 3,000 is longer.
inline constexpr double kSilentGaps = 8;
/// s; so long after an echo hookbeh approaches the bottom again, little by little.
inline constexpr double kEchoLastsSecs = 1200;
inline constexpr double kRareEchoSecs = 20;
/// s; a dive on the bottom ends: hookbeh allows 180 s without a metre gained, as long again when
/// the vehicle slides, and the turn takes 120 s.
inline constexpr double kOnBottomSecs = 600;
/// s from echo to echo, on average, of an altimeter that gets echoes: 5 % of the cycles of 4 s.
/// Real logs have 4 to 5 %.
inline constexpr double kEchoEverySecs = 80;
/// s; so long after a fault of the altimeter what it reported may still count.
inline constexpr double kEchoFadesSecs = 600;

// Position.
/// m; the altimeter works from 2 m below the surface and 2 m above the bottom: in shallower water
/// no dive can be guarded.
inline constexpr double kShoreM = 4;
/// m/s; how much faster than the current a vehicle may drift at the surface: in the simulator
/// nothing else moves it there.
inline constexpr double kDriftMps = 0.1;
/// s; over this time speeds are measured.
inline constexpr double kSpeedSecs = 60;

// Surface.
/// s; so long a vehicle may stay at the surface although a depth is commanded and its readings are
/// right: three times the longest wait of a guard (600 s).
inline constexpr double kAtSurfaceSecs = 1800;
/// s; so long the readings must have been right: hookbeh believes them again after two minutes of
/// climbing and one without a fault, and its guard 7 waits 600 s.
inline constexpr double kRightSecs = 900;
/// s; so long the SBC must have had the motors: one that loses control every half minute gets no
/// vehicle under water.
inline constexpr double kTakesHoldSecs = 120;
/// Of the time under a commanded depth, in missions of at least kLongSecs.
inline constexpr double kSurfaceShare = 0.5, kLongSecs = 7200;

// Needless guards.
/// One climb an hour costs a twentieth of the endurance: a full stroke of the pump takes 0.5 kJ of
/// the 11 kJ that a vehicle uses in an hour. Two more: a fault begins and ends.
inline constexpr double kNeedlessAnHour = 1, kNeedlessMore = 2;
/// Of the time in control, and s more: one wait of guard 7.
inline constexpr double kNeedlessShare = 0.1, kNeedlessSecs = 900;

// Pump.
/// Full strokes (of the whole range, in or out) an hour, lasting: a stroke takes 12.4 s, so the
/// pump rests for two thirds of the time. A yo over 8 m at 45 degrees needs as many.
inline constexpr double kStrokesAnHour = 90;
/// Strokes at once, before the rate counts: 40 minutes of the steepest shallow yo.
inline constexpr double kStrokesMore = 60;
/// W of the pump, lasting, and J more: four times that of a yo to 40 m at 26 degrees (1.9 W), so a
/// pack of 8 MJ lasts ten days.
inline constexpr double kPumpW = 8, kPumpMoreJ = 40000;

}  // namespace glider::slocum::oracles::limits
