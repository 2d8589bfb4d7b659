// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A log's entries as rows of a table and as lines for people, word for word.

#include "logs/render.h"

#include <gtest/gtest.h>

#include <limits>

namespace glider::logs {
namespace {

using runtime::LogRecord;

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

LogEntry entryOf(LogRecord kind, double time = 0, const std::string& name = "") {
  LogEntry entry;
  entry.kind = kind;
  entry.time = time;
  entry.name = name;
  return entry;
}

LogEntry transition() {
  LogEntry entry = entryOf(LogRecord::Transition, 1500, "goto");
  entry.number = 2;
  entry.detail = "s1";
  entry.to = "s2";
  entry.values = {{"statetime", 1000}, {"m_depth", kNotKnown}};
  return entry;
}

LogEntry note() {
  LogEntry entry = entryOf(LogRecord::Note, 8.25, "warm");
  entry.values = {{"", 1.5}, {"", kNotKnown}};
  return entry;
}

LogEntry event(double value, const std::string& detail = "") {
  LogEntry entry = entryOf(LogRecord::Event, 16, "instruction refused");
  entry.detail = detail;
  entry.value = value;
  return entry;
}

TEST(LogCsv, HasARowForEachValue) {
  EXPECT_EQ(csvHead(), "time_s,record,name,value,from,to\n");
  EXPECT_EQ(csvLines(entryOf(LogRecord::Start, 0, "bench")), "0,start,bench,,,\n");
  LogEntry begin = entryOf(LogRecord::Begin);
  EXPECT_EQ(csvLines(begin), "0,begin,,,,\n");
  begin.values = {{"bottom", 25.5}, {"top", -1}};
  EXPECT_EQ(csvLines(begin), "0,begin,,,,\n0,parameter,bottom,25.5,,\n0,parameter,top,-1,,\n");
  LogEntry values = entryOf(LogRecord::Values, 4);
  values.values = {{"depth", 9}, {"temp", kNotKnown}};
  EXPECT_EQ(csvLines(values), "4,value,depth,9,,\n4,value,temp,,,\n");
}

TEST(LogCsv, OfATransitionItsCaseItsStatesAndWhatItWasDecidedOn) {
  EXPECT_EQ(csvLines(transition()),
            "1500,transition,goto,2,s1,s2\n1500,fired,statetime,1000,,\n1500,fired,m_depth,,,\n");
}

TEST(LogCsv, OfANoteARowAValueAndOneIfThereIsNone) {
  LogEntry entry = note();
  EXPECT_EQ(csvLines(entry), "8.25,log,warm,1.5,,\n8.25,log,warm,,,\n");
  entry.values.clear();
  EXPECT_EQ(csvLines(entry), "8.25,log,warm,,,\n");
  entry.unknown_set = true;
  EXPECT_EQ(csvLines(entry), "8.25,event,unknown set,,warm,\n");
}

TEST(LogCsv, OfAnEventItsNumberAndItsDetail) {
  EXPECT_EQ(csvLines(event(41, "too deep")), "16,event,instruction refused,41,too deep,\n");
  EXPECT_EQ(csvLines(event(kNotKnown)), "16,event,instruction refused,,,\n");
}

TEST(LogCsv, NumbersHaveTwelveDigits) {
  EXPECT_EQ(csvLines(event(1.0 / 3)), "16,event,instruction refused,0.333333333333,,\n");
}

TEST(LogCsv, QuotesWhatWouldBreakARowAndNothingElse) {
  const auto named = [](const std::string& name) {
    return csvLines(entryOf(LogRecord::Start, 0, name));
  };
  EXPECT_EQ(named("two words"), "0,start,two words,,,\n");
  EXPECT_EQ(named("a,b"), "0,start,\"a,b\",,,\n");
  EXPECT_EQ(named("a\"b"), "0,start,\"a\"\"b\",,,\n");
  EXPECT_EQ(named("a\nb"), "0,start,\"a\nb\",,,\n");
  EXPECT_EQ(named("a\rb"), "0,start,\"a\rb\",,,\n");
  LogEntry entry = transition();
  entry.values.clear();
  entry.detail = "a,1";
  entry.to = "b,2";
  EXPECT_EQ(csvLines(entry), "1500,transition,goto,2,\"a,1\",\"b,2\"\n");
}

TEST(LogText, SaysWhatHappened) {
  EXPECT_EQ(textLine(entryOf(LogRecord::Start, 0, "bench")),
            "       0.0 s  the program of mission bench starts\n");
  LogEntry begin = entryOf(LogRecord::Begin);
  EXPECT_EQ(textLine(begin), "       0.0 s  the mission begins\n");
  begin.values = {{"bottom", 25.5}, {"top", 1}};
  EXPECT_EQ(textLine(begin), "       0.0 s  the mission begins: bottom 25.5, top 1\n");
  LogEntry values = entryOf(LogRecord::Values, 12345.67);
  values.values = {{"depth", 10.2}, {"temp", kNotKnown}};
  EXPECT_EQ(textLine(values), "   12345.7 s  depth 10.2, temp unknown\n");
}

TEST(LogText, OfTransitions) {
  LogEntry entry = transition();
  EXPECT_EQ(textLine(entry),
            "    1500.0 s  s1 → s2 (goto, case 2): statetime 1000, m_depth unknown\n");
  entry.to.clear();
  entry.values.clear();
  EXPECT_EQ(textLine(entry), "    1500.0 s  s1 → end (goto, case 2)\n");
}

TEST(LogText, OfNotes) {
  LogEntry entry = note();
  EXPECT_EQ(textLine(entry), "       8.2 s  log warm: 1.5, unknown\n");
  entry.values.clear();
  EXPECT_EQ(textLine(entry), "       8.2 s  log warm\n");
  entry.unknown_set = true;
  EXPECT_EQ(textLine(entry), "       8.2 s  unknown set: warm\n");
}

TEST(LogText, OfEvents) {
  EXPECT_EQ(textLine(event(41, "too deep")), "      16.0 s  instruction refused: too deep (41)\n");
  EXPECT_EQ(textLine(event(kNotKnown, "too deep")),
            "      16.0 s  instruction refused: too deep\n");
  EXPECT_EQ(textLine(event(kNotKnown)), "      16.0 s  instruction refused\n");
  EXPECT_EQ(textLine(event(0.1234567)), "      16.0 s  instruction refused (0.1234567)\n");
}

TEST(LogText, WhatATerminalWouldObeyIsShownAsAQuestionMark) {
  const std::string escape = "a\x1b[31m";
  EXPECT_EQ(textLine(entryOf(LogRecord::Start, 0, escape)),
            "       0.0 s  the program of mission a?[31m starts\n");
  LogEntry entry = transition();
  entry.detail = entry.to = escape;
  entry.values = {{escape, 1}};
  EXPECT_EQ(textLine(entry), "    1500.0 s  a?[31m → a?[31m (goto, case 2): a?[31m 1\n");
  LogEntry set = entryOf(LogRecord::Note, 1, escape);
  EXPECT_EQ(textLine(set), "       1.0 s  log a?[31m\n");
  set.unknown_set = true;
  EXPECT_EQ(textLine(set), "       1.0 s  unknown set: a?[31m\n");
}

}  // namespace
}  // namespace glider::logs
