// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is reported at the end of a campaign.

#include "campaign/campaign.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::campaign {
namespace {

using simulator::FaultKind;
using simulator::Verdict;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

Verdict flownVerdict(Verdict::Outcome outcome, double deepest_m, uint32_t releases = 0) {
  Verdict verdict;
  verdict.outcome = outcome;
  verdict.deepest_m = deepest_m;
  verdict.releases = releases;
  verdict.violation = outcome == Verdict::Outcome::Violation ? "too deep" : "";
  verdict.violation_s = 99.6;
  verdict.instructions = 8;
  return verdict;
}

const Verdict kExited = flownVerdict(Verdict::Outcome::Exited, 20.25);
const Verdict kAfter = flownVerdict(Verdict::Outcome::Exited, 21.25, 1);
const Verdict kBack = flownVerdict(Verdict::Outcome::Released, 5, 1);
const Verdict kBroken = flownVerdict(Verdict::Outcome::Violation, 70);

CampaignPlan tablePlan(std::vector<FaultKind> kinds) {
  CampaignPlan plan;
  plan.missions.resize(1);
  plan.missions[0].file = "m.mission";
  plan.kinds = std::move(kinds);
  return plan;
}

TEST(OutcomeName, DistinguishesExitsWithAndWithoutRelease) {
  EXPECT_STREQ(outcomeName(kExited), "exited");
  EXPECT_STREQ(outcomeName(kAfter), "exited after release");
  EXPECT_STREQ(outcomeName(kBack), "released");
  EXPECT_STREQ(outcomeName(kBroken), "VIOLATION");
}

TEST(CampaignTable, SaysWhereTheMissionNeverFlew) {
  Verdict idle = kBack;
  idle.instructions = 0;
  const auto with = [&](FaultKind first, std::vector<std::optional<Verdict>> verdicts) {
    CampaignResult result;
    result.verdicts = std::move(verdicts);
    return campaignTable(tablePlan({first, FaultKind::Power}), result);
  };
  const char* const kLine = "the mission was never in control of the vehicle";
  EXPECT_THAT(with(FaultKind::None, {idle, kExited, kExited}),
              HasSubstr("in 1 of 3 flights the mission was never in control of the vehicle"));
  EXPECT_THAT(with(FaultKind::Clock, {idle, kExited, kExited}), Not(HasSubstr(kLine)));
  EXPECT_THAT(with(FaultKind::Clock, {idle, idle, kExited}), HasSubstr(kLine));
  EXPECT_THAT(with(FaultKind::None, {kExited, idle, kExited}), Not(HasSubstr(kLine)));
}

TEST(CampaignTable, CountsByKindByMannerAndByWhatFlew) {
  const CampaignPlan plan = tablePlan({FaultKind::Power, FaultKind::Clock});
  CampaignResult result;
  result.verdicts = {kExited, kBack, kAfter, std::nullopt, kBroken, kExited, kExited};
  const std::string table = campaignTable(plan, result);
  const std::string head =
      " flights   exited     after release     released deepest (m)  VIOLATION\n";
  EXPECT_THAT(table,
              StartsWith("fault                   " + head +
                         "SBC power cut                  4        2                 1        "
                         "    0        70.0          1\n"
                         "clock jumps                    2        1                 0        "
                         "    1        20.2          0\n"
                         "all                            6        3                 1        "
                         "    1        70.0          1\n\nwhen                    " +
                         head));
  // The numbers of manners: 0, 1, 1, (2), 2, 3, 3.
  EXPECT_THAT(table,
              HasSubstr("\nonce                           1        1                 0        "
                        "    0        20.2          0\n"));
  EXPECT_THAT(table,
              HasSubstr("\nrecurring                      2        0                 1        "
                        "    1        21.2          0\n"));
  EXPECT_THAT(table, HasSubstr("\n\nSBC                     " + head +
                               "in process                     6        3                 1        "
                               "    1        70.0          1\n"));
  EXPECT_TRUE(table.ends_with("70.0          1\n"));
}

TEST(CampaignTable, OfNoFlightSaysSo) {
  CampaignResult result;
  result.verdicts = {std::nullopt, std::nullopt};
  EXPECT_EQ(campaignTable(tablePlan({FaultKind::Power}), result), "no flight was flown\n");
}

/// Flights of a mission are every second one; those of boards are not watched.
TEST(RequirementCounts, AreOfTheFlightsOfTheMissionInThisProcess) {
  CampaignPlan plan = tablePlan({FaultKind::Power});
  plan.missions.resize(2);
  plan.missions[0].requirements = {"require exit within 1 h", "require always depth < 9 m"};
  plan.missions[0].assumptions_from = 1;
  plan.missions[1].file = "n.mission";
  plan.missions[1].requirements = {"require always depth < 5 m"};
  plan.missions[1].assumptions_from = 1;
  CampaignResult result;
  result.verdicts = {kExited, kExited, kBroken, kBroken, std::nullopt, kBroken, kBroken};
  result.verdicts[2]->requirements = {1};
  result.verdicts[3]->requirements = {0};
  result.verdicts[5]->requirements = {0};
  result.verdicts[6]->requirements = {0, 1};
  EXPECT_EQ(requirementLines(plan, result),
            "\nrequirements and assumptions, with these faults\n"
            "m.mission: `require exit within 1 h`: violated in 1 of 3 flights, first in flight 6\n"
            "m.mission: `require always depth < 9 m`: broken in 2 of 3 flights, first in flight "
            "2\n"
            "n.mission: `require always depth < 5 m`: violated in 2 of 3 flights, first in flight "
            "3\n");
  plan.boards = {"ts7800"};
  plan.board_percent = 100;
  for (const RequirementCount& count : requirementCounts(plan, result)) {
    EXPECT_EQ(count.flights, 0U);
    EXPECT_EQ(count.violated, 0U);
    EXPECT_FALSE(count.first);
  }
}

TEST(CampaignTable, HasARowForEachBoard) {
  CampaignPlan plan = tablePlan({FaultKind::Power});
  plan.boards = {"ts5500", "ts7800"};
  plan.board_percent = 100;
  CampaignResult result;
  uint64_t second = 0;
  for (uint64_t i = 0; i < 10; ++i) {
    second += *flightOf(plan, i).board;
    result.verdicts.emplace_back(kExited);
  }
  ASSERT_GT(second, 0U);
  ASSERT_LT(second, 10U);
  const auto row = [](const char* board, uint64_t count) {
    return fmt::format("\n{:<24}{:>8}{:>9}", board, count, count);
  };
  const std::string table = campaignTable(plan, result);
  EXPECT_THAT(table, Not(HasSubstr("in process")));
  EXPECT_THAT(table, HasSubstr(row("ts5500", 10 - second)));
  EXPECT_THAT(table, HasSubstr(row("ts7800", second)));
}

TEST(ViolationLines, SayHowToFlyEachAgain) {
  const CampaignPlan plan = tablePlan({FaultKind::Power});
  CampaignResult result;
  result.verdicts = {kExited, kBack, kBroken, std::nullopt, kAfter};
  EXPECT_EQ(violationLines(plan, result, "glidercc campaign m.mission"),
            "flight 2 (m.mission, SBC power cut, with another): at 100 s too deep\n"
            "  glidercc campaign m.mission --only 2 -o flight2\n");
  result.verdicts[2] = kExited;
  EXPECT_EQ(violationLines(plan, result, "glidercc"), "");
}

TEST(ViolationLines, AreTheFirstTwentyAndACount) {
  const CampaignPlan plan = tablePlan({FaultKind::Power});
  CampaignResult result;
  result.verdicts.assign(20, kBroken);
  const std::string twenty = violationLines(plan, result, "c");
  EXPECT_THAT(twenty, HasSubstr("c --only 19 -o flight19\n"));
  EXPECT_EQ(twenty.find("more"), std::string::npos);
  result.verdicts.assign(23, kBroken);
  EXPECT_EQ(violationLines(plan, result, "c"), twenty + "and 3 more violations\n");
}

}  // namespace
}  // namespace glider::campaign
