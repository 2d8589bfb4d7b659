// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A second family of vehicles is a row of vehicles.def and what it names: the command with a toy
// checks and flies its missions, and those of a Slocum as before.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

class SecondFamily : public ::testing::Test {
 protected:
  void SetUp() override {
    const Outcome made = runShell(
        "cd " + folder_.path().string() +
        " && mkdir share && ln -s $(realpath $(dirname $GLIDERCC)/../share/glidercc)/* share && "
        "rm share/platforms && cp -rL $(dirname $GLIDERCC)/../share/glidercc/platforms share && "
        "sed -e 's/^name = \"slocum\"/name = \"toy\"/' -e 's/^family = \"slocum\"/family = "
        "\"toy\"/' share/platforms/slocum.toml > share/platforms/toy.toml");
    ASSERT_EQ(made.status, 0) << made.err;
    (void)folder_.write("toy.mission", mission("platform toy\n"));
    (void)folder_.write("slocum.mission", mission(""));
  }
  static std::string mission(const std::string& head) {
    return "mission m\n" + head +
           "state s\nbegin\n  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
           "  flightroute heading(90 deg)\n  sensors missiontime, depth\n"
           "  events\n    case missiontime >= 20 min exit\nend\n";
  }
  [[nodiscard]] Outcome in(const std::string& program, const std::string& line) const {
    return runShell("cd " + folder_.path().string() + " && GLIDERCC_SHARE=share " + program + " " +
                    line);
  }
  [[nodiscard]] Outcome withAToy(const std::string& line) const {
    return in(std::string(GLIDER_BINARY_DIR) + "/tests/second_family/glidercc_with_a_toy", line);
  }
  /// The greatest number in a column of a flight's trace.
  [[nodiscard]] double greatest(const std::string& flight, const std::string& column) const {
    const Outcome out =
        runShell("cd " + folder_.path().string() + " && awk -F, -v 'name=" + column +
                 "' 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next } "
                 "$at[name] > most { most = $at[name] } END { print most + 0 }' " +
                 flight + "/trace.csv");
    return std::stod(out.out);
  }

  const TemporaryFolder folder_;
};

TEST_F(SecondFamily, FliesAMissionToItsExit) {
  const Outcome flown = withAToy("sim toy.mission -o f");
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_THAT(flown.out, HasSubstr("the toy comes up"));
  EXPECT_GT(greatest("f", "m_depth (m)"), 19);
  EXPECT_LT(greatest("f", "m_depth (m)"), 30);
  EXPECT_GT(greatest("f", "missiontime (s)"), 1150);
}

/// The toy does not obey a fixed fin, like a vehicle from before that command: the link is refused
/// before the mission has control.
TEST_F(SecondFamily, RefusesAMissionThatNeedsMoreByName) {
  (void)folder_.write("fin.mission",
                      "mission m\nplatform toy\nstate s\nbegin\n"
                      "  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
                      "  flightroute fixed_fin(10 deg)\n  sensors missiontime, depth\n"
                      "  events\n    case missiontime >= 20 min exit\nend\n");
  const Outcome flown = withAToy("sim fin.mission -o f");
  EXPECT_THAT(flown.out + flown.err, HasSubstr("fixed-fin"));
  EXPECT_LT(greatest("f", "m_depth (m)"), 1);
}

TEST_F(SecondFamily, RefusesAMissionThatCommandsThePumpByName) {
  (void)folder_.write(
      "pump.mission",
      "mission m\nplatform toy\nflightprofile in\nbegin\n  entry do pump(-20 cc) end\n"
      "end\nstate s\nbegin\n  flightprofile in\n  flightroute noheading\n"
      "  sensors missiontime, depth\n  events\n    case depth > 5 m exit\n"
      "    case missiontime >= 20 min exit\nend\n");
  const Outcome flown = withAToy("sim pump.mission -o f");
  EXPECT_THAT(flown.out + flown.err, HasSubstr("actuators"));
  EXPECT_LT(greatest("f", "m_depth (m)"), 1);
}

