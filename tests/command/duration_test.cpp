// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// --duration, and where the vehicle's mission file of a scenario is looked for.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A mission that surfaces every two hours and ends after `lasts`.
std::string missionOf(const std::string& lasts) {
  return "mission long\nvar fixed: time = 0 s\nalways\n  case missiontime >= " + lasts +
         " exit\n  case missiontime - fixed > 2 h do set fixed = missiontime end call up\n"
         "state fly\nbegin\n  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
         "  sensors missiontime, depth\nend\n"
         "state up\nbegin\n  flightprofile surfaced\n  sensors depth, statetime\n  events\n"
         "    case held(depth < 2 m, 1 min) || statetime > 30 min return\nend\n";
}

/// A folder with such a mission, in which commands run.
struct Long {
  explicit Long(const std::string& lasts) { (void)folder.write("long.mission", missionOf(lasts)); }
  [[nodiscard]] Outcome run(const std::string& words) const {
    return runShell("cd " + folder.path().string() + "; $GLIDERCC " + words);
  }
  TemporaryFolder folder;
};

TEST(Duration, ALongFlightEndsByItself) {
  const Long twenty("20 h");
  const Outcome cut = twenty.run("sim long.mission");
  EXPECT_THAT(cut.out, HasSubstr("had not ended"));
  const Outcome outcome = twenty.run("sim long.mission --duration 1day");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("→ end (exit"));
  EXPECT_EQ(
      outcome.err,
      "glidercc: note: overtime of the bundled skeleton.mi is raised from 12 h to 24 h for this "
      "duration; the vehicle's own mission file needs an overtime as long\n");
}

TEST(Duration, AShortOneCutsTheFlight) {
  const Long one("1 h");
  const Outcome outcome = one.run("sim long.mission --duration 10min");
  EXPECT_THAT(outcome.out, HasSubstr("flown 600 s"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("overtime")));
}

TEST(Duration, IsWrittenAsInAMission) {
  const Long one("1 h");
  for (const char* time : {"10 min 30 s", "10min30s", "10.5 min", "630", "6.3e2 s"}) {
    EXPECT_THAT(one.run("sim long.mission --duration '" + std::string(time) + "'").out,
                HasSubstr("simulated time of 630 s"))
        << time;
  }
  for (const char* time :
       {"30 s 10 min", "1 h 70 min", "1 h 30", "3 h 30 m", "h", "3 h x", "3 h 3 h"}) {
    EXPECT_THAT(one.run("sim long.mission --duration '" + std::string(time) + "'").err,
                HasSubstr("` is not a time: write a number with s, min, h or day"))
        << time;
  }
}

TEST(Duration, OfACheckToo) {
  const Long twenty("20 h");
  const std::string check = "check --scenario default long.mission";
  EXPECT_THAT(twenty.run(check).err, HasSubstr("abend allows 12 h 0 min 0 s (overtime in "));
  const Outcome outcome = twenty.run(check + " --duration 1day");
  EXPECT_THAT(outcome.err, Not(HasSubstr("overtime")));
  EXPECT_THAT(outcome.err, Not(HasSubstr("had not ended")));
  EXPECT_THAT(outcome.out, HasSubstr("is raised from 12 h to 24 h"));
  EXPECT_EQ(twenty.run("check long.mission --duration 1day").status, 2) << "of which flight?";
}

TEST(Duration, OfACampaignToo) {
  const Long twenty("20 h");
  const std::string campaign = "campaign long.mission --flights 2 --boards 0 --fault none";
  const Outcome refused = twenty.run(campaign);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("does not end within the 6 h 0 min 0 s that scenario"));
  EXPECT_THAT(refused.err, HasSubstr("`--duration 1240min`"));
  const Outcome flown = twenty.run(campaign + " --duration 1240min");
  EXPECT_EQ(flown.status, 0) << flown.err;
}

