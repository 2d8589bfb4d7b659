// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/heard_missions.h"

#include <utility>

namespace glider::flights {
namespace {

/// The newest tick at this mission time.
std::optional<size_t> tickAt(const HeardMission& mission, double time) {
  for (size_t i = mission.ticks.size(); i-- > 0;) {
    if (mission.ticks[i].heard.mission_time == time) {
      return i;
    }
  }
  return std::nullopt;
}

}  // namespace

void HeardMissions::starts(std::optional<double> kept) {
  kept_ = kept;
  last_.reset();
}

void HeardMissions::look(const GliderContext& context, double now_s) {
  const double time = context.mission_time;
  if (last_) {
    if (time > *last_) {
      add(context, now_s, missions_.back().ticks.size() - 1, false);
    }
  } else if (time == 0) {
    missions_.emplace_back();
    add(context, now_s, std::nullopt, false);
  } else if (kept_ && time > *kept_) {
    resume(context, now_s);
  }
}

/// The checkpoint is usually of the newest mission; that of an earlier one can be the newest whole
/// one on a damaged card.
void HeardMissions::resume(const GliderContext& context, double now_s) {
  for (size_t i = missions_.size(); i-- > 0;) {
    if (const auto before = tickAt(missions_[i], *kept_)) {
      if (i + 1 < missions_.size()) {
        std::swap(missions_[i], missions_.back());
      }
      add(context, now_s, before, true);
      return;
    }
  }
}

void HeardMissions::add(const GliderContext& context, double now_s, std::optional<size_t> before,
                        bool resumed) {
  last_ = context.mission_time;
  missions_.back().ticks.push_back(
      {{context.mission_time, now_s, frameOf(m_, context)}, before, resumed});
}

}  // namespace glider::flights
