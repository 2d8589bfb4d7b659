// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/falsification/depth_limits.h"

#include "ir/prove/encoding/world.h"

#include <algorithm>

namespace glider::ir::prove {

DepthLimits::DepthLimits(const platforms::Platform& platform, double depth_m)
    : platform_(&platform),
      depth_(depth_m),
      deepest_(depth_m + platform.envelope.inflection_overshoot_m) {}

double DepthLimits::lowest(double from, double to) const {
  return std::max(0.0, depth_ - platform_->envelope.vertical_rate_m_s * (to - from));
}

double DepthLimits::highest(double from, double to) const {
  const double way = platform_->envelope.vertical_rate_m_s * (to - from);
  const double highest = anything_ ? depth_ + way : std::min(deepest_, depth_ + way);
  const double climbs = to - since_ - platform_->world.turn_s;
  if (anything_ || !climbing_ || climbs < 0) {
    return highest;
  }
  const double lifted = deepest_ - platform_->world.slowest_climb_m_s * climbs;
  return std::min(highest, std::max({top_, 0.0, lifted}));
}

void DepthLimits::obey(const CommandRun& command, double now) {
  switch (command.command) {
    case Command::Descend:
    case Command::Hover:
      downTo(command.arguments.at(0));
      break;
    case Command::Ascend:
      upTo(command.arguments.at(0), now);
      break;
    case Command::Surface:
      upTo(0, now);
      break;
    case Command::Steer:
    case Command::SteerTo:
    case Command::Drift:
      break;
  }
}

void DepthLimits::downTo(double target) {
  const double overshoot = platform_->envelope.inflection_overshoot_m;
  deepest_ = std::max(target + overshoot, std::min(deepest_, depth_ + overshoot));
  climbing_ = false;
  anything_ = false;
}

void DepthLimits::upTo(double target, double now) {
  const double overshoot = platform_->envelope.inflection_overshoot_m;
  const bool hovers = target >= kFloats;
  const double top = hovers ? target + overshoot : target;
  if (!climbing_ || top < top_) {
    deepest_ = std::min(deepest_, depth_ + overshoot);
    since_ = now;
  }
  climbing_ = true;
  top_ = top;
  deepest_ = hovers ? std::max(deepest_, top) : deepest_;
}

}  // namespace glider::ir::prove
