// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `glidercc check --against`: its output, its files, its exit codes.

#include "tests/support/command.h"
#include "tests/unit/slocum/second_reader.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using slocum::second::Draft;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kMission =
    "mission deep\n"
    "param limit: length = 10 m in 1 m .. 50 m\n"
    "state look\nbegin\n  flightprofile yo(3 m, 20 m, 26 deg, 26 deg)\n"
    "  sensors missiontime, depth, temp\n  events\n"
    "    case depth > limit exit\n    case temp > 20 degC exit\n"
    "    case missiontime >= 1 h exit\nend\n";

/// Five records, 4 s apart, the first of initial values.
Draft dive(const std::string& vehicle) {
  constexpr double kBegin = 1719946527;
  Draft draft;
  draft.full_name = vehicle + "-2024-183-2-7";
  draft.sensors = {{"m_depth", "m", 4, true}, {"m_present_time", "timestamp", 8, true}};
  for (const double depth : {0.0, 3.0, 8.0, 12.0, 6.0}) {
    draft.rows.push_back(
        {{'*', depth}, {'*', kBegin + 4 * static_cast<double>(draft.rows.size())}});
  }
  return draft;
}

class Against : public testing::Test {
 protected:
  Against() {
    (void)folder_.write("m.mission", kMission);
    (void)folder_.write("a.sbd", write(dive("unit")));
  }
  Outcome check(const std::string& words) const {
    return runShell("cd " + folder_.path().string() + " && $GLIDERCC check " + words);
  }
  TemporaryFolder folder_;
};

TEST_F(Against, TellsWhatTheMissionWouldHaveDone) {
  const Outcome shown = check("m.mission --against a.sbd");
  EXPECT_EQ(shown.status, 0);
  EXPECT_EQ(shown.err, "");
  EXPECT_EQ(
      shown.out,
      "m.mission against unit: 1 file, 2024-07-02 18:55:31 to 2024-07-02 18:55:43 UTC (0.00 h), 3 "
      "ticks, one for each record of the flight computer\n"
      "  parameter limit: 10 m\n"
      "\n"
      "sensors that the mission uses\n"
      "  depth (m_depth)        4 updates, known on 100 % of ticks, 6 to 12 m\n"
      "  temp (sci_water_temp)  never known: the data files do not contain `sci_water_temp`\n"
      "\n"
      "guards, each as if the mission had been in its state from the first tick on and nothing had "
      "left it\n"
      "  state look\n"
      "    line 8: depth > limit → exit\n"
      "      fires once, true on 33 % of ticks, known on 100 % of ticks\n"
      "        at     2024-07-02 18:55:39 (0.00 h)  depth 12.0 m\n"
      "    line 9: temp > 20 degC → exit\n"
      "      never known: the data files do not contain `sci_water_temp`\n"
      "    line 10: missiontime >= 1 h → exit\n"
      "      never true, known on 100 % of ticks\n"
      "\n"
      "what the mission would have done; the vehicle did not obey it, so after a transition its "
      "own "
      "flight\nwould have brought other readings\n"
      "  2024-07-02 18:55:31 (0.00 h)  starts in look: depth 3.0 m\n"
      "  2024-07-02 18:55:39 (0.00 h)  look → exit, line 8: depth 12.0 m\n"
      "\n"
      "m.mission: fine; mission deep, 1 state, no calls\n");
}

/// Requirements that are proved, of a vehicle that went deeper than proofs assume.
TEST_F(Against, NamesTheFirstViolationOfARequirement) {
  std::string text = kMission;
  text.insert(text.find('\n') + 1,
              "require never depth > 27 m\nrequire whenever depth > 27 m then depth > 28 m\n"
              "require visit look at most 1 times\n");
  (void)folder_.write("m.mission", text);
  Draft deep = dive("unit");
  deep.rows[2][0] = {'*', 27.5};
  (void)folder_.write("a.sbd", write(deep));
  const Outcome shown = check("m.mission --against a.sbd --set limit=50");
  EXPECT_THAT(shown.out, HasSubstr("look: violates `require never depth > 27 m` (line 2)\n"))
      << shown.err;
  EXPECT_THAT(shown.out, HasSubstr("look: violates `require whenever depth > 27 m then depth > 28 "
                                   "m` (line 3)\n"));
  EXPECT_THAT(shown.out, Not(HasSubstr("at most 1 times")));
}

TEST_F(Against, TakesParameters) {
  EXPECT_THAT(check("m.mission --against a.sbd --set limit=7m").out,
              HasSubstr("18:55:35 (0.00 h)  depth 8.0 m"));
  const Outcome wrong = check("m.mission --against a.sbd --set limit=700m");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("[GL9052 "));
  EXPECT_NE(check("m.mission --set limit=7m").status, 0);
}

