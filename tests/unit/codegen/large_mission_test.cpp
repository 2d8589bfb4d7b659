// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The work of codegen grows no faster than the mission.

#include "codegen/llvm/llvm.h"
#include "codegen/llvm/program/parts.h"
#include "codegen/llvm/program/work.h"
#include "tests/unit/codegen/compiled_mission.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <gmock/gmock.h>
#include <numeric>
#include <vector>

namespace glider::codegen_tests {
namespace {

/// A chain of `states` states, each with two guards.
std::string chain(size_t states) {
  std::string text =
      "glider_ir 1\nmission chain platform slocum\n"
      "sensor depth: length vehicle m_depth id 2 encoding linear to_si 1 lowest -10 highest 1000 "
      "stale_after 20\n"
      "behaviour profile surfaced symbol \"glider.profile.surfaced\" () reads ()\n"
      "behaviour route noheading symbol \"glider.route.noheading\" () reads ()\n";
  for (size_t i = 0; i < states; ++i) {
    text += fmt::format(
        "state s{}\n  route noheading ()\n  profile surfaced ()\n"
        "  case (gt (sensor depth) {}:length) goto s{}\n  case (ge missiontime 9999:time) exit\n",
        i, i % 500, (i + 1) % states);
  }
  return text;
}

TEST(Parts, AreOfAboutTheSameWork) {
  const std::pair<size_t, size_t> counts[] = {{1, 1}, {2, 2}, {63, 2}, {64, 8}, {200, 8}};
  for (const auto& [states, parts] : counts) {
    SCOPED_TRACE(states);
    const Checked checked = checkedMission(chain(states));
    const auto found = codegen::partsOf(checked.mission);
    ASSERT_EQ(found.size(), parts);
    std::vector<uint32_t> wholes, ticks;
    size_t least = SIZE_MAX, most = 0, greatest = 0;
    for (size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].head, i == 0);
      size_t work = 0;
      for (const uint32_t state : found[i].states) {
        wholes.push_back(state);
        work += codegen::workOfState(checked.mission, state);
        greatest = std::max(greatest, codegen::workOfState(checked.mission, state));
      }
      for (const uint32_t state : found[i].profiles) {
        ticks.push_back(state);
        work += codegen::workOfProfileTick(checked.mission, state);
      }
      least = std::min(least, work);
      most = std::max(most, work);
    }
    std::vector<uint32_t> all(states);
    std::iota(all.begin(), all.end(), 0U);
    EXPECT_THAT(wholes, testing::UnorderedElementsAreArray(all));
    EXPECT_THAT(ticks, testing::UnorderedElementsAreArray(all));
    EXPECT_LE(most - least, parts == 1 ? 0 : greatest);
  }
}

double secondsToEmit(size_t states) {
  const Checked checked = checkedMission(chain(states));
  const std::clock_t begin = std::clock();
  EXPECT_TRUE(codegen::emitObject(checked.input(), board("ts7800"), {}));
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

TEST(LargeMissions, CompileInLinearTime) {
  secondsToEmit(10);  // first use of the code generator
  const double few = secondsToEmit(200);
  const double many = secondsToEmit(1600);
  EXPECT_LT(many, 8 * few * 2) << few << " s for 200 states, " << many << " s for 1600";
}

}  // namespace
}  // namespace glider::codegen_tests
