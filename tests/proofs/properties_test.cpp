// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The example missions with one requirement more, each with the verdict that properties.txt was
// committed with; what is proved survives random flights.

#include "ir/prove/ground.h"
#include "ir/prove/prove.h"
#include "ir/prove/random_flight.h"
#include "ir/verify/verify.h"
#include "support/check.h"
#include "tests/unit/frontend/compile.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace glider::ir::prove {
namespace {

struct Property {
  std::string mission, verdict, requirement;
  /// For the test's name.
  friend void PrintTo(const Property& property, std::ostream* out) { *out << property.requirement; }
};

std::string trimmed(const std::string& text) {
  const size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::vector<Property> properties() {
  std::ifstream file(GLIDER_SOURCE_DIR "/tests/proofs/properties.txt");
  std::vector<Property> all;
  for (std::string line; std::getline(file, line);) {
    std::istringstream in(line);
    Property one;
    if (line.starts_with('#')) {
      continue;
    }
    std::getline(in, one.mission, '|');
    std::getline(in, one.verdict, '|');
    std::getline(in, one.requirement);
    all.push_back({trimmed(one.mission), trimmed(one.verdict), trimmed(one.requirement)});
  }
  CHECK(all.size() > 50, "properties.txt has lost its lines");
  return all;
}

const platforms::Platform& slocum() {
  static const auto platform = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
  return *platform;
}

class Properties : public testing::TestWithParam<Property> {};

/// scripts/soak/proofs asks for more.
uint64_t flightsToFly() {
  constexpr uint64_t kFew = 3;
  const char* wanted = std::getenv("GLIDER_PROOF_FLIGHTS");
  return wanted == nullptr ? kFew : std::stoull(wanted);
}

/// What random flights make of it.
void expectSurvives(const Mission& mission, const MissionFacts& facts) {
  constexpr size_t kTicks = 4000;
  const uint64_t flights = flightsToFly();
  const Ground ground(mission, slocum());
  for (uint64_t seed = 1; seed <= flights; ++seed) {
    const auto broken =
        flyAtRandom(ground, facts.stack_depth, mission.requirements[0], seed, kTicks);
    EXPECT_FALSE(broken.has_value()) << "seed " << seed << " at " << broken->when << " s";
  }
}

TEST_P(Properties, IsDecidedAsCommitted) {
  const Property& property = GetParam();
  frontend::testing_support::FrontendRun run(
      frontend::testing_support::readSource("missions/" + property.mission + ".mission") +
      "require " + property.requirement + "\n");
  const auto mission = run.compile();
  ASSERT_TRUE(mission.has_value()) << run.said();
  const MissionFacts facts = verify(*mission, run.diagnostics);
  const Findings findings = prove(*mission, facts, slocum(), {}, run.diagnostics);
  ASSERT_EQ(findings.requirements.size(), 1U);
  EXPECT_EQ(word(findings.requirements[0].verdict), property.verdict) << run.said();
  const bool reach = mission->requirements[0].kind == RequirementKind::Reach;
  if (findings.requirements[0].verdict == Verdict::Proved && !reach) {
    expectSurvives(*mission, facts);
  }
}

std::string nameOf(const testing::TestParamInfo<Property>& info) {
  std::string name = std::to_string(info.index) + "_" + info.param.mission;
  for (char& c : name) {
    c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Missions, Properties, testing::ValuesIn(properties()), nameOf);

}  // namespace
}  // namespace glider::ir::prove
