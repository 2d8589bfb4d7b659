// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What `check` keeps of its proofs, and when it trusts it.

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
const Verdicts kKept = {"proved, kept", "undecided, kept", "refuted"};

TEST_F(ProofCache, WhatIsProvedOrUndecidedIsNotSearchedForAgain) {
  EXPECT_EQ(verdicts(), kSearched);
  EXPECT_EQ(files().size(), 2U) << "what is refuted is not kept";
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

TEST_F(ProofCache, AnotherMissionOrEffortIsAnotherQuestion) {
  EXPECT_EQ(verdicts(), kSearched);
  EXPECT_EQ(verdicts("--effort 2"), kSearched);
  EXPECT_EQ(verdicts("--no-cache"), kSearched);
  mission(counting(2));
  EXPECT_EQ(verdicts(), (Verdicts{"refuted", "undecided", "refuted"}));
  mission(counting(3));
  EXPECT_EQ(verdicts(), kKept);
}

TEST_F(ProofCache, ADamagedFileIsNone) {
  (void)check();
  for (const auto& path : files()) {
    const std::string whole = slurp(path);
    const auto with = [&](const std::string& text) {
      std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
      const Verdicts found = verdicts();
      EXPECT_EQ(std::ranges::count(found, "proved") + std::ranges::count(found, "undecided"), 1)
          << text;
      EXPECT_EQ(slurp(path), whole) << "it is written again";
    };
    with("");
    with(whole.substr(0, whole.size() / 2));
    with(whole + "more");
    std::string other = whole;
    const bool proved = other.contains("\nproved\n");
    const std::string word = proved ? "\nproved\n" : "\nundecided\n";
    other.replace(other.find(word), word.size(), proved ? "\nundecided\n" : "\nproved\n");
    with(other);
    with(std::string(100000, 'x'));
  }
  const auto both = files();
  ASSERT_EQ(both.size(), 2U);
  std::ofstream(both[0], std::ios::binary | std::ios::trunc) << slurp(both[1]);
  const Verdicts swapped = verdicts();
  EXPECT_EQ(std::ranges::count(swapped, "proved") + std::ranges::count(swapped, "undecided"), 1);
}

TEST_F(ProofCache, OneThatCannotBeWrittenIsNotAnError) {
  (void)folder_.write("cache", "a file in its place");
  EXPECT_EQ(check().err, "");
  EXPECT_EQ(verdicts(), kSearched);
}

}  // namespace
}  // namespace glider::tests