TEST_F(SecondFamily, IsCheckedByItsOwnRules) {
  const Outcome report = withAToy("check toy.mission --report");
  EXPECT_EQ(report.status, 0) << report.err;
  EXPECT_THAT(report.out, HasSubstr("a toy comes up within 24 s"));
  EXPECT_THAT(report.out, Not(HasSubstr("hookbeh")));
  (void)folder_.write("shallow.toy", "15\n");
  const Outcome refused = withAToy("check toy.mission --mi shallow.toy");
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.out + refused.err, HasSubstr("GL3124"));
  (void)folder_.write("deep.toy", "100\n");
  const Outcome fine = withAToy("check toy.mission --report --mi deep.toy");
  EXPECT_EQ(fine.status, 0);
  EXPECT_THAT(fine.out, HasSubstr("after control a toy comes up"));
  EXPECT_THAT(fine.out + fine.err, Not(HasSubstr("abend")));
}

TEST_F(SecondFamily, IsJudgedByItsOwnChecks) {
  const Outcome flown = withAToy(
      "campaign toy.mission --boards 0 --flights 4 --fault none --fault 'line cut' --csv f.csv && "
      "grep -c ',exited,0,0,' f.csv && grep -c ',released,0,0,' f.csv");
  EXPECT_EQ(flown.status, 0) << flown.err << flown.out;
  EXPECT_THAT(flown.out, testing::EndsWith("\n3\n1\n")) << "a toy counts no instructions";
}

TEST_F(SecondFamily, LeavesTheFirstAsItIs) {
  const std::string campaign =
      "campaign slocum.mission --boards 0 --flights 3 --fault none --csv f.csv > /dev/null && "
      "sed 1d f.csv";
  for (const std::string& line :
       {std::string("check slocum.mission --report --mi share/scenarios/skeleton.mi"),
        std::string("sim slocum.mission -o f > /dev/null && cat f/trace.csv f/events.csv"),
        campaign}) {
    const Outcome first = in("$GLIDERCC", line);
    const Outcome both = withAToy(line);
    EXPECT_EQ(first.status, 0) << first.err;
    EXPECT_EQ(both.status, 0) << both.err;
    EXPECT_GT(first.out.size(), 100U) << line;
    EXPECT_EQ(first.out, both.out);
  }
}

/// Each flight is flown with the own mission of its vehicle, whichever mission is read last.
TEST_F(SecondFamily, FliesInACampaignBesideTheFirst) {
  const auto rows = [&](const std::string& missions, const std::string& of) {
    const Outcome flown = withAToy("campaign " + missions +
                                   " --boards 0 --flights 4 --fault none --fault 'tight limits' "
                                   "--csv f.csv > /dev/null && grep '" +
                                   of + "' f.csv | cut -d, -f3-");
    EXPECT_EQ(flown.status, 0) << flown.err;
    return flown.out;
  };
  const std::string alone = rows("slocum.mission slocum.mission", "^[02],");
  EXPECT_THAT(alone, HasSubstr("exited"));
  EXPECT_EQ(rows("slocum.mission toy.mission", "slocum.mission"), alone);
}

TEST_F(SecondFamily, IsUnknownToTheCommandWithoutIt) {
  const Outcome refused = in("$GLIDERCC", "sim toy.mission -o f");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("only `slocum`"));
}

TEST_F(SecondFamily, DoesNotFlyAnothersOwnMission) {
  (void)folder_.write("deep.toy", "100\n");
  for (const char* line :
       {"slocum.mission --mi deep.toy", "toy.mission --mi share/scenarios/skeleton.mi"}) {
    const Outcome refused = withAToy(std::string("check ") + line);
    EXPECT_EQ(refused.status, 2) << line;
    EXPECT_THAT(refused.err, HasSubstr("it is for vehicles of the family")) << line;
  }
}

}  // namespace
}  // namespace glider::tests
