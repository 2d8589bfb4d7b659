// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The table of flights: its contents, and that it is read back as it was written.

#include "campaign/campaign.h"
#include "support/diagnostics/ids/files.h"
#include "support/diagnostics/ids/flights.h"
#include "tests/support/command.h"
#include "tests/support/replaced.h"
#include "tests/unit/campaign/small_plan.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::campaign {
namespace {

using simulator::Verdict;
using ::testing::HasSubstr;

Verdict verdictOf(Verdict::Outcome outcome, uint32_t releases = 0) {
  Verdict verdict;
  verdict.outcome = outcome;
  verdict.releases = releases;
  verdict.instructions = 17;
  verdict.end_s = 1234.5;
  verdict.deepest_m = 20.0625;
  return verdict;
}

Verdict violation() {
  Verdict verdict = verdictOf(Verdict::Outcome::Violation, 1);
  verdict.violation = "too deep, \"60\" m";
  verdict.violation_s = 0.1;
  return verdict;
}

class CampaignCsv : public ::testing::Test {
 protected:
  CampaignCsv() {
    plan_.missions.resize(2);
    plan_.missions[0].file = "a \"b\", c.mission";
    plan_.missions[1].file = "two.mission";
    plan_.kinds = {simulator::FaultKind::Power, simulator::FaultKind::Clock};
    plan_.flights = 6;
    plan_.seed = 1234567;
    result_.verdicts = {verdictOf(Verdict::Outcome::Exited),
                        verdictOf(Verdict::Outcome::Exited, 2),
                        std::nullopt,
                        verdictOf(Verdict::Outcome::Released, 3),
                        violation(),
                        std::nullopt};
  }

  [[nodiscard]] support::Result<void> read(const std::string& text, CampaignResult& result) const {
    result.verdicts.resize(plan_.flights);
    return readCsv(folder_.write("flights.csv", text).string(), plan_, "id", result);
  }
  /// Why it is refused.
  [[nodiscard]] std::string refusal(const std::string& text) const {
    CampaignResult result;
    const auto done = read(text, result);
    EXPECT_FALSE(done) << text;
    if (done) {
      return "";
    }
    EXPECT_EQ(done.error().id, support::diagnostics::campaignNotResumed);
    return done.error().message + "; " + done.error().hint;
  }
  [[nodiscard]] std::string written() const { return campaignCsv(plan_, result_, "id"); }
  [[nodiscard]] std::string row(uint64_t number) const {
    return csvRow(plan_, flightOf(plan_, number), *result_.verdicts[number]);
  }

  const tests::TemporaryFolder folder_;
  CampaignPlan plan_;
  CampaignResult result_;
};

TEST_F(CampaignCsv, BeginsWithWhatItBelongsToAndItsColumns) {
  EXPECT_EQ(csvHead("id"),
            "# glidercc campaign id\nflight,mission,fault,when,sbc,seed,outcome,releases,"
            "instructions,end (s),deepest (m),violation (s),violation,requirements violated,"
            "assumptions broken\n");
}

TEST_F(CampaignCsv, ARowHasAllOfAFlight) {
  EXPECT_EQ(row(0),
            "0,\"a \"\"b\"\", c.mission\",SBC power cut,once,in process,6457827717110365317,exited,"
            "0,17,1234.5,20.0625,,\"\",,\n");
  EXPECT_EQ(row(3),
            "3,\"two.mission\",clock jumps,recurring,in process,4593380528125082431,released,3,"
            "17,1234.5,20.0625,,\"\",,\n");
  EXPECT_THAT(row(1), HasSubstr(",exited after release,2,17,"));
  EXPECT_THAT(row(4),
              HasSubstr(",VIOLATION,1,17,1234.5,20.0625,0.1,\"too deep, \"\"60\"\" m\",,\n"));
}

TEST_F(CampaignCsv, ARowHasTheRequirementsThatTheFlightViolates) {
  plan_.missions[0].requirements = {"require never deep", "require visit a within 1 h",
                                    "assume no outage", "assume current <= 1 m/s"};
  plan_.missions[0].assumptions_from = 2;
  result_.verdicts[0]->requirements = {0, 1, 3};
  EXPECT_THAT(row(0), HasSubstr(",\"\",1;2,2\n"));
  CampaignResult again;
  ASSERT_TRUE(read(written(), again));
  EXPECT_EQ(again.verdicts[0]->requirements, (std::vector<size_t>{0, 1, 3}));
  for (const char* wrong : {"1;3,2", "0,2", "1;,2", "one,2", "2;2x,2", "1;2,3", "1;2,0", "1;2"}) {
    CampaignResult refused;
    EXPECT_FALSE(read(csvHead("id") + tests::replaced(row(0), "1;2,2\n", std::string(wrong) + "\n"),
                      refused))
        << wrong;
  }
}

TEST_F(CampaignCsv, ARowNamesTheBoard) {
  plan_.boards = {"ts5500", "ts7800"};
  CampaignFlight flight = flightOf(plan_, 0);
  flight.board = 1;
  EXPECT_THAT(csvRow(plan_, flight, *result_.verdicts[0]), HasSubstr(",once,ts7800,"));
}

TEST_F(CampaignCsv, HasTheFlightsThatWereFlownInTheirOrder) {
  EXPECT_EQ(written(), csvHead("id") + row(0) + row(1) + row(3) + row(4));
  EXPECT_EQ(campaignCsv(plan_, {}, "id"), csvHead("id"));
}

TEST_F(CampaignCsv, IsReadBackAsItWasWritten) {
  CampaignResult back;
  ASSERT_TRUE(read(written(), back));
  ASSERT_EQ(back.verdicts.size(), 6U);
  EXPECT_FALSE(back.verdicts[2] || back.verdicts[5]);
  EXPECT_EQ(campaignCsv(plan_, back, "id"), written());
  EXPECT_EQ(back.verdicts[1]->outcome, Verdict::Outcome::Exited);
  EXPECT_EQ(back.verdicts[1]->releases, 2U);
  EXPECT_EQ(back.verdicts[1]->instructions, 17U);
  EXPECT_EQ(back.verdicts[1]->end_s, 1234.5);
  EXPECT_EQ(back.verdicts[1]->deepest_m, 20.0625);
  EXPECT_EQ(back.verdicts[3]->outcome, Verdict::Outcome::Released);
  EXPECT_EQ(back.verdicts[4]->outcome, Verdict::Outcome::Violation);
  EXPECT_EQ(back.verdicts[4]->violation, "too deep, \"60\" m");
  EXPECT_EQ(back.verdicts[4]->violation_s, 0.1);
}

TEST_F(CampaignCsv, RowsMayBeInAnyOrder) {
  CampaignResult back;
  ASSERT_TRUE(read(csvHead("id") + row(4) + row(1) + row(0) + row(3), back));
  EXPECT_EQ(campaignCsv(plan_, back, "id"), written());
}

TEST_F(CampaignCsv, ALastLineThatWasTornIsLeftOut) {
  const std::string whole = written();
  for (size_t cut = whole.size() - row(4).size(); cut < whole.size(); ++cut) {
    CampaignResult back;
    ASSERT_TRUE(read(whole.substr(0, cut), back)) << cut;
    EXPECT_TRUE(back.verdicts[3]);
    EXPECT_FALSE(back.verdicts[4]) << cut;
  }
}

TEST_F(CampaignCsv, OfNothingButItsHeadNothingIsKnown) {
  CampaignResult back;
  ASSERT_TRUE(read(csvHead("id"), back));
  EXPECT_FALSE(back.verdicts[0]);
}

TEST_F(CampaignCsv, OtherTablesAreRefused) {
  EXPECT_THAT(refusal(""), HasSubstr("it is not the CSV file of a campaign"));
  EXPECT_THAT(refusal("flight,mission\n"), HasSubstr("it is not the CSV file of a campaign"));
  EXPECT_THAT(refusal(csvHead("other")), HasSubstr("it belongs to another campaign"));
  EXPECT_THAT(refusal(csvHead("id").substr(0, 30)), HasSubstr("it belongs to another campaign"));
  CampaignResult result;
  const auto missing = readCsv(folder_.path() / "none.csv", plan_, "id", result);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().id, support::diagnostics::cannotRead);
}

