// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the second check refuses: certificates that are about something else, that have been
// weakened, or that could change the question.

#include "compiler/proving.h"
#include "support/diagnostics/ids/command.h"
#include "support/files.h"
#include "support/program.h"
#include "tests/certificates/issued.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <z3++.h>

namespace glider::tests {
namespace {

using nlohmann::json;

constexpr const char* kPatrol = R"(
state look
begin
  flightprofile yo(5 m, 24.5 m, 26 deg, 26 deg)
  sensors       missiontime, altitude
  events
    case altitude < 5 m                              goto up
    case missiontime >= 1 h && known(altitude)       exit
    case missiontime >= 61 min                       exit
end
state up
begin
  flightprofile surfaced
  sensors       missiontime
  events
    case missiontime >= 1 h exit
end
)";

constexpr const char* kSurvey = R"(mission survey
require exit within 95 min
require always depth <= 30 m
require always dives <= 5
require never look after home
require stack <= 1
require reach hot

var dives : number = 0 in 0 .. 10

state look
begin
  flightprofile yo(5 m, 25 m, 26 deg, 26 deg)
  sensors       missiontime, depth, temp
  events
    case missiontime >= 1 h goto home
    case temp > 20 degC     call hot
    case dives < 5 && depth > 15 m do set dives = dives + 1 end stay
end

state hot
begin
  flightprofile yo(10 m, 25 m, 26 deg, 26 deg)
  sensors       statetime, depth, temp
  events
    case statetime >= 10 min return
end

state home
begin
  flightprofile surfaced
  sensors       statetime
  events
    case statetime >= 10 min exit
end
)";

/// Proved once.
const Issued& survey() {
  static const Issued issued = issue(kSurvey);
  return issued;
}

enum Requirements : uint32_t { kEnd, kDepth, kDives, kNever, kStack, kReach };

class Certificates : public testing::Test {
 protected:
  void SetUp() override {
    if (!solverIsInstalled()) {
      GTEST_SKIP() << "cvc5 is not installed";
    }
  }

  /// A certificate whose JSON `change` has changed.
  template <typename Change>
  static analysis::Rechecked changed(const Issued& issued, uint32_t requirement, Change change) {
    json file = json::parse(issued.file(requirement));
    change(file);
    return issued.rechecked(requirement, file.dump());
  }
};

TEST_F(Certificates, OfEveryKindOfRequirementAreAccepted) {
  const Issued& issued = survey();
  ASSERT_EQ(issued.findings.requirements.size(), 6U);
  for (uint32_t i = 0; i < 6; ++i) {
    const analysis::Rechecked found = issued.rechecked(i, issued.file(i));
    EXPECT_TRUE(found.accepted) << i << ": " << found.reason;
  }
}

TEST_F(Certificates, OfSurfacingsAreAcceptedButNoShorterOnes) {
  const Issued issued = issue(R"(mission survey
require surfaces every 198 min

state look
begin
  flightprofile yo(5 m, 25 m, 26 deg, 26 deg)
  sensors       missiontime, resumetime, depth
  events
    case missiontime >= 60 h goto home
    case resumetime > 3 h    call report
end

state report
begin
  flightprofile surfaced
  sensors       statetime, depth
  events
    case statetime >= 30 min return
end

state home
begin
  flightprofile surfaced
  sensors       statetime
  events
    case statetime >= 10 min exit
end
)");
  const analysis::Rechecked found = issued.rechecked(0, issued.file(0));
  EXPECT_TRUE(found.accepted) << found.reason;
  const analysis::Rechecked shorter = changed(issued, 0, [](json& file) {
    for (json& invariant : file["invariants"]) {
      invariant["formula"] =
          "(and (<= (- |time| |surfaced|) 9000.0) " + invariant["formula"].get<std::string>() + ")";
    }
  });
  EXPECT_FALSE(shorter.accepted);
}

TEST_F(Certificates, AWeakenedInvariantIsRefused) {
  const Issued& issued = survey();
  for (const uint32_t requirement : {kEnd, kDepth, kDives, kNever}) {
    json file = json::parse(issued.file(requirement));
    size_t refused = 0;
    for (json& invariant : file["invariants"]) {
      const json before = invariant["formula"];
      invariant["formula"] = "true";
      refused += issued.rechecked(requirement, file.dump()).accepted ? 0U : 1U;
      invariant["formula"] = before;
    }
    EXPECT_GT(refused, 0U) << "requirement " << requirement;
  }
}

