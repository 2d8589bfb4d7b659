// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/library/tracker.h"

#include "runtime/numbers/numbers.h"

namespace glider::runtime {
namespace {

double within(double x, double low, double high) {
  return x < low ? low : high < x ? high : x;
}

}  // namespace

void ThermoclineTracker::start(double time) {
  leg_began_ = time;
  middle_ = 0.0;
  centre_ = 0.0;
  candidate_ = unknown();
  outlier_ = unknown();
  tracking_ = 0;
  met_ = 0;
  met_before_ = 0;
  reserved_ = 0;
  column_.clear();
}

void ThermoclineTracker::beginLeg(double time) {
  if (met_ == 0 && met_before_ == 0) {
    tracking_ = 0;
  }
  leg_began_ = time;
  met_before_ = met_;
  met_ = 0;
  candidate_ = outlier_;
  outlier_ = unknown();
}

void ThermoclineTracker::record(double time, double depth, double temperature,
                                const ThermoclineWanted& wanted) {
  column_.record(time, depth, temperature);
  // Only this leg's readings: a bin of the last one may be from before the wave moved on.
  const double oldest = time - WaterColumn::kGreatestAge;
  const double since = leg_began_ < oldest ? oldest : leg_began_;
  const Stretch stretch = column_.steepest(wanted.ddepth, since);
  const bool meets = stretch.difference > 0.0 && stretch.difference >= wanted.dtemp;
  if (meets) {
    met_ = 1;
    middle_ = stretch.middle;
  }
  if (meets || tracking_ != 0) {
    const Crossing crossing = column_.crossing(middle_, since);
    if (crossing.found) {
      follow(crossing, kHalfWindow * wanted.ddepth);
    }
  }
}

/// Moves the window to a crossing. While tracking, one further than `reach` from the centre, or
/// steeper than water is, must be met by two legs in turn: old water that is flushed out of the CTD
/// at once looks like a thermocline where there is none.
void ThermoclineTracker::follow(const Crossing& crossing, double reach) {
  const bool expected =
      magnitude(crossing.depth - centre_) <= reach && crossing.steepness <= kSteepest;
  const bool confirmed = magnitude(crossing.depth - candidate_) <= reach;
  if (tracking_ == 0 || expected || confirmed) {
    if (tracking_ == 0 || magnitude(crossing.depth - centre_) >= kLeastMove) {
      centre_ = crossing.depth;
    }
    tracking_ = 1;
    outlier_ = unknown();
  } else {
    outlier_ = crossing.depth;
  }
}

YoRange ThermoclineTracker::window(const YoRange& full, const ThermoclineWanted& wanted) const {
  if (tracking_ == 0) {
    return full;
  }
  const double half = kHalfWindow * wanted.ddepth;
  const double middle = within(centre_, full.top, full.bottom);
  YoRange part = full;
  part.top = within(middle - half, full.top, full.bottom);
  part.bottom = within(middle + half, full.top, full.bottom);
  return part;
}

}  // namespace glider::runtime
