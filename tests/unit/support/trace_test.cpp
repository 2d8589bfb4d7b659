// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/trace/trace.h"

#include "support/diagnostics/diagnostic.h"
#include "support/trace/submersions.h"

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
  trace.events = {unlistedEvent(4, NAN, "transition", "a → b", "x < 1")};
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

TEST(Trace, CsvReadsBackAsItWas) {
  const auto back = traceFromCsv(traceToCsv(sample()), "t.csv");
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(traceToCsv(*back), traceToCsv(sample()));
  EXPECT_EQ(back->columns[1].name, "m_depth");
  EXPECT_EQ(back->columns[1].unit, "m");
  EXPECT_TRUE(std::isnan(back->rows[2]));
  EXPECT_TRUE(traceFromCsv("time (s),true_depth (m)\r\n0,1\r\n", "t.csv"))
      << "with the ends of Windows";
}

TEST(Trace, WhatIsNotTheCsvOfATraceIsRefused) {
  for (const auto& [text, why] : std::vector<std::pair<std::string, std::string>>{
           {"", "its first column is not `time (s)`"},
           {"hello\n", "its first column is not `time (s)`"},
           {"time (s),x\n", "it has no column `m_depth` or `true_depth`"},
           {"time (s),m_depth (m)\n0,1\n0\n",
            "line 3 does not have a number or nothing for each of 2"},
           {"time (s),m_depth (m)\n0,1,2\n", "line 2 "},
           {"time (s),m_depth (m)\n0,1x\n", "line 2 "}}) {
    const auto refused = traceFromCsv(text, "t.csv");
    ASSERT_FALSE(refused) << text;
    EXPECT_EQ(code(refused.error().id), "GL9366");
    EXPECT_NE(refused.error().message.find(why), std::string::npos) << refused.error().message;
  }
}

TEST(Trace, JsonHasWhatOnlyALogHas) {
  Trace trace = sample();
  EXPECT_FALSE(nlohmann::json::parse(traceToJson(trace)).contains("log"));
  trace.log = VehicleLog{"comet", 1.5e9, "f/trace.csv", {}};
  const auto log = nlohmann::json::parse(traceToJson(trace)).at("log");
  EXPECT_EQ(log.at("vehicle"), "comet");
  EXPECT_EQ(log.at("utc"), 1.5e9);
  EXPECT_EQ(log.at("beside"), "f/trace.csv");
}

/// A trace whose depth changes every 20 s.
Trace dives(const std::vector<double>& depths) {
  Trace trace;
  trace.columns = {{"time", "s"}, {"m_depth", "m"}};
  for (size_t i = 0; i < depths.size(); ++i) {
    trace.rows.insert(trace.rows.end(), {20.0 * static_cast<double>(i), depths[i]});
  }
  return trace;
}

std::vector<std::pair<size_t, std::optional<size_t>>> rowsOf(const std::vector<Submersion>& found) {
  std::vector<std::pair<size_t, std::optional<size_t>>> rows;
  for (const Submersion& one : found) {
    rows.emplace_back(one.begin, one.end);
  }
  return rows;
}

TEST(Submersions, BeginAndEndAtTheSurface) {
  using Rows = std::vector<std::pair<size_t, std::optional<size_t>>>;
  const auto of = [](const std::vector<double>& depths) {
    return rowsOf(submersions(dives(depths)));
  };
  EXPECT_EQ(of({0, 1, 2.5, 9, NAN, 8, 1, 0}), (Rows{{2, 6}}));
  EXPECT_EQ(of({5, 9}), (Rows{{0, std::nullopt}})) << "the trace may begin and end under water";
  EXPECT_EQ(of({0, 2.9, 0}), Rows()) << "a wave";
  EXPECT_EQ(of({0, 9, 1, 1, 1, 1, 1, 9, 0}), (Rows{{1, 8}})) << "100 s is the turn of a climb";
  EXPECT_EQ(of({0, 9, 1, 1, 1, 1, 1, 1, 9}), (Rows{{1, 2}, {8, std::nullopt}})) << "120 s is not";
  EXPECT_EQ(of({0, 9, 1, 1, 1, 1, 1, 1, 1, 2.5, 1}), (Rows{{1, 2}})) << "a wave after a dive";
  EXPECT_EQ(of({9, NAN, NAN, NAN, NAN, NAN, NAN, NAN, 9, 0}), (Rows{{0, 9}})) << "a gap";
  EXPECT_EQ(of({}), Rows());
  Trace unmeasured = dives({0, 9});
  unmeasured.columns[1].name = "true_depth";
  EXPECT_EQ(submersions(unmeasured).size(), 1U);
  unmeasured.columns[1].name = "m_pitch";
  EXPECT_TRUE(submersions(unmeasured).empty());
}

}  // namespace
}  // namespace glider::support