TEST_F(Certificates, ANumberThatIsTooGoodIsRefused) {
  const Issued& issued = survey();
  const analysis::Rechecked found = changed(issued, kDives, [](json& file) {
    for (json& invariant : file["invariants"]) {
      invariant["formula"] = "(<= |var dives| 4.0)";
    }
  });
  EXPECT_FALSE(found.accepted);
}

TEST_F(Certificates, AConfigurationThatIsLeftOutIsRefused) {
  const Issued& issued = survey();
  for (const uint32_t requirement : {kEnd, kDepth, kNever, kStack}) {
    const size_t count = json::parse(issued.file(requirement))["invariants"].size();
    for (size_t i = 0; i < count; ++i) {
      const analysis::Rechecked found =
          changed(issued, requirement, [&](json& file) { file["invariants"].erase(i); });
      EXPECT_FALSE(found.accepted) << "requirement " << requirement << " without " << i;
    }
  }
}

/// An invariant that is false lets every step from it pass, but no step may lead to it.
TEST_F(Certificates, FalseEverywhereIsRefused) {
  const Issued& issued = survey();
  const analysis::Rechecked found = changed(issued, kDepth, [](json& file) {
    for (json& invariant : file["invariants"]) {
      invariant["formula"] = "false";
    }
  });
  EXPECT_FALSE(found.accepted);
  EXPECT_TRUE(found.reason.starts_with("not so: the start")) << found.reason;
}

TEST_F(Certificates, AFormulaCannotChangeTheQuestion) {
  const Issued& issued = survey();
  for (const char* formula :
       {"true) (reset", "true) (assert false", "(and true", "|dept|", "true ; comment",
        "(exists ((x Real)) true)", "(! true :named y)", "glider.t3", "", "true true"}) {
    const analysis::Rechecked found = changed(issued, kDepth, [&](json& file) {
      for (json& invariant : file["invariants"]) {
        invariant["formula"] = formula;
      }
    });
    EXPECT_FALSE(found.accepted) << formula;
  }
}

TEST_F(Certificates, OfAnotherMissionAreRefused) {
  const Issued& issued = survey();
  std::string other = kSurvey;
  other.replace(other.find("25 m"), 4, "26 m");
  const Issued elsewhere = issue(other);
  const analysis::Rechecked found = elsewhere.rechecked(kDives, issued.file(kDives));
  EXPECT_FALSE(found.accepted);
  EXPECT_EQ(found.reason, "it is about another mission or another vehicle");
}

TEST_F(Certificates, OfAnotherRequirementAreRefused) {
  const Issued& issued = survey();
  EXPECT_FALSE(issued.rechecked(kDives, issued.file(kNever)).accepted);
  EXPECT_FALSE(issued.rechecked(kReach, issued.file(kStack)).accepted);
  EXPECT_FALSE(issued.rechecked(kStack, issued.file(kReach)).accepted);
}

TEST_F(Certificates, ARunThatDoesNotReachTheStateIsRefused) {
  const Issued& issued = survey();
  const analysis::Rechecked found = changed(issued, kReach, [](json& file) {
    json& rows = file["run"]["rows"];
    const size_t columns = file["run"]["columns"].size();
    ASSERT_GT(rows.size(), columns);
    rows.erase(rows.end() - static_cast<json::difference_type>(columns), rows.end());
  });
  EXPECT_FALSE(found.accepted);
}

TEST_F(Certificates, DamagedFilesAreErrors) {  // refused: GL9381
  const Issued& issued = survey();
  const std::string good = issued.file(kDives);
  for (const auto& [from, to] : std::initializer_list<std::pair<std::string, std::string>>{
           {"{", "["},
           {"\"glidercc certificate\": 1", "\"glidercc certificate\": 2"},
           {"\"state\": \"hot\"", "\"state\": \"warm\""},
           {"\"method\": \"", "\"method\": \"un"},
           {"\"invariants\"", "\"invariant\""},
           {"\"justReturned\": true", "\"justReturned\": 1"}}) {
    std::string bad = good;
    ASSERT_NE(bad.find(from), std::string::npos) << from;
    bad.replace(bad.find(from), from.size(), to);
    const auto read = compiler::certificateFromJson(bad, "c.json", *issued.mission->checked);
    ASSERT_FALSE(read) << to;
    EXPECT_EQ(read.error().id, support::diagnostics::noCertificate);
  }
  EXPECT_TRUE(
      compiler::certificateFromJson(good, "c.json", *issued.mission->checked));  // accepts: GL9381
}