TEST_F(CampaignCsv, RowsOfOtherFlightsAreRefusedWithTheirLine) {
  const auto line = [&](const std::string& bad) {
    return refusal(csvHead("id") + row(0) + bad + row(3));
  };
  EXPECT_THAT(line("\n"), HasSubstr("line 4 is not a flight of this campaign; remove that line"));
  EXPECT_THAT(line(tests::replaced(row(1), "1,", "6,")), HasSubstr("line 4")) << "there is none";
  EXPECT_THAT(line(tests::replaced(row(1), "1,", "5,")), HasSubstr("line 4"))
      << "that one is another's";
  EXPECT_THAT(line(tests::replaced(row(1), "1,", "one,")), HasSubstr("line 4"));
  EXPECT_THAT(line(tests::replaced(row(1), ",2,17,", ",2x,17,")), HasSubstr("line 4"));
  EXPECT_THAT(line(tests::replaced(row(1), ",2,17,", ",2,17x,")), HasSubstr("line 4"));
  EXPECT_THAT(line(tests::replaced(row(1), "1234.5", "later")), HasSubstr("line 4"));
  EXPECT_THAT(line(tests::replaced(row(1), "20.0625", "")), HasSubstr("line 4"));
  EXPECT_THAT(line(tests::replaced(row(1), "exited after release", "exited")), HasSubstr("line 4"));
  EXPECT_THAT(line(tests::replaced(row(1), "exited after release", "sunk")), HasSubstr("line 4"));
  EXPECT_THAT(line(tests::replaced(row(1), "two", "three")), HasSubstr("line 4"));
  EXPECT_THAT(line(tests::replaced(row(1), "320", "321")), HasSubstr("line 4")) << "another seed";
  EXPECT_THAT(line(tests::replaced(row(1), "\"\",,\n", "\"\",,,more\n")), HasSubstr("line 4"));
  EXPECT_THAT(line(tests::replaced(row(1), ",,\"\",,\n", ",\"\",,\n")), HasSubstr("line 4"));
  EXPECT_THAT(line(tests::replaced(row(4), ",0.1,", ",,")), HasSubstr("line 4"));
}

// The files of parts, read one after another.
TEST_F(CampaignCsv, FlightsOfSeveralFilesAreMerged) {
  CampaignResult merged;
  ASSERT_TRUE(read(csvHead("id") + row(0) + row(3), merged));
  ASSERT_TRUE(read(csvHead("id") + row(4) + row(3), merged)) << "the same flight twice";
  ASSERT_TRUE(read(csvHead("id") + row(1), merged));
  EXPECT_EQ(campaignCsv(plan_, merged, "id"), written());
}

TEST_F(CampaignCsv, AFlightWithTwoOutcomesIsRefused) {
  CampaignResult merged;
  ASSERT_TRUE(read(csvHead("id") + row(0) + row(3), merged));
  const auto done =
      read(csvHead("id") + row(1) + tests::replaced(row(3), "released,3", "released,4"), merged);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().id, support::diagnostics::campaignNotResumed);
  EXPECT_NE(done.error().message.find("line 4: flight 3 has another outcome"), std::string::npos)
      << done.error().message;
}

}  // namespace
}  // namespace glider::campaign
