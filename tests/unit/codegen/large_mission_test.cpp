// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The work of codegen grows no faster than the mission.

#include "tests/unit/codegen/compiled_mission.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ctime>

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

double secondsToEmit(size_t states) {
  const Checked checked = checkedMission(chain(states));
  const std::clock_t begin = std::clock();
  EXPECT_TRUE(codegen::emitObject(checked.mission, checked.facts, board("ts7800"), {}));
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
