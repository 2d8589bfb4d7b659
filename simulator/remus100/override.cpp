// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/remus100/override.h"

#include "hooks/recon/codec.h"

#include <utility>

namespace glider::simulator::remus100 {

using namespace hooks::recon;

void Override::take(const Line& line, double now_s) {
  hooks::recon::Override request;
  HeadingGoal heading;
  SpeedGoal speed;
  DepthGoal depth;
  if (decode(line, request)) {
    if (!request.on && on_) {
      end(OverrideEnd::Released);
    } else if (request.on && !on_) {
      on_ = true;
      heard_s_ = now_s;
    }
  } else if (!on_) {
    return;
  } else if (decode(line, heading)) {
    heading_deg_ = heading.heading_deg;
  } else if (decode(line, speed) && speed.unit == SpeedUnit::MetresPerSecond) {
    speed_m_s_ = speed.value;
  } else if (decode(line, depth)) {
    depth_m_ = depth.depth_m;
    heard_s_ = now_s;
  }
}

void Override::look(double now_s) {
  if (on_ && now_s - heard_s_ > timeout_s_) {
    end(OverrideEnd::TimedOut);
  }
}

std::optional<Given> Override::given() const {
  if (!heading_deg_ || !speed_m_s_ || !depth_m_) {
    return std::nullopt;
  }
  return Given{*heading_deg_, *speed_m_s_, *depth_m_};
}

void Override::end(OverrideEnd how) {
  on_ = false;
  heading_deg_ = speed_m_s_ = depth_m_ = std::nullopt;
  ended_ = how;
}

std::optional<OverrideEnd> Override::takeEnd() {
  return std::exchange(ended_, std::nullopt);
}

}  // namespace glider::simulator::remus100