TEST_F(Against, WritesJson) {
  const Outcome shown = check("m.mission --format json --against a.sbd");
  ASSERT_EQ(shown.status, 0) << shown.err;
  const auto mission = nlohmann::json::parse(shown.out).at("missions").at(0);
  const auto one = mission.at("against").at(0);
  EXPECT_EQ(one.at("vehicle"), "unit");
  EXPECT_EQ(one.at("ticks"), 3);
  EXPECT_EQ(one.at("ticks_of"), "flight");
  EXPECT_EQ(one.at("begin").at("utc"), "2024-07-02T18:55:31Z");
  EXPECT_EQ(one.at("parameters").at(0).at("value"), 10);
  const auto& deep = one.at("cases").at(0);
  EXPECT_EQ(deep.at("state"), "look");
  EXPECT_EQ(deep.at("line"), 8);
  EXPECT_EQ(deep.at("transition"), "exit");
  EXPECT_EQ(deep.at("true_ticks"), 1);
  EXPECT_EQ(deep.at("followed_true_ticks"), 1);
  EXPECT_EQ(deep.at("firings").at(0).at("depth_m"), 12);
  EXPECT_EQ(deep.at("firings").at(0).at("time_s"), 1719946539);
  EXPECT_EQ(deep.at("firings").at(0).at("values").at(0).at("unit"), "m");
  EXPECT_EQ(one.at("cases").at(1).at("known_ticks"), 0);
  EXPECT_EQ(one.at("cases").at(1).at("unknown_because").size(), 1U);
  EXPECT_TRUE(one.at("sensors").at(1).at("least").is_null());
  EXPECT_EQ(one.at("followed").at(1).at("kind"), "exit");
  EXPECT_TRUE(one.at("followed").at(1).at("to").is_null());
  EXPECT_FALSE(nlohmann::json::parse(check("m.mission --format json").out)
                   .at("missions")
                   .at(0)
                   .contains("against"));
}

TEST_F(Against, RunsOnceForEachVehicle) {
  (void)folder_.write("b.sbd", write(dive("other")));
  const Outcome shown = check("m.mission --against .");
  EXPECT_EQ(shown.status, 0);
  EXPECT_THAT(shown.out, HasSubstr("m.mission against unit: 1 file"));
  EXPECT_THAT(shown.out, HasSubstr("m.mission against other: 1 file"));
  const Outcome drawn = check("m.mission --against . --picture p.svg");
  EXPECT_EQ(drawn.status, 2);
  EXPECT_THAT(drawn.err, HasSubstr("[GL9365 "));
}

TEST_F(Against, DrawsThePicture) {
  EXPECT_EQ(check("m.mission --against a.sbd --picture p.svg").status, 0);
  const std::string drawn = slurp(folder_.path() / "p.svg");
  EXPECT_THAT(drawn, HasSubstr("deep against unit</text>"));
  EXPECT_THAT(drawn, HasSubstr("look, line 8: depth &gt; limit → exit</text>"));
  EXPECT_THAT(drawn, HasSubstr("never known</text>"));
  EXPECT_THAT(drawn, HasSubstr("class=\"waypoint\""));
  EXPECT_EQ(check("m.mission m.mission --against a.sbd --picture p.svg").status, 2);
  EXPECT_THAT(check("m.mission --against a.sbd --picture a.sbd").err, HasSubstr("[GL9350 "));
  EXPECT_NE(check("m.mission --picture p.svg").status, 0);
}

TEST_F(Against, MarksThePageOfTheLogs) {
  EXPECT_EQ(check("m.mission --against a.sbd --page p.html").status, 0);
  const std::string page = slurp(folder_.path() / "p.html");
  EXPECT_THAT(page, HasSubstr("the mission would have started in look"));
  EXPECT_THAT(page, HasSubstr("look → end (exit)"));
  EXPECT_EQ(check("m.mission m.mission --against a.sbd --page p.html").status, 2);
  EXPECT_THAT(check("m.mission --against a.sbd --page a.sbd").err, HasSubstr("[GL9350 "));
  EXPECT_NE(check("m.mission --page p.html").status, 0);
  (void)folder_.write("b.sbd", write(dive("other")));
  EXPECT_THAT(check("m.mission --against . --page q.html").err, HasSubstr("[GL9365 "));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "q.html"));
}

TEST_F(Against, AMissionWithErrorsIsNotRun) {
  (void)folder_.write("bad.mission", "mission bad\nstate a\nbegin\nend\n");
  const Outcome shown = check("bad.mission --against a.sbd");
  EXPECT_EQ(shown.status, 1);
  EXPECT_THAT(shown.out, Not(HasSubstr("against unit")));
}

TEST_F(Against, UnreadableDataFilesEndWithTwo) {
  EXPECT_EQ(check("m.mission --against none.sbd").status, 2);
  Draft next = dive("unit");
  next.full_name = "unit-2024-183-2-8";
  const std::string bytes = write(next);
  (void)folder_.write("cut.sbd", bytes.substr(0, bytes.size() - 5));
  const Outcome damaged = check("m.mission --against cut.sbd a.sbd");
  EXPECT_EQ(damaged.status, 2);
  EXPECT_THAT(damaged.err, HasSubstr("[GL52"));
  EXPECT_THAT(damaged.out, HasSubstr("m.mission against unit"));
}

TEST_F(Against, DataFilesWithoutTimesEndWithTwo) {
  Draft draft = dive("unit");
  draft.sensors[1].name = "m_some_time";
  (void)folder_.write("a.sbd", write(draft));
  const Outcome shown = check("m.mission --against a.sbd");
  EXPECT_EQ(shown.status, 2);
  EXPECT_THAT(shown.err, HasSubstr("[GL5210 "));
  // accepts: GL5210
  draft.sensors[1].name = "m_present_time";
  (void)folder_.write("a.sbd", write(draft));
  EXPECT_EQ(check("m.mission --against a.sbd").status, 0);
}

TEST_F(Against, FindsSensorListsInTheFoldersOfCache) {
  Draft draft = dive("unit");
  draft.factored = true;
  (void)folder_.write("a.sbd", write(draft));
  EXPECT_EQ(check("m.mission --against a.sbd").status, 2);
  std::filesystem::create_directory(folder_.path() / "lists");
  (void)folder_.write("lists/" + slocum::second::crcOf(listText(draft)) + ".cac", listText(draft));
  EXPECT_EQ(check("m.mission --against a.sbd --cache lists").status, 0);
}

}  // namespace
}  // namespace glider::tests
