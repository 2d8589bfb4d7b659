// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/messages.h"
#include "hooks/protocol/nap.h"
#include "hooks/protocol/sensor_list.h"
#include "hooks/protocol/tick.h"
#include "tests/slocum.h"

#include <string>
#include <utility>
#include <vector>

namespace glider::hooks {

/// What the example Subscribe asks for.
inline Subscribe exampleSubscription() {
  return {3, {{GLIDER_M_DEPTH, 1, 0.0F}, {GLIDER_M_LAT, 1, 0.0F}, {GLIDER_M_BATTERY, 15, 0.25F}}};
}

/// What the example Tick reports about these.
inline TickReadings exampleReadings() {
  return {{ReadingReport::Value, ReadingReport::Unchanged, ReadingReport::Nothing}, {12.5}};
}

/// The frames that hooks/protocol/README.md shows.
inline std::vector<std::pair<std::string, Frame>> exampleFrames() {
  std::vector<std::pair<std::string, Frame>> examples;
  auto add = [&](const char* name, uint8_t sequence, auto&& fill) {
    Frame frame;
    fill(frame);
    frame.sequence = sequence;
    examples.emplace_back(name, frame);
  };
  add("Beacon", 1, [](Frame& f) {
    const Features all{kAllFeatures, kAllFeatures};
    encode(Beacon{kProtocolVersion, all, 0x12345678, HookState::Ready}, f);
  });
  add("Welcome", 2, [](Frame& f) { encode(Welcome{true, 7, 6}, f); });
  add("Tick", 3, [](Frame& f) {
    TickHead head;
    head.virtual_time = true;
    head.link = 7;
    head.vehicle_time_s = 264;
    head.cycle = 66;
    head.subscription = subscriptionCheck(exampleSubscription());
    head.hook_state = HookState::Active;
    head.answer = HookAnswer::Accepted;
    head.answered_sequence = 258;
    head.session = 7;
    encode(head, exampleSubscription(), exampleReadings(), f);
  });
  add("Hello", 1, [](Frame& f) {
    Hello hello;
    hello.dictionary = 0x12345678;
    hello.link = 7;
    for (int i = 0; i < 6; ++i) {
      hello.mission_name[i] = "survey"[i];
    }
    encode(hello, f);
  });
  add("Subscribe", 2, [](Frame& f) { encode(exampleSubscription(), f); });
  add("Write", 3, [](Frame& f) {
    encodeEmptyList(f);
    (void)appendValue(f, {GLIDER_SCI_HOOK_CONTROL, 2});
    (void)appendValue(f, {GLIDER_SCI_HOOK_DEPTH, 20});
    (void)appendValue(f, {GLIDER_SCI_HOOK_SEQUENCE, 258});
  });
  add("Transition", 4, [](Frame& f) { encode(TransitionNotice{500, 1, 0, 1, 1, 0}, f); });
  add("Done", 5, [](Frame& f) { encode(Done{3, 7, {500, 1, 1, MissionPhase::Flying}}, f); });
  add("Note", 7, [](Frame& f) {
    MissionNote note;
    note.mission_time_s = 500;
    for (int i = 0; i < 13; ++i) {
      note.text[i] = "met it at 12 "[i];
    }
    encode(note, f);
  });
  add("Nap", 8, [](Frame& f) {
    Nap nap{60, 600, 2, {}};
    nap.conditions[0] = {GLIDER_M_DEPTH, NapKind::AtLeast, 20};
    nap.conditions[1] = {GLIDER_M_LAT, NapKind::Known, 0};
    encode(nap, f);
  });
  return examples;
}

}  // namespace glider::hooks
