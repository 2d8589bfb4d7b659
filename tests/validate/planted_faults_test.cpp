// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Whether the comparison sees faults: those of a wrong lowering, planted before the passes run, and
// those of a wrong pass, planted after. GLIDER_FAULTS_COUNT and GLIDER_FAULTS_SEED widen it:
// scripts/soak/validate.

#include "compiler/compilation.h"
#include "tests/random_missions/random.h"
#include "tests/validate/built.h"
#include "tests/validate/faults.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace glider::validate_test {
namespace {

/// What a fault in a mission's code was, and what the comparison said.
struct Planted {
  std::string words;
  std::string found;
};

Planted plant(const codegen::Input& input, const char* board, bool in_pass, uint64_t draw) {
  Planted planted;
  const auto change = [&](llvm::Module& module) {
    planted.words = plantFault(module, draw % faultsIn(module));
  };
  planted.found = whatIsNotSame(in_pass ? validate(input, board, 2, {}, change)
                                        : validate(input, board, 2, change));
  return planted;
}

/// Faults that change nothing, seen by reading the code: what differs cannot happen.
constexpr double kHarmless = 0.1;

class PlantedFaults : public testing::TestWithParam<const char*> {};

TEST_P(PlantedFaults, AreFound) {
  const std::string path = fmt::format("{}/missions/{}.mission", GLIDER_SOURCE_DIR, GetParam());
  const auto compilation = compiler::compileMission(path);
  ASSERT_TRUE(compilation && compilation->checked);
  const compiler::Optimised mission = compiler::optimise(compilation->checked);
  random_missions::Random random(setting("GLIDER_FAULTS_SEED", 1));
  const uint64_t count = setting("GLIDER_FAULTS_COUNT", 8);
  uint64_t missed = 0;
  for (uint64_t i = 0; i < count; ++i) {
    const char* board = i % 4 < 2 ? "host" : "ts7800";
    const Planted planted = plant(mission.input(), board, i % 2 == 0, random.below(1U << 30U));
    if (planted.found.empty()) {
      ++missed;
      std::printf("not found on %s: %s\n", board, planted.words.c_str());
    }
  }
  EXPECT_LE(static_cast<double>(missed), kHarmless * static_cast<double>(count));
}

INSTANTIATE_TEST_SUITE_P(Missions, PlantedFaults,
                         testing::Values("figure2", "gallery/thermocline", "gallery/survey_box",
                                         "gallery/bloom"),
                         [](const auto& param) {
                           std::string name = param.param;
                           return name.substr(name.find('/') + 1);
                         });

}  // namespace
}  // namespace glider::validate_test
