// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/trace/trace.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace glider::support {
namespace {

Trace sample() {
  Trace trace;
  trace.mission = "m";
  trace.columns = {{"time", "s"}, {"m_depth", "m"}, {"state", ""}};
  trace.rows = {0, 0.1, NAN, 4, 1e-7, 1};
  trace.events = {{4, NAN, "transition", "a → b", "x < 1"}};
  return trace;
}

TEST(Trace, CsvHasUnitsShortestDecimalsAndEmptyCells) {
  EXPECT_EQ(traceToCsv(sample()), "time (s),m_depth (m),state\n0,0.1,\n4,1e-07,1\n");
}

TEST(Trace, JsonWritesUnknownAsNull) {
  const auto document = nlohmann::json::parse(traceToJson(sample()));
  EXPECT_TRUE(document["rows"][2].is_null());
  EXPECT_TRUE(document["events"][0]["missionTime"].is_null());
  EXPECT_EQ(document["columns"][1]["unit"], "m");
}

TEST(Trace, JsonSurvivesBadUtf8) {
  Trace trace = sample();
  trace.mission = "\xFF\xFE";
  EXPECT_NO_THROW({ EXPECT_FALSE(traceToJson(trace).empty()); });
}

}  // namespace
}  // namespace glider::support
