// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is read out of a mission log: each number of each record; unreadable records are counted.

#include "logs/reader.h"

#include "logs/render.h"
#include "tests/unit/logs/written_log.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <limits>

namespace glider::logs {
namespace {

using runtime::LogNamed;
using runtime::LogRecord;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;
using testing::WrittenLog;
using Record = WrittenLog::Record;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

class ReadLog : public ::testing::Test {
 protected:
  ReadLog() { log_.start(); }

  std::vector<LogEntry> read() {
    std::vector<LogEntry> entries;
    damage_ = readLog(log_.bytes, [&](const LogEntry& entry) { entries.push_back(entry); });
    return entries;
  }
  /// The entry of the one record behind the head.
  LogEntry only() {
    const auto entries = read();
    EXPECT_EQ(entries.size(), 2U);
    EXPECT_EQ(damage_.unreadable, 0U);
    return entries.empty() ? LogEntry() : entries.back();
  }
  void expectDamage(uint32_t bad, uint32_t missing, uint32_t unreadable) {
    EXPECT_EQ(damage_.bad, bad);
    EXPECT_EQ(damage_.missing, missing);
    EXPECT_EQ(damage_.unreadable, unreadable);
  }
  /// `record` counts as one that makes no sense, and nothing of it is handed on.
  void expectUnreadable(const std::string& payload) {
    log_ = {};
    log_.start();
    log_.add(payload);
    log_.event(7);
    EXPECT_EQ(read().size(), 2U);
    expectDamage(0, 0, 1);
    EXPECT_EQ(damage_.records, 2U);
  }