/// A solver that says less, or something else.
TEST_F(Certificates, OfASolverThatFailsNothingIsAccepted) {  // refused: GL9382
  const Issued& issued = survey();
  const auto certificate =
      compiler::certificateFromJson(issued.file(kDives), "c.json", *issued.mission->checked);
  ASSERT_TRUE(certificate);
  const std::string path = std::getenv("PATH");
  for (const char* solver : {"exit 0", "echo unsat; exit 0", "echo '(error \"x\")'", "exit 1"}) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "a_solver_that_fails";
    std::filesystem::create_directories(folder);
    ASSERT_TRUE(support::writeFileAtomically(folder / "cvc5",
                                             std::string("#!/bin/sh\n") + solver + "\n",
                                             support::FileKind::ExecutableProduct));
    ::setenv("PATH", (folder.string() + ":" + path).c_str(), 1);
    const auto found = analysis::recheck(*certificate, *issued.mission, kDives);
    ::setenv("PATH", path.c_str(), 1);
    ASSERT_FALSE(found) << solver;
    EXPECT_EQ(found.error().id, support::diagnostics::solverFailed);
  }
}

TEST_F(Certificates, WithoutTheSolverNothingIsAccepted) {  // refused: GL9380
  const Issued& issued = survey();
  const auto certificate =
      compiler::certificateFromJson(issued.file(kDives), "c.json", *issued.mission->checked);
  ASSERT_TRUE(certificate);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  const auto found = analysis::recheck(*certificate, *issued.mission, kDives);
  ::setenv("PATH", path.c_str(), 1);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().id, support::diagnostics::programNotStarted);
  EXPECT_TRUE(analysis::recheck(*certificate, *issued.mission, kDives));  // accepts: GL9380 GL9382
}

/// The questions themselves: another solver reads them, and Z3 answers them as the prover does.
TEST_F(Certificates, TheQuestionsCanBeAskedOfAnySolver) {
  const std::string text = compiler::chcText(*survey().mission->checked);
  const auto read = support::runProgram({analysis::kSolver, "--lang=smt2", "--parse-only"}, text);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->exit_code, 0) << read->text;
  const std::map<std::string, z3::check_result> expected = {
      {"require exit within 95 min", z3::sat},
      {"require always dives <= 5", z3::sat},
      {"require never look after home", z3::sat},
      {"require reach hot", z3::unsat}};
  size_t asked = 0;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find("(reset)\n", at), text.size());
    const std::string problem = text.substr(at, end - at);
    at = end + 8;
    const auto found = expected.find(problem.substr(2, problem.find('\n') - 2));
    if (found != expected.end()) {
      z3::context context;
      z3::solver solver(context, "HORN");
      solver.from_string(problem.c_str());
      EXPECT_EQ(solver.check(), found->second) << found->first;
      ++asked;
    }
  }
  EXPECT_EQ(asked, expected.size());
  EXPECT_TRUE(text.contains("; require stack <= 1: not a question about traces\n"));
}

/// Its second line would be read as a command.
TEST_F(Certificates, AQuestionOfTwoLinesHasACommentOfOne) {
  std::string text = kSurvey;
  const std::string one = "require always dives <= 5";
  text.replace(text.find(one), one.size(), "require always dives <= 5 &&\n  dives >= 0");
  const std::string asked = compiler::chcText(*issue(text).mission->checked);
  EXPECT_TRUE(asked.contains("\n; require always dives <= 5 && dives >= 0\n(set-logic HORN)\n"));
}

TEST(Program, GivesWhatItWroteAndHowItEnded) {
  const auto output = support::runProgram({"sh", "-c", "cat; exit 3"}, "a line\n");
  ASSERT_TRUE(output);
  EXPECT_EQ(output->text, "a line\n");
  EXPECT_EQ(output->exit_code, 3);
  const auto killed = support::runProgram({"sh", "-c", "kill -9 $$"}, "");
  ASSERT_TRUE(killed);
  EXPECT_EQ(killed->exit_code, 128 + 9);
  const std::string much(1 << 20, 'x');
  EXPECT_EQ(support::runProgram({"cat"}, much)->text, much);
}

