// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/echo_floor.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// s; for so long after an echo the bottom stays where it was.
constexpr double kFreshSecs = 40;
/// s; for so long it may rise; after that an echo counts less and less.
constexpr double kLastsSecs = 1200;
/// s; an echo of so shallow a bottom that the vehicle cannot dive, and so cannot fly away, is
/// forgotten after this time: it may have been a bubble. Below, in m: so shallow.
constexpr double kBubbleSecs = 600;
constexpr double kEchoShallowM = 12;
/// m/s; a bottom may rise so fast below a vehicle even if it has not done so yet: a slope of one in
/// six.
constexpr double kRiseMps = 0.05;
constexpr double kEchoSteeper = 1.5;
constexpr double kMostRiseMps = 0.3;
/// s; between echoes that are compared.
constexpr double kAnchorSecs = 60;
constexpr double kAnchorLastsSecs = 300;
/// This many times the usual gap without an echo: then it is sure that no bottom is within range.
/// One gap in 20,000 is longer, if echoes come at random.
constexpr double kSure = 10;
// Weight of the newest gap, if it is longer and if it is shorter: some short ones in a row may come
// by chance, and silence must not show deep water sooner for that.
constexpr double kLongerShare = 0.25, kShorterShare = 0.1;
constexpr double kMostGap = 40;
/// Cycles; an altimeter with shorter gaps receives an echo in most of them.
constexpr double kDenseGap = 4;
/// Shares of its range: nearer than this an echo is sure to be received; an echo from nearer than
/// this is not followed by silence.
constexpr double kSureShare = 0.9;
constexpr double kWithinShare = 0.6;
constexpr double kFailedCycles = 10;
/// Echoes; so many are those of a bottom. Fewer may be those of fish.
constexpr double kMany = 30;
/// m; a vehicle that is so much deeper has sunk.
constexpr double kEchoSinksM = 0.5;
/// m; above this depth the altimeter is not used.
constexpr double kListensM = 3;
/// The floor falls to this share of the last echo's depth at most.
constexpr double kLeastShare = 0.5;
/// m/s; an old echo is approached again this slowly, and only while the altimeter is used: at the
/// surface the floor sinks no deeper than a vehicle needs to use it.
constexpr double kEasesMps = 0.05;

}  // namespace

void EchoFloor::observe(double depth_m, double altitude_m, double least_m, double step_s) {
  silent_s_ += step_s;
  anchor_s_ += step_s;
  // The sensor array keeps an old altitude while the altimeter receives no echo, so only a changed
  // altitude is an echo. Between echoes the clearance follows from the depth, which also catches an
  // altimeter that is stuck.
  const bool is_new = altitude_m >= 0 && isFinite(altitude_m) && altitude_m != seen_m_;
  seen_m_ = is_new ? altitude_m : seen_m_;
  heard_ = is_new && isFinite(depth_m);
  if (heard_) {
    hear(depth_m, altitude_m);
  } else if (isFinite(depth_m)) {
    wait(depth_m, least_m, step_s);
  }
}

void EchoFloor::hear(double depth_m, double altitude_m) {
  altitude_m_ = altitude_m;
  bottom_m_ = floor_m_ = depth_m + altitude_m;
  reach_m_ = atLeast(altitude_m, reach_m_);
  // A gap over a bottom out of range says nothing about the altimeter, unless the bottom is one
  // that silence seemed to have ruled out.
  if (!(bottom_m_ >= cleared_m_)) {
    const double gap = atMost(missed_ + 1, kMostGap);
    gap_ += (gap - gap_) * (gap > gap_ ? kLongerShare : kShorterShare);
  }
  missed_ = listened_ = 0;
  echoes_ += 1;
  cleared_m_ = kBottomless;
  heard_at_m_ = depth_m;
  silent_s_ = 0;
  learnRise(bottom_m_);
}

void EchoFloor::learnRise(double bottom_m) {
  if (anchor_s_ < kAnchorSecs) {
    return;
  }
  if (anchor_s_ <= kAnchorLastsSecs) {
    const double rise = between((anchor_m_ - bottom_m) / anchor_s_, 0, kMostRiseMps);
    rise_mps_ = atLeast(rise, (rise_mps_ + rise) / 2);
  }
  anchor_m_ = bottom_m;
  anchor_s_ = 0;
}

/// A bottom above this depth would have returned an echo, m.
double EchoFloor::beyond(double depth_m) const {
  return depth_m + kSureShare * reach_m_;
}

/// Silence for many times the usual gap shows that no bottom is within range of the least depth of
/// that time.
void EchoFloor::listen(double depth_m) {
  least_m_ = listened_ == 0 ? depth_m : atMost(depth_m, least_m_);
  listened_ += 1;
  if (listened_ >= kSure * gap_ && !hasFailed()) {
    cleared_m_ = beyond(least_m_);
    floor_m_ = atLeast(floor_m_, cleared_m_);
    listened_ = echoes_ = 0;
  }
}

bool EchoFloor::hasFailed() const {
  const bool within = sank_ || altitude_m_ < kWithinShare * reach_m_;
  return gap_ < kDenseGap && echoes_ >= kMany && within && missed_ >= kFailedCycles;
}

void EchoFloor::wait(double depth_m, double least_m, double step_s) {
  if (!(floor_m_ < kBottomless)) {
    return;
  }
  const bool listens = depth_m > kListensM;
  if (listens && bottom_m_ <= beyond(depth_m)) {
    missed_ += 1;
  }
  if (silent_s_ <= kFreshSecs) {
    sank_ = depth_m > heard_at_m_ + kEchoSinksM;
    return;
  }
  if (silent_s_ > kLastsSecs) {
    floor_m_ += listens || floor_m_ < least_m ? kEasesMps * step_s : 0;
  } else if (listens) {
    floor_m_ -= (kRiseMps + kEchoSteeper * rise_mps_) * step_s;
  }
  floor_m_ = atLeast(floor_m_, kLeastShare * bottom_m_);
  if (listens) {
    listen(depth_m);
  }
  if (silent_s_ > kBubbleSecs && bottom_m_ <= kEchoShallowM) {
    floor_m_ = kBottomless;
  }
}

}  // namespace glider::hooks
