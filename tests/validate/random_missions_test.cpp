// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Random missions, built for a board and compared with what they mean. GLIDER_VALIDATE_COUNT and
// GLIDER_VALIDATE_SEED widen it: scripts/soak/validate.

#include "ir/opt/passes.h"
#include "ir/verify/verify.h"
#include "platforms/load/load_platform.h"
#include "support/diagnostics/engine.h"
#include "tests/random_missions/random_mission.h"
#include "tests/validate/built.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <tuple>

namespace glider::validate_test {
namespace {

class RandomMissionsValidated : public testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(RandomMissionsValidated, CodeDoesWhatTheyMean) {
  const auto [board, level] = GetParam();
  const auto platform =
      platforms::loadPlatform(GLIDER_BINARY_DIR "/share/glidercc/platforms/slocum.toml");
  ASSERT_TRUE(platform);
  const uint64_t first = setting("GLIDER_VALIDATE_SEED", 1);
  const uint64_t count = setting("GLIDER_VALIDATE_COUNT", 1);
  for (uint64_t seed = first; seed < first + count; ++seed) {
    ir::Mission mission = random_missions::flownMission(seed);
    if (seed % 2 == 1) {
      mission = ir::optimise(std::move(mission));
    }
    if (level > 1) {
      ir::opt::tabulateGuards(mission);
    }
    if (seed % 3 == 0) {
      mission.nap_s = 240;
    }
    support::DiagnosticEngine diagnostics;
    const ir::MissionFacts facts = ir::verify(mission, diagnostics);
    const auto found = validate({mission, *platform, facts.stack_depth}, board, level);
    ASSERT_EQ(whatIsNotSame(found), "") << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Boards, RandomMissionsValidated,
                         testing::Values(std::tuple("host", 0), std::tuple("host", 2),
                                         std::tuple("ts7800", 2), std::tuple("ts5500", 1),
                                         std::tuple("cm4", 2)),
                         [](const auto& param) {
                           return fmt::format("{}_O{}", std::get<0>(param.param),
                                              std::get<1>(param.param));
                         });

}  // namespace
}  // namespace glider::validate_test
