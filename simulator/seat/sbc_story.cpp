// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/seat/sbc_story.h"

#include "simulator/seat/told.h"

namespace glider::simulator {

void SbcStory::take(std::string_view text) {
  constexpr std::string_view kState = "state,";
  if (!text.starts_with(kState)) {
    events_.push_back(toldIn(text, view_.mission_time_s));
    return;
  }
  text.remove_prefix(kState.size());
  uint32_t state = 0;
  double time_s = 0;
  if (readWhole(takePart(text, ','), state) && readReal(text, time_s)) {
    view_.known = true;
    view_.phase = state > 0 ? hooks::MissionPhase::Flying : hooks::MissionPhase::Waiting;
    view_.state = state > 0 ? state - 1 : 0;
    view_.mission_time_s = time_s;
  }
}

void SbcStory::look(double now_s) {
  constexpr double kSilence = 12;
  if (view_.known && now_s - heard_s_ > kSilence) {
    view_ = {};
  }
}

hooks::SeatEvent SbcStory::nextEvent() {
  if (events_.empty()) {
    return {};
  }
  const hooks::SeatEvent event = events_.front();
  events_.pop_front();
  return event;
}

}  // namespace glider::simulator
