// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What `check` keeps of its proofs: only what proves the requirement again counts.

#include "tests/support/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

using testing::HasSubstr;

/// One promise that is searched for and kept, one that is undecided, one that is refuted.
std::string counting(int most) {
  return "mission count\n"
         "var n : number = 0 in 0 .. 9\n"
         "require always n <= " +
         std::to_string(most) +
         "\n"
         "require always inside(39 N 74 W, 39 N 73.5 W, 39.4 N 73.5 W)\n"
         "require always temp < 20 degC\n"
         "state look\nbegin\n  flightroute nav(39.1 N, 73.6 W)\n"
         "  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n  sensors missiontime, depth, temp\n"
         "  events\n    case n < 3 && temp > 4 degC do set n = min(n + 1, 3) end stay\n"
         "    case missiontime >= 5 h exit\nend\n";
}

class ProofCache : public testing::Test {
 protected:
  ProofCache() { mission(counting(3)); }

  void mission(const std::string& text) { (void)folder_.write("count.mission", text); }

  Outcome check(const std::string& more = "") const {
    return runShell("cd " + folder_.path().string() +
                    " && XDG_CACHE_HOME=$PWD/cache $GLIDERCC check --format json " + more +
                    " count.mission");
  }

  /// Of each requirement its verdict, and whether an earlier check knew it: "proved, kept".
  std::vector<std::string> verdicts(const std::string& more = "") const {
    std::vector<std::string> all;
    const auto document = nlohmann::json::parse(check(more).out);
    for (const auto& one : document["missions"][0]["requirements"]) {
      all.push_back(one["verdict"].get<std::string>() + (one.contains("kept") ? ", kept" : ""));
    }
    return all;
  }

  std::vector<std::filesystem::path> files() const {
    std::vector<std::filesystem::path> found;
    const auto folder = folder_.path() / "cache" / "glidercc" / "proofs";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      found.push_back(entry.path());
    }
    return found;
  }

  const TemporaryFolder folder_;
};

using Verdicts = std::vector<std::string>;
const Verdicts kSearched = {"proved", "undecided", "refuted"};
const Verdicts kKept = {"proved, kept", "undecided", "refuted"};

TEST_F(ProofCache, WhatIsProvedIsNotSearchedForAgain) {
  EXPECT_EQ(verdicts(), kSearched);
  EXPECT_EQ(files().size(), 1U) << "what is undecided or refuted is not kept";
  EXPECT_EQ(verdicts(), kKept);
}

TEST_F(ProofCache, TheTextOutputReportsIt) {
  const auto told = [&] {
    return runShell("cd " + folder_.path().string() +
                    " && XDG_CACHE_HOME=$PWD/cache $GLIDERCC check --report --target ts7800 "
                    "count.mission");
  };
  const Outcome first = told();
  EXPECT_THAT(first.out, HasSubstr("\nproved: require always n <= 3\n"));
  const Outcome again = told();
  EXPECT_THAT(again.out, HasSubstr("\nproved by an earlier check: require always n <= 3\n"));
  EXPECT_EQ(again.err, first.err) << "it says the same of the one that is undecided";
  EXPECT_EQ(again.status, first.status);
}

TEST_F(ProofCache, AnotherMissionIsAnotherQuestion) {
  EXPECT_EQ(verdicts(), kSearched);
  EXPECT_EQ(verdicts("--no-cache"), kSearched);
  mission(counting(2));
  EXPECT_EQ(verdicts(), (Verdicts{"refuted", "undecided", "refuted"}));
  mission(counting(3));
  EXPECT_EQ(verdicts(), kKept);
}

TEST_F(ProofCache, AFileThatProvesNothingIsWrittenAgain) {
  (void)check();
  const auto path = files().at(0);
  const std::string whole = slurp(path);
  const auto with = [&](const std::string& text) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
    EXPECT_EQ(verdicts(), kSearched) << text;
    EXPECT_EQ(slurp(path), whole);
  };
  with("");
  with(whole.substr(0, whole.size() / 2));
  with(std::string(2000000, 'x'));
  for (const char* formula : {"true", "false", "(= 0.0 |time|)", ")(check-sat)("}) {
    auto changed = nlohmann::json::parse(whole);
    for (auto& invariant : changed["invariants"]) {
      invariant["formula"] = formula;
    }
    with(changed.dump());
  }
  auto none = nlohmann::json::parse(whole);
  none["invariants"] = nlohmann::json::array();
  with(none.dump());
}

