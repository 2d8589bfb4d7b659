// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the SBC writes of its mission into the log of a LAUV, and what the simulator reads there.

#include "simulator/seat/told.h"

#include "runtime/front_seat/story.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

namespace glider::simulator {
namespace {

using hooks::SeatEvent;

SeatEvent eventOf(SeatEvent::Kind kind, const std::string& text = "") {
  SeatEvent event;
  event.kind = kind;
  event.mission_time_s = 1234.5;
  event.a = 1;
  event.b = 20;
  event.c = 4294967295U;
  event.d = 0;
  event.e = 7;
  text.copy(event.text, sizeof event.text - 1);
  return event;
}
SeatEvent readBack(const SeatEvent& event) {
  char text[runtime::kMostStory];
  const uint32_t size = runtime::storyOf(event, text);
  EXPECT_GT(size, 0U);
  EXPECT_LE(size, runtime::kMostStory);
  return toldIn({text, size}, 99);
}

TEST(Told, ATransitionIsReadAsItWasWritten) {
  const SeatEvent event = eventOf(SeatEvent::Kind::SbcTransition);
  const SeatEvent read = readBack(event);
  EXPECT_EQ(read.kind, event.kind);
  EXPECT_EQ(read.mission_time_s, event.mission_time_s);
  EXPECT_EQ(read.a, event.a);
  EXPECT_EQ(read.b, event.b);
  EXPECT_EQ(read.c, event.c);
  EXPECT_EQ(read.d, event.d);
  EXPECT_EQ(read.e, event.e);
}

TEST(Told, NamesAndNotesAreReadAsTheyWereWritten) {
  for (const std::string& text :
       {std::string("survey"), std::string("a, b,,c"), std::string(47, 'n')}) {
    const SeatEvent read = readBack(eventOf(SeatEvent::Kind::SbcHello, text));
    EXPECT_EQ(read.kind, SeatEvent::Kind::SbcHello);
    EXPECT_EQ(read.text, text);
  }
  for (const std::string& text :
       {std::string("a, b,,c"), std::string("note,1,2,x"), std::string(60, 'n')}) {
    const SeatEvent read = readBack(eventOf(SeatEvent::Kind::SbcNote, text));
    EXPECT_EQ(read.kind, SeatEvent::Kind::SbcNote);
    EXPECT_EQ(read.mission_time_s, 1234.5);
    EXPECT_EQ(read.a, 1U);
    EXPECT_EQ(read.text, text);
  }
}

TEST(Told, AnythingElseIsANoteOfNow) {
  for (const char* text :
       {"", "hello", "transition", "transition,5", "transition,5,1,2,3,4", "transition,x,1,2,3,4,5",
        "transition,5,1,2,3,4,-5", "transition,5,1,2,3,4,99999999999", "note,5,x,text", "note"}) {
    const SeatEvent event = toldIn(text, 99);
    EXPECT_EQ(event.kind, SeatEvent::Kind::SbcNote) << text;
    EXPECT_EQ(event.mission_time_s, 99) << text;
    EXPECT_EQ(event.a, 0U) << text;
    EXPECT_STREQ(event.text, text);
  }
  EXPECT_EQ(std::strlen(toldIn(std::string(500, 'x'), 1).text), 60U);
  EXPECT_EQ(std::strlen(toldIn("mission," + std::string(500, 'x'), 1).text), 47U);
}

TEST(Told, EventsOfTheVehicleAreNotForItsLog) {
  char text[runtime::kMostStory];
  EXPECT_EQ(runtime::storyOf(eventOf(SeatEvent::Kind::None), text), 0U);
}

}  // namespace
}  // namespace glider::simulator