TEST(Duration, AFileOfThePilotKeepsItsOvertime) {
  const Long twenty("20 h");
  ASSERT_EQ(twenty
                .run("--version; cp $(dirname $GLIDERCC)/../share/glidercc/scenarios/default.toml "
                     "$(dirname $GLIDERCC)/../share/glidercc/scenarios/skeleton.mi .")
                .status,
            0);
  const Outcome outcome = twenty.run("sim long.mission --scenario default.toml --duration 1day");
  EXPECT_THAT(outcome.err, HasSubstr("MS_ABORT_OVERTIME"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("is raised")));
}

/// The scenario's file does not fly, so nothing is said about it.
TEST(Duration, AFileOfThePilotKeepsItsOvertimeInACheckToo) {
  const auto check = [](const Long& mission) {
    return mission.run(
        "--version; cp $(dirname $GLIDERCC)/../share/glidercc/scenarios/skeleton.mi "
        "own.mi; $GLIDERCC check --scenario default --mi own.mi --duration 1day "
        "long.mission");
  };
  const Outcome refused = check(Long("20 h"));
  EXPECT_THAT(refused.err, HasSubstr("abend allows 12 h 0 min 0 s (overtime in own.mi)"));
  const Outcome fine = check(Long("1 h"));
  EXPECT_EQ(fine.status, 0) << fine.err;
  EXPECT_THAT(fine.out, HasSubstr("long.mission: fine"));
  EXPECT_THAT(fine.out, Not(HasSubstr("is raised")));
}

/// `sim` flies it so too.
TEST(Duration, TheBundledFileIsRaisedInACheckThatNamesIt) {
  const Long twenty("20 h");
  const std::string words =
      " --scenario default --duration 1day long.mission "
      "--mi $(dirname $GLIDERCC)/../share/glidercc/scenarios/skeleton.mi";
  const Outcome checked = twenty.run("check" + words);
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_THAT(checked.out, HasSubstr("is raised from 12 h to 24 h"));
  const Outcome flown = twenty.run("sim" + words);
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_THAT(flown.err, HasSubstr("is raised from 12 h to 24 h"));
}

TEST(Duration, ASkeletonThatIsNotBesideItsScenarioIsTheBundledOne) {
  const Long one("1 h");
  ASSERT_EQ(one.run("--version; cp $(dirname $GLIDERCC)/../share/glidercc/scenarios/default.toml "
                    "here.toml; sed 's/skeleton.mi/nowhere.mi/' here.toml > nowhere.toml")
                .status,
            0);
  EXPECT_EQ(one.run("sim long.mission --scenario here.toml").status, 0);
  const Outcome outcome = one.run("sim long.mission --scenario nowhere.toml");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err,
              HasSubstr("cannot read `nowhere.mi`: No such file or directory [GL9001 "));
  EXPECT_THAT(outcome.err, testing::ContainsRegex("hint: looked for it in `\\.` and in "
                                                  "`.*share/glidercc/scenarios`: copy it there"));
}

TEST(Duration, IsATimeWithAUnitOrInSeconds) {
  const Long one("1 h");
  EXPECT_THAT(one.run("sim long.mission --duration 600").out, HasSubstr("flown 600 s"));
  EXPECT_THAT(one.run("sim long.mission --duration '0.2 h'").out, HasSubstr("flown 720 s"));
  for (const std::string time : {"10m", "h", "-1", "0", "61day", "nan", "1e9"}) {
    const Outcome outcome = one.run("sim long.mission --duration=" + time);
    EXPECT_EQ(outcome.status, 2) << time;
    EXPECT_THAT(outcome.err, HasSubstr("glidercc: error: --duration: `" + time + "` is not "))
        << time;
  }
  EXPECT_THAT(one.run("sim long.mission --duration 61day").err,
              HasSubstr("`61day` is not from 1 s to 60 days\n"));
  EXPECT_THAT(one.run("build long.mission --dialect extctl --surface-after 1min -o port").err,
              HasSubstr("`1min` is not from 10 min to 7 days\n"));
  EXPECT_EQ(one.run("check --timeout 5s long.mission").status, 0);
  EXPECT_THAT(one.run("check --timeout 5m long.mission").err,
              HasSubstr("`5m` is not a time: write a number with s, min, h or day"));
}

}  // namespace
}  // namespace glider::tests
