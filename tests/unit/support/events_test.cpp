// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/trace/events.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

namespace glider::support {
namespace {

struct Row {
  EventId id;
  const char* kind;
  std::string_view words;
};

constexpr auto kRows = std::to_array<Row>({
#define EVENT(name, kind, words) {EventId::name, kind, words},
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
    EXPECT_EQ(event.kind, row.kind);
    EXPECT_EQ(event.why, "because");
    EXPECT_EQ(event.id, row.id);
    EXPECT_EQ(event.values, values);
    EXPECT_EQ(event.what.find('{'), std::string::npos) << event.what;
    EXPECT_TRUE(seen.insert(row.words).second || row.words.starts_with("hookbeh: {} (m_depth") ||
                row.words == "{}")
        << row.words << " says two things";
  }
}

TEST(Events, AreWrittenAsTheyAreRead) {
  EXPECT_EQ(makeEvent(0, EventId::Transition, {"a", "b", "call"}).what, "a → b (call)");
  EXPECT_EQ(makeEvent(0, EventId::Steers, {"dive_to", 3.14}).what,
            "hookbeh: dive_to (m_depth 3.1 m)");
  EXPECT_EQ(makeEvent(0, EventId::FramesDamaged, {3.0}).what,
            "3 damaged frames on the serial lines");
  EXPECT_EQ(makeEvent(0, EventId::TimeIsOver, {14400.0}).what,
            "the simulated time of 14400 s is over");
  EXPECT_EQ(makeEvent(0, EventId::OperatorPuts, {"u_mission_mode", 2.5}).what,
            "put u_mission_mode 2.5");
  EXPECT_EQ(makeEvent(0, EventId::Note, {"{} stays"}).what, "{} stays");
}

TEST(EventsDeathTest, OneWithoutItsValuesIsABug) {
  EXPECT_DEATH(makeEvent(0, EventId::Transition, {"a", "b"}), "other values than its words");
}

}  // namespace
}  // namespace glider::support
