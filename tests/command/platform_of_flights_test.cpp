// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A flight is one of the vehicle that the mission names, whichever command flies it.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <gmock/gmock.h>

namespace glider::tests {
namespace {

using testing::HasSubstr;

/// A share directory of our own, in which platform `mine` is `slocum` with a change.
class PlatformOfFlights : public ::testing::Test {
 protected:
  /// `change`: a line of sed.
  void platform(const std::string& change) const {
    const Outcome made = run(
        "rm -rf share && cp -rL $(dirname $GLIDERCC)/../share/glidercc share && chmod -R u+w share "
        "&& sed -e 's/^name = \"slocum\"/name = \"mine\"/' -e '" +
        change + "' share/platforms/slocum.toml > share/platforms/mine.toml");
    ASSERT_EQ(made.status, 0) << made.err;
  }
  void mission(const std::string& name, const std::string& head) const {
    (void)folder_.write(name, "mission m\n" + head +
                                  "require always depth < 18 m\n"
                                  "state s\nbegin\n"
                                  "  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
                                  "  sensors missiontime, depth\n"
                                  "  events\n    case missiontime >= 5 min exit\nend\n");
  }
  [[nodiscard]] Outcome run(const std::string& line) const {
    return runShell("cd " + folder_.path().string() + " && " + line);
  }
  [[nodiscard]] Outcome glidercc(const std::string& line) const {
    return run("GLIDERCC_SHARE=share $GLIDERCC " + line);
  }

  const TemporaryFolder folder_;
};

const std::string kCampaign = "campaign --boards 0 --flights 2 --csv f.csv ";

TEST_F(PlatformOfFlights, AnotherHullIsRefusedAndNotFlownAsTheSlocums) {
  platform("s/^greatest_depth_m = .*/greatest_depth_m = 123/");
  mission("slocum.mission", "");
  mission("mine.mission", "platform mine\n");
  for (const std::string command : {"sim -o f ", kCampaign.c_str()}) {
    const Outcome flown = glidercc(command + "mine.mission");
    EXPECT_EQ(flown.status, 2) << flown.out << flown.err;
    EXPECT_THAT(flown.err, HasSubstr("platform `mine`: the simulator cannot fly this vehicle: its "
                                     "greatest_depth_m is 123, and hookbeh in the simulator is "
                                     "built for 200"));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "f"));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "f.csv"));
  }
  EXPECT_EQ(glidercc(kCampaign + "slocum.mission").status, 0) << "it flies the slocum";
  EXPECT_EQ(glidercc(kCampaign + "slocum.mission mine.mission").status, 2) << "each its own";
}

TEST_F(PlatformOfFlights, WithoutAModelItIsCheckedAndBuiltAndNotFlown) {
  mission("mine.mission", "platform mine\n");
  const auto refused = [&](const std::string& edit, const std::string& why) {
    platform(edit);
    EXPECT_NE(glidercc("check mine.mission").status, 2);
    EXPECT_EQ(glidercc("build mine.mission -o mine").status, 0);
    const Outcome flown = glidercc("sim -o f mine.mission");
    EXPECT_EQ(flown.status, 2) << flown.out << flown.err;
    EXPECT_THAT(flown.err,
                HasSubstr("platform `mine`: the simulator cannot fly this vehicle: " + why));
  };
  refused("/^\\[motion\\]/,/^pump_in_j_cc/d", "its file has no [motion]");
  refused("s/^model = .*/model = \"propeller\"/", "it has no model `propeller`, only `glider`");
}

TEST_F(PlatformOfFlights, ThePlatformsNumbersMoveIt) {
  platform("s/^pump_rate_cc_s = .*/pump_rate_cc_s = 2/");
  mission("slocum.mission", "");
  mission("mine.mission", "platform mine\n");
  const auto deepest = [&](const std::string& name) {
    const Outcome flown = glidercc("sim -o f " + name);
    EXPECT_NE(flown.status, 2) << flown.err;
    return flown.out;
  };
  EXPECT_NE(deepest("slocum.mission"), deepest("mine.mission")) << "a slow pump";
}

TEST_F(PlatformOfFlights, ACampaignRefusesASensorThatIsNotSimulated) {
  platform(
      "$a [[sensor]]\\nname = \"sci_nitrate\"\\nunit = \"1\"\\nlowest = 0\\n"
      "highest = 100\\nbytes = 4\\nstale_after_s = 20\\nwhat = \"nitrate\"\\n"
      "computer = \"science\"");
  mission("mine.mission", "platform mine\n");
  const Outcome flown = glidercc(kCampaign + "mine.mission");
  EXPECT_EQ(flown.status, 2) << flown.out;
  EXPECT_THAT(flown.err, HasSubstr("has the sensor `sci_nitrate`"));
  EXPECT_THAT(flown.err, HasSubstr("[GL5122 sensor-not-simulated]"));
}

TEST_F(PlatformOfFlights, AVehicleThatIsOnlyCalledOtherwiseFliesTheSame) {
  platform("");
  mission("slocum.mission", "");
  mission("mine.mission", "platform mine\n");
  EXPECT_EQ(glidercc(kCampaign + "mine.mission").status, 0);
  ASSERT_EQ(glidercc("sim mine.mission -o a").status, 0);
  ASSERT_EQ(glidercc("sim slocum.mission -o b").status, 0);
  EXPECT_EQ(slurp(folder_.path() / "a" / "trace.csv"), slurp(folder_.path() / "b" / "trace.csv"));
}

TEST_F(PlatformOfFlights, ACampaignIsNotResumedWithAnotherPlatformFile) {
  platform("");
  mission("mine.mission", "platform mine\n");
  ASSERT_EQ(glidercc(kCampaign + "mine.mission").status, 0);
  const std::string resume = "campaign --boards 0 --flights 2 --resume f.csv mine.mission";
  EXPECT_EQ(glidercc(resume).status, 0);
  platform("s/^drift_m_s = .*/drift_m_s = 0.123/");
  const Outcome resumed = glidercc(resume);
  EXPECT_EQ(resumed.status, 2);
  EXPECT_THAT(resumed.err, HasSubstr("GL9373"));
}

TEST_F(PlatformOfFlights, ACheckOfAVehicleThatCannotBeFlownHasItsFindings) {
  mission("mine.mission", "platform mine\n");
  for (const char* change :
       {"s/^greatest_depth_m = .*/greatest_depth_m = 123/", "s/^bytes = 8/bytes = 4/"}) {
    platform(change);
    const Outcome checked = glidercc("check --report mine.mission");
    EXPECT_EQ(checked.status, 1) << checked.err;
    EXPECT_THAT(checked.err, HasSubstr("[GL3110 requirement-broken]"));
    EXPECT_THAT(checked.out, HasSubstr("not flown: "));
  }
}

}  // namespace
}  // namespace glider::tests
