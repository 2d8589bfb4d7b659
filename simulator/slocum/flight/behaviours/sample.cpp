// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/behaviours/sample.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace glider::simulator {

Sample::Sample(const BehaviourSource& source)
    : Behaviour(source.block.name),
      sensor_type_(source.code("sensor_type")),
      states_(source.argument("state_to_sample")),
      after_s_(source.argument("sample_time_after_state_change")),
      intersample_s_(source.argument("intersample_time")),
      nth_yo_(source.argument("nth_yo_to_sample")),
      intersample_m_(source.argument("intersample_depth")),
      least_depth_m_(source.argument("min_depth")),
      most_depth_m_(source.argument("max_depth")) {}

/// A yo begins with each dive; one that hovers on its way goes on.
void Sample::countYos(const Situation& s) {
  if (s.depth_state == DepthState::Hovering) {
    return;
  }
  const bool dives = s.depth_state == DepthState::Diving;
  yo_ += dives && !dives_ ? 1 : 0;
  dives_ = dives;
}

bool Sample::isInState(const Situation& s) const {
  int bit = 0;
  switch (s.depth_state) {
    case DepthState::Surface:
      bit = 8;
      break;
    case DepthState::Diving:
      bit = 1;
      break;
    case DepthState::Climbing:
      bit = 4;
      break;
    case DepthState::Hovering:
      bit = 2;
      break;
  }
  return (static_cast<int>(states_()) & bit) != 0;
}

/// 2 is the first yo and every second after it: 1, 3, 5. -2 leaves out the first: 2, 4, 6.
bool Sample::isYoToSample() const {
  const int nth = static_cast<int>(nth_yo_());
  const int every = std::max(1, std::abs(nth));
  return nth < 0 ? yo_ > 1 && yo_ % every == 0 : (yo_ - 1) % every == 0;
}

double Sample::period(const Situation& s) const {
  return intersample_m_() > 0 ? intersample_m_() / std::fabs(s.depth_rate_mps) : intersample_s_();
}

Behaviour::Outcome Sample::fly(const Situation& s, Commands& commands) {
  countYos(s);
  if (isInState(s) && isYoToSample()) {
    in_state_s_ = s.time_s;
  }
  const bool deep_enough = s.depth_m >= least_depth_m_() && s.depth_m <= most_depth_m_();
  const bool samples = deep_enough && s.time_s - in_state_s_ <= after_s_();
  commands.samples.push_back({sensor_type_, samples ? period(s) : -1});
  return Outcome::Continue;
}

}  // namespace glider::simulator