/// Accepted; without the assumption that it names refused.
void expectToRestOn(const std::string& assumption, const std::string& requirement,
                    const std::string& body) {
  const Issued issued =
      issue("mission m\nassume " + assumption + "\nrequire " + requirement + "\n" + body);
  ASSERT_EQ(issued.findings.requirements.at(0).verdict, ir::prove::Verdict::Proved) << assumption;
  const std::string file = issued.file(0);
  const bool named = json::parse(file)["assumptions"].size() == 1;
  const analysis::Rechecked whole = issued.rechecked(0, file);
  EXPECT_TRUE(whole.accepted) << assumption << ": " << whole.reason;
  json without = json::parse(file);
  without["assumptions"] = json::array();
  EXPECT_EQ(issued.rechecked(0, without.dump()).accepted, !named) << assumption;
  json other = json::parse(file);
  other["assumptions"] = {"no such thing"};
  EXPECT_FALSE(compiler::certificateFromJson(other.dump(), "c.json", *issued.mission->checked));
  other["subject"] = "another";
  const analysis::Rechecked refused = issued.rechecked(0, other.dump());
  EXPECT_EQ(refused.reason, "it is about another mission or another vehicle");
}

/// A mission that assumes a deeper start is checked with that start, also for a certificate that
/// does not name the assumption.
TEST_F(Certificates, OfTheUsualStartAreRefusedWhereADeeperOneIsAssumed) {
  const std::string rest = std::string("require always depth <= 35 m\n") + kPatrol;
  const Issued usual = issue("mission m\n" + rest);
  const Issued deeper = issue("mission m\nassume start depth <= 50 m\n" + rest);
  ASSERT_TRUE(usual.rechecked(0, usual.file(0)).accepted);
  json file = json::parse(usual.file(0));
  file["subject"] = *compiler::subjectOf(*deeper.mission->checked);
  EXPECT_FALSE(deeper.rechecked(0, file.dump()).accepted);
}

/// A dive of a minute that the clock ends: how deep it leads depends on when that is obeyed.
constexpr const char* kMinute = R"(
assume no outage
state down
begin
  flightprofile yo(5 m, 90 m, 26 deg, 26 deg)
  sensors       statetime, depth
  events
    case statetime >= 60 s goto up
end
state up
begin
  flightprofile surfaced
  sensors       statetime, depth
  events
    case statetime >= 30 min exit
end
)";

/// An SBC that sleeps is obeyed 15 s later: both checks count with that, each by its own rules.
TEST_F(Certificates, OfAnSbcThatAlwaysRunsAreRefusedForOneThatSleeps) {
  const std::string usual_limit = "mission m\nrequire always depth <= 51 m\n";
  const std::string nap = "nap at most 4 min\n";
  const Issued usual = issue(usual_limit + kMinute);
  const Issued sleeps = issue(usual_limit + nap + kMinute);
  const Issued deeper = issue("mission m\nrequire always depth <= 57 m\n" + nap + kMinute);
  ASSERT_TRUE(usual.rechecked(0, usual.file(0)).accepted);
  EXPECT_NE(sleeps.findings.requirements.at(0).verdict, ir::prove::Verdict::Proved);
  json file = json::parse(usual.file(0));
  file["subject"] = *compiler::subjectOf(*sleeps.mission->checked);
  const analysis::Rechecked forged = sleeps.rechecked(0, file.dump());
  EXPECT_FALSE(forged.accepted);
  const analysis::Rechecked found = deeper.rechecked(0, deeper.file(0));
  EXPECT_TRUE(found.accepted) << found.reason;
}

/// The second check makes the assumptions that the certificate names, and no others.
TEST_F(Certificates, RestOnTheAssumptionsThatTheyName) {
  expectToRestOn("no outage", "exit within 62 min", kPatrol);
  expectToRestOn("start depth <= 1 m", "always depth <= 29.5 m", kPatrol);
  expectToRestOn("altitude in 10 m .. 100 m", "never up", kPatrol);
  expectToRestOn("altitude >= 10 m", "never up", kPatrol);
  expectToRestOn("known altitude every 30 s", "exit within 6 min", R"(resume within 20 s
state look
begin
  flightprofile yo(5 m, 25 m, 26 deg, 26 deg)
  sensors       missiontime, altitude
  events
    case missiontime >= 5 min && known(altitude) exit
end
)");
}

}  // namespace
}  // namespace glider::tests
