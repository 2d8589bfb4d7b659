// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Which missions may dive so steeply that the vehicle goes farther past a depth.

#include "compiler/compilation.h"
#include "compiler/proving.h"

#include <gtest/gtest.h>

#include <string>

namespace glider::compiler {
namespace {

/// The overshoot that proofs of a mission with this entry, in a profile that is given a pitch,
/// count with.
double overshootOf(const std::string& entry, const std::string& pitch = "26 deg",
                   const std::string& declarations = "") {
  const auto compiled = compileText(
      "m.mission", "mission m\n" + declarations +
                       "\nflightprofile p(pitched: angle) begin\n entry do " + entry +
                       " end\nend\nstate s begin\n flightprofile p(" + pitch +
                       ")\n sensors missiontime\n events\n case missiontime > 1 h exit\nend\n");
  EXPECT_TRUE(compiled && compiled->lowered) << entry;
  return compiled->lowered->platform.envelope.inflection_overshoot_m;
}

TEST(SteepPitch, CountsWhereItMayBeCommanded) {
  EXPECT_EQ(overshootOf("descend(30 m, 26 deg)"), 5);
  EXPECT_EQ(overshootOf("descend(30 m, 36 deg)"), 5);
  EXPECT_EQ(overshootOf("descend(30 m, 36.1 deg)"), 6.5);
  EXPECT_EQ(overshootOf("ascend(3 m, 40 deg)"), 6.5) << "it comes down from there too";
  EXPECT_EQ(overshootOf("surface()"), 5);
}

TEST(SteepPitch, IsWhateverTheRangeAllows) {
  const std::string dive = "descend(30 m, pitched)";
  EXPECT_EQ(overshootOf(dive, "given", "param given: angle = 26 deg in 20 deg .. 30 deg"), 5);
  EXPECT_EQ(overshootOf(dive, "given", "param given: angle = 26 deg in 20 deg .. 40 deg"), 6.5);
  EXPECT_EQ(overshootOf(dive, "given", "param given: angle = 26 deg"), 6.5) << "it has no range";
}

/// A dive to 30 m at 45 degrees went to 35.8 m in the simulator.
TEST(SteepPitch, ProofsCountWithIt) {
  const auto verdict = [](const std::string& pitch) {
    const auto compiled =
        compileText("m.mission",
                    "mission m\nrequire always depth <= 35 m\nstate s begin\n flightprofile "
                    "yo(5 m, 30 m, " +
                        pitch + ", " + pitch +
                        ")\n sensors missiontime\n events\n case missiontime > 1 h exit\nend\n");
    EXPECT_TRUE(compiled && compiled->checked);
    support::DiagnosticEngine unheard;
    return prove(*compiled->checked, {}, unheard).requirements.at(0).verdict;
  };
  EXPECT_EQ(verdict("36 deg"), ir::prove::Verdict::Proved);
  EXPECT_EQ(verdict("45 deg"), ir::prove::Verdict::Refuted);
}

TEST(SteepPitch, MayBeThatOfThePitchBattery) {
  EXPECT_EQ(overshootOf("pump(-200 cc) battery(0.1 inch)"), 6.5);
}

}  // namespace
}  // namespace glider::compiler
