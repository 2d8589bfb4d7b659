// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Patterns of requirements that SPIN can be asked about too: those about which states follow which,
// without times. On random missions without calls SPIN and the prover give the same verdicts.

#include "ir/prove/prove.h"
#include "ir/verify/promela.h"
#include "ir/verify/verify.h"
#include "platforms/load/load_platform.h"
#include "tests/support/command.h"
#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

constexpr unsigned kStates = 5;
constexpr int kMissions = 12;

const std::vector<std::string>& patterns() {
  static const std::vector<std::string> all = {"never s1", "never s1 before s2",
                                               "never s1 after s2", "visit s1 at most 1 times",
                                               "visit s1 at most 2 times"};
  return all;
}

/// What each pattern forbids, by its number, when a state is entered that was not current.
constexpr const char* kPatternObserver = R"(
c_decl {
\#include <stdio.h>
static char told[8];
static void violated(int number) {
  if (!told[number]) {
    printf("violated %d\n", number);
  }
  told[number] = 1;
}
}
byte last = 255;
byte visits = 0;
bool seen = false;
#define REACHED(mission, state) d_step { \
  if \
  :: last != state && state == 1 -> \
    visits = (visits < 3 -> visits + 1 : 3); \
    c_code { violated(0); if (!now.seen) violated(1); if (now.seen) violated(2); \
             if (now.visits > 1) violated(3); if (now.visits > 2) violated(4); } \
  :: last != state && state == 2 -> seen = true \
  :: else -> skip \
  fi; \
  last = state }
)";

/// Each state goes to some of the others, for readings that may be anything.
std::string randomMission(std::mt19937& rng) {
  std::string text = "mission m\n";
  for (const std::string& pattern : patterns()) {
    text += "require " + pattern + "\n";
  }
  for (unsigned state = 0; state < kStates; ++state) {
    text += fmt::format("state s{}\nbegin\n  flightprofile surfaced\n  sensors temp\n  events\n",
                        state);
    for (unsigned to = 1; to < kStates; ++to) {
      if (to != state && rng() % 3 == 0) {
        text += fmt::format("    case temp > {} degC && temp < {} degC goto s{}\n", to, to + 1, to);
      }
    }
    text += "    case temp > 20 degC exit\nend\n";
  }
  return text;
}

std::vector<bool> violatedBySpin(const ir::Mission& mission) {
  const TemporaryFolder folder;
  const std::string model =
      folder.write("model.pml", kPatternObserver + ir::promela(mission)).string();
  const Outcome outcome = runShell("cd " + folder.path().string() + " && spin -a " + model +
                                   " >spin.txt && gcc -w -DSAFETY -o pan pan.c && "
                                   "./pan -m100000 >found.txt && cat found.txt");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("errors: 0"), std::string::npos) << outcome.out;
  std::vector<bool> violated;
  for (size_t i = 0; i < patterns().size(); ++i) {
    violated.push_back(outcome.out.find(fmt::format("violated {}\n", i)) != std::string::npos);
  }
  return violated;
}

TEST(SpinPatterns, AgreeWithTheProver) {
  const auto platform = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
  ASSERT_TRUE(platform.has_value());
  std::mt19937 rng(3);
  std::vector<int> violated(patterns().size());
  for (int i = 0; i < kMissions; ++i) {
    frontend::testing_support::FrontendRun run(randomMission(rng));
    const auto mission = run.compile();
    ASSERT_TRUE(mission.has_value()) << run.said();
    const ir::MissionFacts facts = ir::verify(*mission, run.diagnostics);
    const auto findings = ir::prove::prove(*mission, facts, *platform, {}, run.diagnostics);
    const std::vector<bool> spin = violatedBySpin(*mission);
    for (size_t k = 0; k < patterns().size(); ++k) {
      EXPECT_EQ(ir::prove::word(findings.requirements.at(k).verdict) + std::string(),
                spin[k] ? "refuted" : "proved")
          << patterns()[k] << "\n"
          << ir::promela(*mission);
      violated[k] += spin[k] ? 1 : 0;
    }
  }
  for (size_t k = 0; k < patterns().size(); ++k) {
    EXPECT_GT(violated[k], 0) << patterns()[k];
    EXPECT_LT(violated[k], kMissions) << patterns()[k];
  }
}

}  // namespace
}  // namespace glider::tests