/// The cache is only a file: anybody may write a proof of anything into it.
TEST_F(ProofCache, AForgedProofOfAFalseRequirementIsRefuted) {
  (void)check();
  const auto path = files().at(0);
  const auto certificate = nlohmann::json::parse(slurp(path));
  const auto named = runShell("printf '2\\n" + certificate["subject"].get<std::string>() +
                              "' | sha256sum | cut -c 1-64 | tr -d '\\n'");
  const auto mine = runShell("printf '0\\n" + certificate["subject"].get<std::string>() +
                             "' | sha256sum | cut -c 1-64 | tr -d '\\n'");
  ASSERT_EQ(mine.out, path.filename().string()) << "files are named as this test believes";
  for (const char* formula : {"true", "false"}) {
    auto forged = certificate;
    for (auto& invariant : forged["invariants"]) {
      invariant["formula"] = formula;
    }
    std::ofstream(path.parent_path() / named.out) << forged.dump();
    EXPECT_EQ(verdicts(), kKept) << formula;
  }
}

/// While an assumption is an error, nothing is proved from it: not by a file of the cache either.
TEST_F(ProofCache, AProofFromAnAssumptionThatIsAnErrorIsNotRecalled) {
  mission(
      "mission count\nassume missiontime <= 30 min\nvar n : number = 0 in 0 .. 5\n"
      "require always missiontime <= 31 min\nrequire always n <= 4\n"
      "state look\nbegin\n  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
      "  sensors missiontime, depth, temp\n  events\n"
      "    case temp > 20 degC && n < 4 do set n = n + 1 end call up\nend\n"
      "state up\nbegin\n  flightprofile yo(5 m, 10 m, 26 deg, 26 deg)\n"
      "  sensors depth, temp\n  events\n    case temp < 18 degC return\nend\n");
  (void)check();
  ASSERT_EQ(files().size(), 1U);
  const auto path = files().at(0);
  auto forged = nlohmann::json::parse(slurp(path));
  ASSERT_EQ(forged["requirement"], "require always n <= 4");
  const auto first = runShell("printf '0\n" + forged["subject"].get<std::string>() +
                              "' | sha256sum | cut -c 1-64 | tr -d '\n'");
  forged["requirement"] = "require always missiontime <= 31 min";
  forged["assumptions"] = {"missiontime <= 30 min"};
  std::ofstream(path.parent_path() / first.out) << forged.dump();
  EXPECT_EQ(verdicts(), (Verdicts{"undecided", "proved, kept"}));
}

/// What the first check says that a proof rests on, the next one says too.
TEST_F(ProofCache, PremisesAreTheSameWithIt) {
  std::string text = counting(3);
  text.replace(text.find("require always n <= 3"), 21,
               "assume temp in 2 degC .. 28 degC\n"
               "require always n <= 0 || sofar <= 28 degC\n"
               "var sofar : temperature = 2 degC in -5 degC .. 45 degC");
  text.replace(text.find("set n = min(n + 1, 3)"), 21, "set n = min(n + 1, 3) set sofar = temp");
  mission(text);
  const auto premises = [&](const std::string& more) {
    const auto document = nlohmann::json::parse(check(more).out);
    const auto& one = document["missions"][0]["requirements"][0];
    return one["verdict"].get<std::string>() + (one.contains("kept") ? ", kept" : "") + ": " +
           one.value("premise", "none");
  };
  const std::string first = premises("");
  EXPECT_THAT(first, HasSubstr("proved: assuming"));
  EXPECT_EQ(premises("--no-cache"), first);
  EXPECT_EQ(premises(""), "proved, kept" + first.substr(6));
}

TEST_F(ProofCache, OneThatCannotBeWrittenIsNotAnError) {
  (void)folder_.write("cache", "a file in its place");
  EXPECT_EQ(check().err, "");
  EXPECT_EQ(verdicts(), kSearched);
}

}  // namespace
}  // namespace glider::tests