  WrittenLog log_;
  LogDamage damage_;
};

TEST_F(ReadLog, AStartNamesTheMission) {
  const auto entries = read();
  ASSERT_EQ(entries.size(), 1U);
  EXPECT_EQ(entries[0].kind, LogRecord::Start);
  EXPECT_EQ(entries[0].name, "bench");
  EXPECT_EQ(entries[0].time, 0);
  EXPECT_EQ(damage_.starts, 1U);
  EXPECT_EQ(damage_.records, 1U);
  expectDamage(0, 0, 0);
}

TEST_F(ReadLog, ABeginHasTheParametersByTheirNames) {
  log_.name(LogNamed::Parameter, 0, 0, "bottom");
  log_.name(LogNamed::Parameter, 1, 0, "");
  log_.add(Record(LogRecord::Begin).f64(25.5).f64(-3).f64(1e300));
  const LogEntry entry = only();
  EXPECT_EQ(entry.kind, LogRecord::Begin);
  EXPECT_THAT(entry.values, ElementsAre(Pair("bottom", 25.5), Pair("", -3), Pair("?2", 1e300)));
  EXPECT_EQ(damage_.records, 4U) << "names count too";
}

TEST_F(ReadLog, ABeginMayHaveNoParameters) {
  log_.add(Record(LogRecord::Begin));
  EXPECT_THAT(only().values, IsEmpty());
}

TEST_F(ReadLog, ValuesAreTheItemsOfTheirState) {
  log_.name(LogNamed::Item, 1, 0, "depth");
  log_.name(LogNamed::Item, 1, 2, "temp");
  log_.name(LogNamed::Item, 2, 0, "another state's");
  log_.add(
      Record(LogRecord::Values).f64(12.25).u16(1).u8(0).f64(9.5).u8(2).f64(kUnknown).u8(3).f64(1));
  const LogEntry entry = only();
  EXPECT_EQ(entry.kind, LogRecord::Values);
  EXPECT_EQ(entry.time, 12.25);
  ASSERT_EQ(entry.values.size(), 3U);
  EXPECT_THAT(entry.values[0], Pair("depth", 9.5));
  EXPECT_EQ(entry.values[1].first, "temp");
  EXPECT_TRUE(std::isnan(entry.values[1].second));
  EXPECT_THAT(entry.values[2], Pair("?3", 1)) << "no name: by its number in the state";
}

/// A transition of case `number`, from 0, in list `list`.
Record transition(uint8_t transition, uint8_t list, uint16_t number, uint16_t from, uint16_t to) {
  return Record(LogRecord::Transition)
      .f64(100)
      .f64(40)
      .f64(30)
      .u8(transition)
      .u8(list)
      .u16(number)
      .u16(from)
      .u16(to);
}

TEST_F(ReadLog, ATransitionSaysWhatFiredAndOnWhichReadings) {
  log_.name(LogNamed::State, 3, 0, "survey");
  log_.name(LogNamed::State, 300, 0, "home");
  log_.name(LogNamed::Sensor, 1, 0, "m_depth");
  log_.add(transition(1, 1, 4, 3, 300).f64(0.5).f64(17));
  const LogEntry entry = only();
  EXPECT_EQ(entry.kind, LogRecord::Transition);
  EXPECT_EQ(entry.time, 100);
  EXPECT_EQ(entry.name, "call");
  EXPECT_EQ(entry.number, 5U) << "cases count from 1";
  EXPECT_EQ(entry.detail, "survey");
  EXPECT_EQ(entry.to, "home");
  EXPECT_THAT(entry.values, ElementsAre(Pair("statetime", 40), Pair("resumetime", 30),
                                        Pair("?0", 0.5), Pair("m_depth", 17)));
}

TEST_F(ReadLog, EveryTransitionHasItsWordAndThoseOfAlwaysAreMarked) {
  const char* const words[] = {"goto", "call", "return", "exit", "stay", "done", "?"};
  for (uint8_t kind = 0; kind < 7; ++kind) {
    for (uint8_t list = 0; list < 4; ++list) {
      log_ = {};
      log_.start();
      log_.add(transition(kind, list, 0, 0, 1));
      const LogEntry entry = only();
      EXPECT_EQ(entry.name, (list == 0 ? "always " : "") + std::string(words[kind]));
      EXPECT_EQ(entry.to, kind == 3 ? "" : "?1") << "behind an exit there is no state";
      EXPECT_EQ(entry.detail, "?0");
    }
  }
}

TEST_F(ReadLog, ANoteHasItsTextBehindItsValues) {
  log_.add(Record(LogRecord::Note).f64(8).u8(0).u8(2).f64(1.5).f64(kUnknown).text("warm, here"));
  const LogEntry entry = only();
  EXPECT_EQ(entry.kind, LogRecord::Note);
  EXPECT_EQ(entry.time, 8);
  EXPECT_FALSE(entry.unknown_set);
  EXPECT_EQ(entry.name, "warm, here");
  ASSERT_EQ(entry.values.size(), 2U);
  EXPECT_THAT(entry.values[0], Pair("", 1.5));
  EXPECT_TRUE(std::isnan(entry.values[1].second));
}

TEST_F(ReadLog, ANoteMayReportASetThatWasUnknown) {
  log_.add(Record(LogRecord::Note).f64(8).u8(1).u8(0).text("count"));
  EXPECT_TRUE(only().unknown_set);
  EXPECT_EQ(only().name, "count");
  EXPECT_THAT(only().values, IsEmpty());
}

TEST_F(ReadLog, AnEventHasItsWordsAndItsNumber) {
  log_.event(16, 2, 3, 41);
  const LogEntry entry = only();
  EXPECT_EQ(entry.kind, LogRecord::Event);
  EXPECT_EQ(entry.time, 16);
  EXPECT_EQ(entry.name, "instruction refused");
  EXPECT_EQ(entry.detail, "too deep");
  EXPECT_EQ(entry.value, 41);
}

TEST_F(ReadLog, TheValueOfAnEventHasItsUnitAndIsInTheSingularAfterOne) {
  const struct {
    uint8_t event, detail;
    double value;
    const char* line;
  } rows[] = {
      {16, 0, 1, "damaged input on the line (1 time)\n"},
      {16, 0, 3, "damaged input on the line (3 times)\n"},
      {9, 0, 1, "notes lost (1 note)\n"},
      {15, 64, 2, "(2 failed checks)\n"},
      {14, 0, 12.25, "mission waits for the surface (12.25 m deep)\n"},
      {10, 0, 35, "mission resumed (after an outage of 35 s)\n"},
      {2, 3, 41, "instruction refused: too deep (number 41)\n"},
      {17, 27, 60,
       "surface commanded before the mission begins: an earlier program may have left targets "
       "(for 60 s)\n"},
      {18, 28, 3, "request refused by the vehicle: start of the plan (3 times)\n"},
      {18, 29, 1, "request refused by the vehicle: end of the plan (1 time)\n"},
      {19, 0, 1, "error in the vehicle's plan (1 time)\n"},
      {20, 30, 10, "request without effect on the vehicle: override (10 times)\n"},
      {20, 31, 10, "request without effect on the vehicle: end of the override (10 times)\n"},
      {200, 0, 5, "event 200 (5)\n"},
  };
  for (const auto& row : rows) {
    WrittenLog log;
    log.start();
    log.event(4, row.event, row.detail, row.value);
    std::string text;
    readLog(log.bytes, [&](const LogEntry& entry) { text = textLine(entry); });
    EXPECT_TRUE(text.ends_with(row.line)) << text;
  }
}

TEST_F(ReadLog, EventsOfALaterProgramAreShownByTheirNumber) {
  log_.event(1, 200, 201);
  EXPECT_EQ(only().name, "event 200");
  EXPECT_EQ(only().detail, "detail 201");
}

TEST_F(ReadLog, NamesAreThoseOfTheNewestProgram) {
  log_.name(LogNamed::State, 0, 0, "old");
  log_.start("next");
  log_.add(transition(0, 1, 0, 0, 1));
  log_.name(LogNamed::State, 0, 0, "new");
  log_.add(transition(0, 1, 0, 0, 1));
  const auto entries = read();
  ASSERT_EQ(entries.size(), 4U);
  EXPECT_EQ(entries[1].name, "next");
  EXPECT_EQ(entries[2].detail, "?0");
  EXPECT_EQ(entries[3].detail, "new");
  EXPECT_EQ(damage_.starts, 2U);
}

TEST_F(ReadLog, GapsInTheNumbersAreCountedRoundTheirEnd) {
  log_.sequence = 250;
  log_.event(1);
  log_.event(2);
  read();
  expectDamage(0, 249, 0);
  log_ = {};
  log_.sequence = 253;
  log_.start();
  log_.event(1);
  log_.sequence = 2;  // 255, 0 and 1 are gone
  log_.event(2);
  EXPECT_EQ(read().size(), 3U);
  expectDamage(0, 3, 0);
}

TEST_F(ReadLog, AStartRestartsTheNumbers) {
  log_.event(1);
  log_.sequence = 77;
  log_.start();
  log_.event(2);
  EXPECT_EQ(read().size(), 4U);
  expectDamage(0, 0, 0);
}

TEST_F(ReadLog, WhatIsTornIsPassedOverAndCounted) {
  log_.event(1);
  const std::string before = log_.bytes;
  log_.event(2);
  const std::string whole = log_.bytes;
  log_.bytes = whole.substr(0, whole.size() - 1);
  EXPECT_EQ(read().size(), 2U) << "the last byte is lacking";
  expectDamage(1, 0, 0);
  log_.bytes = before;
  read();
  expectDamage(0, 0, 0);
  std::string damaged = whole;
  damaged[before.size() + 5] ^= 2;
  log_.bytes = damaged;
  log_.event(3);
  EXPECT_EQ(read().size(), 3U);
  expectDamage(1, 1, 0);
}

TEST_F(ReadLog, OfNothingThereIsNothing) {
  log_.bytes.clear();
  EXPECT_THAT(read(), IsEmpty());
  expectDamage(0, 0, 0);
  EXPECT_EQ(damage_.starts + damage_.records, 0U);
  log_.bytes = "x";
  EXPECT_THAT(read(), IsEmpty());
  expectDamage(1, 0, 0);
}

TEST_F(ReadLog, AFrameThatIsNotARecordIsUnreadable) {
  log_.add("\x05", hooks::MessageType::Note);
  read();
  expectDamage(0, 0, 1);
  EXPECT_EQ(damage_.records, 1U);
}

// Whole frames with the right check, whose content is too short or too long for what they say.
TEST_F(ReadLog, RecordsThatMakeNoSenseAreCountedAndNotHandedOn) {
  expectUnreadable("");
  expectUnreadable("\x09more");
  const auto cut = [](const Record& record) {
    return record.payload().substr(0, record.payload().size() - 1);
  };
  const Record begin = Record(LogRecord::Begin).f64(1);
  const Record values = Record(LogRecord::Values).f64(1).u16(0).u8(0).f64(2);
  const Record event = Record(LogRecord::Event).f64(1).u8(5).u8(0).f64(1);
  const Record moved = transition(0, 1, 0, 0, 1).f64(4);
  for (const Record& record : {begin, values, event, moved}) {
    expectUnreadable(cut(record));
    expectUnreadable(record.payload() + "x");
  }
  expectUnreadable(cut(transition(0, 1, 0, 0, 1)));
  expectUnreadable(cut(Record(LogRecord::Note).f64(1).u8(0).u8(2).f64(1).f64(2)));
  expectUnreadable(cut(Record(LogRecord::Name).u8(0).u16(0).u16(0)));
}

TEST_F(ReadLog, OfAnotherVersionNothingIsRead) {
  log_.start("later", 2);
  log_.event(1);
  log_.name(LogNamed::State, 0, 0, "s");
  EXPECT_EQ(read().size(), 1U);
  expectDamage(0, 0, 3);
  EXPECT_EQ(damage_.starts, 2U);
  log_.start("again");
  log_.event(2);
  EXPECT_EQ(read().size(), 3U) << "until the program is one of this version";
}

TEST_F(ReadLog, AHeadThatIsCutShortIsOfNoVersion) {
  log_.add(Record(LogRecord::Start));
  log_.event(1);
  EXPECT_EQ(read().size(), 1U);
  expectDamage(0, 0, 2);
}

TEST_F(ReadLog, BeforeAHeadNothingIsRead) {
  log_ = {};
  log_.event(1);
  EXPECT_THAT(read(), IsEmpty());
  expectDamage(0, 0, 1);
  EXPECT_EQ(damage_.starts, 0U);
}

}  // namespace
}  // namespace glider::logs
