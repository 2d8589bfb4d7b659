// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/findings/findings.h"

#include "report/findings/uri.h"
#include "support/diagnostics/engine.h"
#include "support/diagnostics/ids/files.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"
#include "tests/unit/report/sarif_rules.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::report {
namespace {

using nlohmann::json;
using support::DiagnosticId;
using testing::HasSubstr;
using testing::IsEmpty;

/// Two missions: one with an error, its fix and a note; one that could not be read.
class Findings : public testing::Test {
 protected:
  Findings() {
    const uint32_t file =
        sources_.add("my missions/a\u00b5.mission", "mission a\n\u00b5\u00b5 => 1\n");
    // The second line's bytes are 10…18: µ µ blank = >
    auto wrong =
        diagnostics_.report(support::diagnostics::wrongComparison, {file, 15, 17}, "=>", ">=");
    wrong.fix({file, 15, 17}, ">=").note({file, 0, 7}, "the mission begins here");
    diagnostics_.report(support::diagnostics::neverRead, {file, 8, 9}, "a", "a variable");
    CheckedMission one;
    one.path = "my missions/a\u00b5.mission";
    one.sources = &sources_;
    one.diagnostics = diagnostics_.sorted();
    CheckedMission lost;
    lost.path = "/none.mission";
    lost.failure =
        support::Failure{support::diagnostics::cannotRead, "cannot read `/none.mission`", "look"};
    missions_ = {one, lost};
  }

  [[nodiscard]] json sarif() const {
    return json::parse(findingsToSarif(
        missions_, "1.2.3",
        [](DiagnosticId id) {
          return "# " + support::code(id) + ": a title\n\nA rule\nof two lines.\n\nMore.\n";
        },
        2));
  }

  support::SourceManager sources_;
  support::DiagnosticEngine diagnostics_;
  std::vector<CheckedMission> missions_;
};

TEST_F(Findings, SarifConformsToTheStandard) {
  EXPECT_THAT(sarifFaults(sarif()), IsEmpty());
}

TEST_F(Findings, TheCheckOfSarifDetectsFaults) {
  json log = sarif();
  log["runs"][0]["results"][0].erase("message");
  EXPECT_FALSE(sarifFaults(log).empty());
  log = sarif();
  log["runs"][0]["results"][0]["ruleIndex"] = 1;
  EXPECT_FALSE(sarifFaults(log).empty());
  log = sarif();
  log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["region"]["startLine"] = 0;
  EXPECT_FALSE(sarifFaults(log).empty());
}

TEST_F(Findings, SarifTakesItsRulesFromThePages) {
  const json rules = sarif()["runs"][0]["tool"]["driver"]["rules"];
  ASSERT_EQ(rules.size(), 2);
  EXPECT_EQ(rules[1]["id"], "GL1005");
  EXPECT_EQ(rules[1]["name"], "WrongComparison");
  EXPECT_EQ(rules[1]["shortDescription"]["text"], "a title");
  EXPECT_EQ(rules[1]["fullDescription"]["text"], "A rule of two lines.");
  EXPECT_THAT(std::string(rules[1]["help"]["markdown"]), HasSubstr("More."));
  EXPECT_EQ(rules[1]["defaultConfiguration"]["level"], "error");
}

TEST_F(Findings, SarifCountsColumnsInCodePoints) {
  const json result = sarif()["runs"][0]["results"][1];
  EXPECT_EQ(result["level"], "error");
  const json place = result["locations"][0]["physicalLocation"];
  EXPECT_EQ(place["artifactLocation"]["uri"], "my%20missions/a%C2%B5.mission");
  EXPECT_EQ(place["region"],
            json({{"startLine", 2}, {"startColumn", 4}, {"endLine", 2}, {"endColumn", 6}}));
  EXPECT_EQ(result["relatedLocations"][0]["message"]["text"], "the mission begins here");
  const json change = result["fixes"][0]["artifactChanges"][0];
  EXPECT_EQ(change["replacements"][0]["insertedContent"]["text"], ">=");
  EXPECT_EQ(change["replacements"][0]["deletedRegion"], place["region"]);
}

TEST_F(Findings, SarifReportsSystemErrors) {
  const json invocation = sarif()["runs"][0]["invocations"][0];
  EXPECT_EQ(invocation["executionSuccessful"], false);
  EXPECT_EQ(invocation["exitCode"], 2);
  const json notice = invocation["toolExecutionNotifications"][0];
  EXPECT_THAT(std::string(notice["message"]["text"]), HasSubstr("/none.mission"));
  EXPECT_EQ(notice["locations"][0]["physicalLocation"]["artifactLocation"]["uri"],
            "file:///none.mission");
}

TEST_F(Findings, JsonHasAMemberForEachMission) {
  missions_[0].remarks = {{{}, "all cases can fire"}};
  missions_[0].budgets = {{"ts7800",
                           {{"executable_bytes", 100, 200, "bytes", ""},
                            {"tick_instructions", {}, {}, "instructions", "a loop"}}}};
  const json document = json::parse(findingsToJson(missions_, "1.2.3"));
  EXPECT_EQ(document["glidercc"], "1.2.3");
  const json one = document["missions"][0];
  EXPECT_EQ(one["ok"], false);
  EXPECT_EQ(one["errors"], 1);
  EXPECT_EQ(one["warnings"], 1);
  const json error = one["diagnostics"][1];
  EXPECT_EQ(error["id"], "GL1005");
  EXPECT_EQ(error["begin"], json({{"line", 2}, {"column", 4}}));
  EXPECT_EQ(error["fixes"][0]["replacement"], ">=");
  EXPECT_EQ(error["notes"][0]["message"], "the mission begins here");
  EXPECT_EQ(one["remarks"][0]["text"], "all cases can fire");
  EXPECT_EQ(one["budget"]["ts7800"]["executable_bytes"]["limit"], 200);
  EXPECT_TRUE(one["budget"]["ts7800"]["tick_instructions"]["value"].is_null());
  EXPECT_EQ(document["missions"][1]["failure"]["hint"], "look");
  EXPECT_EQ(document["missions"][1]["ok"], false);
}

TEST_F(Findings, TheBudgetIsATable) {
  missions_[0].budgets = {{"ts7800",
                           {{"executable", 59856, 131072, "bytes", "of the file"},
                            {"tick_instructions", {}, {}, "instructions", "a loop in `f`"}}}};
  const std::string table = budgetTable(missions_[0]);
  EXPECT_THAT(table, HasSubstr("59,856 of 131,072 bytes"));
  EXPECT_THAT(table, HasSubstr("tick instructions"));
  EXPECT_THAT(table, testing::ContainsRegex("no bound is known +a loop in `f`"));
}

TEST(Uri, PathsBecomeReferences) {
  EXPECT_EQ(toUri("a/b.mission"), "a/b.mission");
  EXPECT_EQ(toUri("/a b"), "file:///a%20b");
  EXPECT_EQ(toUri("c:d"), "c%3Ad");
}

}  // namespace
}  // namespace glider::report
