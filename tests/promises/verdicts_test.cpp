// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The verdicts on promises: those of docs/promises.md are compared there; here are those near which
// a wrong rule would go unnoticed.

#include "ir/prove/context/proof_context.h"
#include "ir/prove/prove.h"
#include "ir/verify/verify.h"
#include "platforms/load/load_platform.h"
#include "tests/unit/frontend/compile.h"

#include <gtest/gtest.h>

namespace glider::tests {
namespace {

const platforms::Platform& slocum() {
  static const auto platform = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
  return *platform;
}

/// Out for half an hour, to the reef for half an hour, home; a leak leads home at once.
std::string survey(const std::string& requirement) {
  return "mission survey\nrequire " + requirement + R"(
place leaking = leakvoltage < 2 V
state out
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors missiontime, statetime, leakvoltage
  events
    case leakvoltage < 2 V goto home
    case statetime >= 30 min goto reef
end
state reef
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors missiontime, statetime, leakvoltage
  events
    case leakvoltage < 2 V goto home
    case statetime >= 30 min goto home
end
state home
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors missiontime, statetime
  events
    case statetime >= 30 min exit
end
)";
}

std::string verdict(const std::string& text) {
  frontend::testing_support::FrontendRun run(text);
  const auto mission = run.compile();
  EXPECT_TRUE(mission.has_value()) << run.said();
  if (!mission) {
    return "";
  }
  const ir::MissionFacts facts = ir::verify(*mission, run.diagnostics);
  const auto findings = ir::prove::prove(*mission, facts, slocum(), {}, run.diagnostics);
  EXPECT_EQ(findings.requirements.size(), 1U);
  return ir::prove::word(findings.requirements.at(0).verdict) + std::string();
}

void expectVerdict(const std::string& requirement, const std::string& expected) {
  EXPECT_EQ(verdict(survey(requirement)), expected) << requirement;
}

TEST(Verdicts, OfVisits) {
  expectVerdict("visit home within 75 min", "proved");
  expectVerdict("visit home within 59 min", "refuted");
  expectVerdict("visit out, home within 75 min", "proved");
  expectVerdict("visit out then home within 75 min", "proved");
  expectVerdict("visit reef within 75 min", "refuted");
  expectVerdict("visit out, home in order within 75 min", "proved");
  expectVerdict("visit home, out in order within 75 min", "refuted");
  expectVerdict("visit out at most 1 times", "proved");
  expectVerdict("visit home exactly 1 times within 75 min", "proved");
  expectVerdict("visit home at least 2 times within 75 min", "refuted");
}

TEST(Verdicts, OfReactions) {
  expectVerdict("whenever leaking then home within 30 s", "refuted");  // at home it may end
  expectVerdict("whenever leaking then home", "refuted");  // the start may see it, in `out`
  expectVerdict("in reef: never leaking", "proved");       // the tick that sees it leads home
  expectVerdict("in reef: whenever leaking then home", "proved");
  expectVerdict("outside home: never leaking", "refuted");
  expectVerdict("from reef to home: never leaking", "proved");
  expectVerdict("whenever reef then home within 40 min", "proved");
  expectVerdict("whenever reef then home within 29 min", "refuted");
  expectVerdict("when home then home for 29 min", "proved");
  expectVerdict("never out after home", "proved");
  expectVerdict("never reef before home", "refuted");
  expectVerdict("hold out until reef within 1 h", "refuted");
}

/// A state that waits for a return counts as one that holds, not as one that is entered again.
TEST(Verdicts, OfStatesThatWait) {
  const auto mission = [](const std::string& requirement) {
    return "mission m\nrequire " + requirement + R"(
var called : bool = false
state out
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors missiontime, statetime
  events
    case statetime >= 10 min && !called do set called = true end call look
    case statetime >= 30 min exit
end
state look
begin
  flightprofile surfaced
  sensors statetime
  events
    case statetime >= 5 min return
end
)";
  };
  EXPECT_EQ(verdict(mission("whenever look then out")), "proved");
  EXPECT_EQ(verdict(mission("in out: visit look at most 1 times")), "proved");
  EXPECT_EQ(verdict(mission("outside out: never look")), "proved");
  EXPECT_EQ(verdict(mission("visit out at most 1 times")), "proved") << "it returns";
  EXPECT_EQ(verdict(mission("whenever out then out for 1 h or exit")), "proved");
  EXPECT_EQ(verdict(mission("whenever out then look within 9 min")), "refuted");
}

/// Differences of such times are exact; of a parameter, which the pilot sets, they are not.
TEST(Verdicts, KeptMissionTimesAreKnownAsSuch) {
  frontend::testing_support::FrontendRun run(R"(mission m
param start : time = 0 s in 0 s .. 1 h
var kept : time = 0 s
var sum : time = 0 s
state out
begin
  flightprofile surfaced
  sensors missiontime
  events
    case missiontime - kept > 1 h && missiontime - sum > 1 h && missiontime - start > 1 h exit
    case missiontime > 1 min do set kept = missiontime set sum = sum + 1 s end stay
end
)");
  const auto mission = run.compile();
  ASSERT_TRUE(mission.has_value()) << run.said();
  const ir::prove::ProofContext context(*mission, slocum());
  for (size_t i = 0; i < mission->exprs.size(); ++i) {
    const ir::Expr& e = mission->exprs[i];
    if (e.op == ir::Op::Variable) {
      EXPECT_EQ(context.mission_times[i], (*mission)[e.variable].name == "kept")
          << (*mission)[e.variable].name;
    }
  }
}

}  // namespace
}  // namespace glider::tests
