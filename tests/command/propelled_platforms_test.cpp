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
  const Outcome fine = check("yo(5 m, 20 m, 10 deg, 10 deg)", "descend(15 m, 10 deg)");
  EXPECT_EQ(fine.status, 0) << fine.out << fine.err;
  EXPECT_THAT(fine.out, HasSubstr("1 requirement proved")) << fine.err;
  const Outcome deep = check("yo(5 m, 120 m, 10 deg, 10 deg)", "descend(15 m, 10 deg)");
  EXPECT_EQ(deep.status, 1);
  EXPECT_THAT(deep.out + deep.err, HasSubstr("GL3104"));
  const Outcome steep = check("yo(5 m, 20 m, 40 deg, 40 deg)", "descend(15 m, 10 deg)");
  EXPECT_EQ(steep.status, 1);
  EXPECT_THAT(steep.out + steep.err, HasSubstr("GL3104"));
}

TEST_P(PropelledPlatforms, WhatOnlyAGliderHasCannotBeCommanded) {
  for (const auto& [command, lacks] : {std::pair{"pump(20 cc)", "a pump volume of 20 cc"},
                                       {"battery(0.2 inch)", "no `battery_in`"}}) {
    const Outcome refused = check("yo(5 m, 20 m, 10 deg, 10 deg)", command);
    EXPECT_EQ(refused.status, 1) << command;
    EXPECT_THAT(refused.out + refused.err, HasSubstr(lacks)) << command;
    EXPECT_THAT(refused.out + refused.err, HasSubstr("to command")) << command;
  }
  const Outcome pump = check("yo(5 m, 20 m, 10 deg, 10 deg)", "pump(20 cc)");
  EXPECT_THAT(pump.out + pump.err,
              HasSubstr("its platform has no `pump_cc`: the vehicle has no pump to command"));
}

TEST_P(PropelledPlatforms, IsDescribed) {
  const Outcome text = runShell(std::string("$GLIDERCC platform ") + GetParam());
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("pump                    none to command"));
  EXPECT_THAT(text.out, HasSubstr("pitch battery           none to command"));
  EXPECT_THAT(text.out, Not(HasSubstr(" 0 cc")));
}

}  // namespace
}  // namespace glider::tests
