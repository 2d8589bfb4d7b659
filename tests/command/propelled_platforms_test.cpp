// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The two vehicles with a propeller, as a pilot meets them before they are flown.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

class PropelledPlatforms : public ::testing::TestWithParam<const char*> {
 protected:
  /// A yo with `commands` as another profile's, checked.
  [[nodiscard]] Outcome check(const std::string& yo, const std::string& entry) const {
    (void)folder_.write(
        "m.mission",
        std::string("mission m\nplatform ") + GetParam() +
            "\nrequire always depth <= 30 m\nflightprofile other\nbegin\n  entry do " + entry +
            " end\nend\nstate s\nbegin\n  flightprofile " + yo +
            "\n  flightroute heading(90 deg)\n"
            "  sensors missiontime, depth, altitude, temp, salinity\n  events\n"
            "    case altitude < 5 m exit\n    case temp > 20 degC goto t\n"
            "    case missiontime >= 20 min exit\nend\n"
            "state t\nbegin\n  flightprofile other\n  flightroute heading(0 deg)\n"
            "  sensors missiontime, depth\n  events\n    case missiontime >= 20 min exit\nend\n");
    return runShell("cd " + folder_.path().string() + " && $GLIDERCC check m.mission");
  }
  const TemporaryFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(Vehicles, PropelledPlatforms, ::testing::Values("lauv", "remus100"),
                         [](const auto& each) { return std::string(each.param); });

TEST_P(PropelledPlatforms, AMissionIsCheckedByItsLimits) {
  const Outcome fine = check("yo(5 m, 20 m)", "descend(15 m, 1.2 m/s)");
  EXPECT_EQ(fine.status, 0) << fine.out << fine.err;
  EXPECT_THAT(fine.out, HasSubstr("1 requirement proved")) << fine.err;
  const Outcome deep = check("yo(5 m, 120 m)", "descend(15 m, 1.2 m/s)");
  EXPECT_EQ(deep.status, 1);
  EXPECT_THAT(deep.out + deep.err, HasSubstr("GL3104"));
  const Outcome fast = check("yo(5 m, 20 m, 2.6 m/s)", "descend(15 m, 1.2 m/s)");
  EXPECT_EQ(fast.status, 1);
  EXPECT_THAT(fast.out + fast.err, HasSubstr("GL3104"));
}

TEST_P(PropelledPlatforms, WhatOnlyAGliderHasCannotBeCommanded) {
  for (const auto& [name, arguments] : {std::pair{"pump", "(20 cc)"},
                                        {"battery", "(0.2 inch)"},
                                        {"hover", "(10 m)"},
                                        {"fin", "(10 deg)"}}) {
    const Outcome refused = check("yo(5 m, 20 m)", std::string(name) + arguments);
    EXPECT_EQ(refused.status, 1) << name;
    EXPECT_THAT(refused.err, HasSubstr(std::string("`") + GetParam() + "` has no command `" + name +
                                       "` [GL2197 "));
  }
}

TEST_P(PropelledPlatforms, IsDescribed) {
  const Outcome text = runShell(std::string("$GLIDERCC platform ") + GetParam());
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("pump                    none to command"));
  EXPECT_THAT(text.out, HasSubstr("pitch battery           none to command"));
  EXPECT_THAT(text.out, Not(HasSubstr(" 0 cc")));
}

/// What is shown of a mission has no words of the Slocum, which has other computers.
TEST_P(PropelledPlatforms, IsNotCalledBySlocumsParts) {
  ASSERT_EQ(check("yo(5 m, 20 m)", "descend(15 m, 1.2 m/s)").status, 0);
  const std::string in = "cd " + folder_.path().string() + " && $GLIDERCC ";
  const bool lauv = std::string(GetParam()) == "lauv";
  const Outcome flown = runShell(in + "sim m.mission");
  EXPECT_THAT(flown.out, HasSubstr(lauv ? "\n  (DUNE) " : "\n  (its own mission) ")) << flown.err;
  const Outcome alone = runShell(in + "sim --no-sbc --duration 5min --platform " + GetParam());
  EXPECT_THAT(alone.out, HasSubstr(lauv ? "flown by DUNE alone" : "flown by its own mission alone"))
      << alone.err;
  const Outcome brief = runShell(in + "brief m.mission -o -");
  EXPECT_THAT(brief.out, HasSubstr("<td>vehicle</td>")) << brief.err;
  const Outcome platform = runShell(in + "platform " + GetParam());
  for (const Outcome& shown : {flown, alone, brief, platform}) {
    for (const char* word : {"layered control", "hookbeh", "hook instruction", "flight computer",
                             "science computer", "glider "}) {
      EXPECT_THAT(shown.out, Not(HasSubstr(word)));
    }
  }
}

}  // namespace
}  // namespace glider::tests
