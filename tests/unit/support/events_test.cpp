// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/trace/events.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace glider::support {
namespace {

struct Row {
  EventId id;
  EventKind kind;
  std::string_view words;
};

constexpr auto kRows = std::to_array<Row>({
#define EVENT(name, kind, words) {EventId::name, EventKind::kind, words},
#include "support/trace/events.def"
#undef EVENT
});

/// Values that fit the places of `words`: a number where a precision is asked for.
std::vector<EventValue> valuesFor(std::string_view words) {
  std::vector<EventValue> values;
  for (size_t at = words.find('{'); at != std::string_view::npos; at = words.find('{', at + 1)) {
    values.push_back(words[at + 1] == ':' ? EventValue(2.5) : EventValue("x"));
  }
  return values;
}

TEST(Events, EachHasItsKindItsWordsAndItsValues) {
  std::set<std::string_view> seen;
  for (const Row& row : kRows) {
    const std::vector<EventValue> values = valuesFor(row.words);
    const TraceEvent event = makeEvent(12, row.id, values, "because");
    EXPECT_EQ(event.time_s, 12);
    EXPECT_TRUE(std::isnan(event.mission_time_s));
    EXPECT_TRUE(isOfKind(event, row.kind)) << row.words;
    EXPECT_EQ(event.why, "because");
    EXPECT_EQ(event.id, row.id);
    EXPECT_EQ(event.values, values);
    EXPECT_EQ(textOf(event).find('{'), std::string::npos) << textOf(event);
    EXPECT_TRUE(seen.insert(row.words).second || row.words.starts_with("hookbeh: {} (m_depth") ||
                row.words == "{}")
        << row.words << " says two things";
  }
}

TEST(Events, AreWrittenAsTheyAreRead) {
  EXPECT_EQ(textOf(makeEvent(0, EventId::Transition, {"a", "b", "call"})), "a → b (call)");
  EXPECT_EQ(textOf(makeEvent(0, EventId::Steers, {"dive_to", 3.14})),
            "hookbeh: dive_to (m_depth 3.1 m)");
  EXPECT_EQ(textOf(makeEvent(0, EventId::FramesDamaged, {3.0})),
            "damaged frames on the serial lines: 3");
  EXPECT_EQ(textOf(makeEvent(0, EventId::TimeIsOver, {14400.0})),
            "the simulated time of 14400 s is over");
  EXPECT_EQ(textOf(makeEvent(0, EventId::OperatorPuts, {"u_mission_mode", 2.5})),
            "put u_mission_mode 2.5");
  EXPECT_EQ(textOf(makeEvent(0, EventId::Note, {"{} stays"})), "{} stays");
}

constexpr auto kKinds = std::to_array<std::pair<EventKind, const char*>>({
#define EVENT_KIND(name, word) {EventKind::name, word},
#include "support/trace/event_kinds.def"
#undef EVENT_KIND
});

TEST(Events, AreOfOneKindEach) {
  for (const Row& row : kRows) {
    const TraceEvent event = makeEvent(0, row.id, valuesFor(row.words));
    for (const auto& [kind, word] : kKinds) {
      EXPECT_EQ(isOfKind(event, kind), kind == row.kind) << row.words << ": " << word;
      EXPECT_EQ(kindOf(event) == word, kind == row.kind) << row.words << ": " << word;
    }
  }
}

TEST(Events, OfAFileKeepTheirKindAndTheirText) {
  const TraceEvent event = unlistedEvent(4, 2, "control", "a {} in a file", "because");
  EXPECT_EQ(event.time_s, 4);
  EXPECT_EQ(event.mission_time_s, 2);
  EXPECT_EQ(textOf(event), "a {} in a file");
  EXPECT_EQ(kindOf(event), "control");
  EXPECT_TRUE(isOfKind(event, EventKind::Control));
  EXPECT_FALSE(isOfKind(event, EventKind::Transition));
  EXPECT_EQ(event.why, "because");
  EXPECT_EQ(kindOf(unlistedEvent(4, 2, "of another version", "", "")), "of another version");
}

TEST(EventsDeathTest, OneWithoutItsValuesIsABug) {
  EXPECT_DEATH(makeEvent(0, EventId::Transition, {"a", "b"}), "other values than its words");
}

}  // namespace
}  // namespace glider::support
