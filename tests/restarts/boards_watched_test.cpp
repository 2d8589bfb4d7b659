// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `sim --board` and `sim --sbc` watch requirements over power cuts, as in this process.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

class BoardsWatched : public testing::Test {
 protected:
  BoardsWatched() {
    std::string scenario = slurp(std::string(GLIDER_SOURCE_DIR) + "/scenarios/default.toml");
    const std::string skeleton = "\"skeleton.mi\"";
    scenario.replace(scenario.find(skeleton), skeleton.size(),
                     "\"" GLIDER_SOURCE_DIR "/scenarios/skeleton.mi\"");
    (void)folder_.write("cut.toml", scenario + "\n[[faults.power]]\nfrom_s = 300\nto_s = 340\n");
    mission("m.mission", "10 min");
  }
  void mission(const std::string& file, const std::string& end) const {
    (void)folder_.write(file,
                        "mission m\nrequire always depth <= 9 m || missiontime < 7 min\n"
                        "require visit s at most 1 times\nstate s\nbegin\n"
                        "  flightprofile yo(4 m, 14 m, 26 deg, 26 deg)\n"
                        "  sensors missiontime, depth\n  events\n    case missiontime >= " +
                            end + " exit\nend\n");
  }
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    return runShell("cd " + folder_.path().string() + " && " + arguments);
  }

  const TemporaryFolder folder_;
};

TEST_F(BoardsWatched, ReportWhatTheSameFlightInThisProcessDoes) {
  const Outcome here = run("$GLIDERCC sim m.mission --scenario cut.toml -o f");
  EXPECT_EQ(here.status, 1) << here.err;
  EXPECT_THAT(here.err, HasSubstr("m.mission:2:1: warning: this flight violates the requirement"));
  EXPECT_THAT(here.err, HasSubstr("; after an outage of the SBC from mission time "));
  EXPECT_THAT(here.err, Not(HasSubstr("m.mission:3:1")));
  for (const char* board : {"host", "ts7800", "ts5500"}) {
    const Outcome there =
        run(std::string("$GLIDERCC sim m.mission --scenario cut.toml -o f --board ") + board);
    EXPECT_EQ(there.status, 1) << board << there.err;
    EXPECT_EQ(there.err, here.err) << board;
  }
}

/// accepts: GL5129
TEST_F(BoardsWatched, AProgramOfTheMissionIsWatched) {
  ASSERT_EQ(run("$GLIDERCC build m.mission -o m").status, 0);
  (void)folder_.write("m.sh", "#!/bin/sh\nexec ./m \"$@\" --checkpoint m.state\n");
  const Outcome flown =
      run("chmod +x m.sh && $GLIDERCC sim m.mission --scenario cut.toml -o f --sbc ./m.sh");
  EXPECT_EQ(flown.status, 1) << flown.err;
  EXPECT_THAT(flown.err, HasSubstr("after an outage of the SBC from mission time "));
  EXPECT_THAT(flown.err, Not(HasSubstr("GL5129")));
}

/// expects: GL5129
TEST_F(BoardsWatched, AProgramOfAnotherMissionIsNotAndThatIsSaid) {
  mission("other.mission", "3 min");
  ASSERT_EQ(run("$GLIDERCC build other.mission -o other").status, 0);
  const Outcome flown = run("$GLIDERCC sim m.mission -o f --sbc ./other");
  EXPECT_EQ(flown.status, 1);
  EXPECT_THAT(flown.err, HasSubstr("requirements and assumptions are not watched"));
  EXPECT_THAT(flown.err, HasSubstr("[GL5129 watch-ended]"));
  EXPECT_THAT(flown.err, Not(HasSubstr("GL5127")));
}

}  // namespace
}  // namespace glider::tests
