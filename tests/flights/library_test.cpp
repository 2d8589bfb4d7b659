// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The library in the language: beside the runtime's own in C, and what its parts do at sea.

#include "runtime/abi/glider_abi.h"
#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace glider::tests {
namespace {

/// The profiles and routes that the runtime has in C, under the library's names.
constexpr const char* kLibraryInC = R"(
extern flightprofile yo(top: length, bottom: length, dive: angle, climb: angle) reads depth
extern flightprofile thermotrackyo(top: length, bottom: length, dive: angle, climb: angle,
                                   dtemp: temperature, ddepth: length) reads depth, temp
extern flightprofile surfaced reads depth
extern flightroute noheading
extern flightroute nav(north: latitude, east: longitude)
extern flightroute heading(to: angle)
)";

/// Flies with the library in C: what the command reads is copied, the library replaced.
Flight flyInC(const std::string& arguments) {
  const TemporaryFolder folder;
  const std::string share = folder.path() / "share";
  const Outcome copied = runShell("cp -rs $(dirname $(dirname $GLIDERCC))/share/glidercc " + share +
                                  " && rm " + share + "/library/standard.mission");
  EXPECT_EQ(copied.status, 0) << copied.err;
  const std::string text = folder.write("standard.mission", kLibraryInC);
  EXPECT_EQ(runShell("mv " + text + " " + share + "/library/").status, 0);
  setenv("GLIDERCC_SHARE", share.c_str(), 1);
  Flight flight = fly(arguments);
  unsetenv("GLIDERCC_SHARE");
  return flight;
}

std::string world(const std::string& name = "default") {
  return " --scenario " + project("scenarios/" + name + ".toml");
}

void expectTheSameInC(const std::string& mission, const std::string& scenario = "default") {
  const Flight language = fly(mission + world(scenario));
  const Flight c = flyInC(mission + world(scenario));
  ASSERT_EQ(language.outcome.status, 0) << language.outcome.err;
  ASSERT_EQ(c.outcome.status, 0) << c.outcome.err;
  EXPECT_GT(language.rows.size(), 100U);
  EXPECT_TRUE(language.csv == c.csv) << "the traces differ";
}

TEST(Library, Figure2IsTheSameInCAndInTheLanguage) {
  expectTheSameInC(project("missions/figure2.mission"));
}

TEST(Library, ThermotrackyoIsTheSameInCAndInTheLanguage) {
  for (const char* scenario : {"figure5", "first_deployment", "figure6", "default"}) {
    SCOPED_TRACE(scenario);
    expectTheSameInC(project("missions/figure5.mission"), scenario);
  }
}

/// Its windows and what it has found live on through the call.
TEST(Library, ThermotrackyoThatIsReturnedToIsTheSame) {
  const TemporaryFolder folder;
  expectTheSameInC(folder.write("called.mission", R"(mission called
var times : number = 0
state track
begin
  flightprofile thermotrackyo(5 m, 28 m, 26 deg, 20 deg, 8 degC, 9 m)
  sensors       missiontime, depth, temp
  events
    case missiontime > 400 s && times < 1 do set times = 1 end call up
    case missiontime > 1100 s && times < 2 do set times = 2 end call up
    case missiontime > 2000 s exit
end
state up
begin
  flightprofile surfaced
  sensors       depth, statetime
  events
    case depth < 4 m || statetime > 300 s return
end
)"),
                   "first_deployment");
}

TEST(Library, EveryPartThatCHasIsTheSame) {
  const TemporaryFolder folder;
  expectTheSameInC(folder.write("parts.mission", R"(mission parts
var deep : length = 8 m in 8 m .. 20 m
state dive
begin
  flightroute   heading(0.5 + statetime / 1000 s * 1 rad)
  flightprofile yo(3, deep, .454, .3)
  sensors       missiontime, depth
  events
    case statetime >= 300 s && deep < 9 m do set deep = 15 m end call up
    case missiontime >= 1200 s exit
end
state up
begin
  flightprofile surfaced
  sensors       statetime
  events
    case statetime >= 200 s return
end
)"));
}

Flight flyText(const std::string& text) {
  const TemporaryFolder folder;
  return fly(folder.write("m.mission", text).string() + world());
}

TEST(Library, DiveToAndClimbToAreDoneWhereTheySay) {
  const Flight flight = flyText(R"(mission once
state down
begin
  flightprofile dive_to(15 m, 26 deg)
  sensors       depth
  events
    case profiledone goto up
    case missiontime > 30 min exit
end
state up
begin
  flightprofile climb_to(6 m, 26 deg)
  sensors       depth
  events
    case profiledone goto stay_there
    case missiontime > 30 min exit
end
state stay_there
begin
  flightprofile hover_at(6 m)
  sensors       depth, missiontime
  events
    case missiontime > 20 min exit
end
)");
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  const auto transitions = flight.transitions();
  ASSERT_EQ(transitions.size(), 3U);
  EXPECT_EQ(transitions[0].what, "down → up (goto)");
  EXPECT_EQ(transitions[1].what, "up → stay_there (goto)");
  const auto depth = flight.column("true_depth");
  const auto time = flight.column("missiontime");
  EXPECT_NEAR(*std::ranges::max_element(depth), 16, 4);
  for (size_t i = 0; i < depth.size(); ++i) {
    if (time[i] > 15 * 60 && time[i] < 20 * 60) {
      EXPECT_NEAR(depth[i], 6, 4) << time[i];
    }
  }
}

/// A flight that surfaces at `times`, with these faults beside the default scenario.
Flight flyWithFaults(const std::string& faults, const std::string& bottom, const std::string& times,
                     const std::string& until) {
  const TemporaryFolder folder;
  const auto scenario =
      folder.write("faults.toml", slurp(project("scenarios/default.toml")) + faults);
  std::filesystem::copy(project("scenarios/skeleton.mi"), folder.path());
  const auto mission = folder.write("m.mission", R"(mission surfacing
state look
begin
  flightprofile yo_and_surface(5 m, )" + bottom + ", 26 deg, 26 deg, " +
                                                     times + R"()
  sensors       missiontime, depth
  events
    case missiontime > )" + until + R"( exit
end
)");
  return fly(mission.string() + " --scenario " + scenario.string());
}

/// Its depth is missing for a while as it comes up: it is not taken to have arrived.
TEST(Library, AYoThatSurfacesGoesOnUpWhenItsDepthComesBack) {
  const Flight flight = flyWithFaults(R"(
[[faults.sensor]]
sensor = "m_depth"
from_s = 1510
to_s = 1610
missing = true
)",
                                      "50 m", "period = 25 min, pause = 1 min", "45 min");
  const auto depth = flight.column("true_depth"), time = flight.column("time");
  const auto commanded = flight.column("hook_depth");
  size_t i = 0;
  while (i < depth.size() && time[i] < 1520) {
    ++i;
  }
  EXPECT_GT(depth[i], 30) << "it is deep when its depth goes missing";
  for (; i < depth.size() && depth[i] >= 1; ++i) {
    EXPECT_EQ(commanded[i], 0) << time[i];
  }
  EXPECT_LT(time[i], 1750) << "it surfaced";
}

/// The seconds of the first stay at the surface that begins after `from_s`.
double firstStay(const Flight& flight, double from_s) {
  const auto depth = flight.column("true_depth"), time = flight.column("time");
  double arrived = -1;
  for (size_t i = 0; i < depth.size(); ++i) {
    if (arrived < 0 && time[i] > from_s && depth[i] < 0.5) {
      arrived = time[i];
    } else if (arrived >= 0 && depth[i] > 5) {
      return time[i] - arrived;
    }
  }
  return 0;
}

/// A mission that surfaces after an hour, and once calls a state with `profile` for 20 min.
std::string interrupted(const std::string& when, const std::string& profile) {
  return R"(mission interrupted
var calls: number = 0 in 0 .. 1
state transect
begin
  flightroute   heading(90 deg)
  flightprofile yo_and_surface(5 m, 40 m, 26 deg, 26 deg, period = 1 h, pause = 5 min)
  sensors       missiontime, depth
  events
    case missiontime > 2 h exit
    case calls < 1 && )" +
         when + R"( do set calls = 1 end call other
end
state other
begin
  flightroute   heading(90 deg)
  flightprofile )" +
         profile + R"(
  sensors       statetime, depth
  events
    case statetime > 20 min return
end
)";
}

/// The call comes on the way up, as it arrives, and late in the pause; it returns at depth or at
/// the surface.
TEST(Library, AYoThatSurfacesBeginsItsSurfacingAgainAfterACall) {
  for (const char* when : {"missiontime > 61 min", "held(depth < 1 m && missiontime > 55 min, 8 s)",
                           "held(depth < 1 m && missiontime > 55 min, 4 min)"}) {
    for (const char* profile : {"yo(5 m, 20 m, 26 deg, 26 deg)", "surfaced"}) {
      SCOPED_TRACE(std::string(when) + ", " + profile);
      const Flight flight = flyText(interrupted(when, profile));
      const auto transitions = flight.transitions();
      ASSERT_EQ(transitions.size(), 3U) << flight.outcome.err;
      ASSERT_EQ(transitions[1].what, "other → transect (return)");
      EXPECT_GT(firstStay(flight, transitions[1].time_s), 290);
      EXPECT_LT(firstStay(flight, transitions[1].time_s), 290 + 120);
    }
  }
}

/// A call takes it to the surface for longer than the hold: after the return it is not done there.
/// Once it was done, it stays so.
TEST(Library, ADiveThatHoldsBeginsItsHoldAgainAfterACall) {
  const Flight flight = flyText(R"(mission held
var calls: number = 0 in 0 .. 2
state hold
begin
  flightprofile dive_and_hold(bottom = 15 m, dive = 26 deg, hold = 10 min)
  sensors       missiontime, depth
  events
    case missiontime > 2 h exit
    case calls < 1 && held(depth > 14 m, 2 min) do set calls = 1 end call up
    case calls == 1 && profiledone do set calls = 2 log "done", missiontime end call up
    case calls == 2 && profiledone exit
end
state up
begin
  flightprofile surfaced
  sensors       depth, statetime
  events
    case statetime > 15 min return
end
)");
  const auto transitions = flight.transitions();
  ASSERT_EQ(transitions.size(), 5U) << flight.outcome.err;
  const double returned = transitions[1].time_s, done = transitions[2].time_s;
  const auto depth = flight.column("true_depth"), time = flight.column("time");
  double held_from = done;
  for (size_t i = time.size(); i-- > 0;) {
    held_from = time[i] < done && time[i] > returned && depth[i] > 12 ? time[i] : held_from;
  }
  EXPECT_NEAR(done - held_from, 10 * 60, 60);
  EXPECT_LT(transitions[4].time_s - transitions[3].time_s, 60) << "it was done before";
}

/// At the surface its depth reads 0.5 m to 2.9 m, as in waves: it dives again after its pause.
TEST(Library, AYoThatSurfacesLeavesInWaves) {
  const Flight flight = flyWithFaults(R"(
[[faults.sensor]]
sensor = "m_depth"
from_s = 900
to_s = 20000
offset = 1.7
[[faults.sensor]]
sensor = "m_depth"
from_s = 900
to_s = 20000
sways = 1.2
period_s = 40
)",
                                      "30 m", "period = 20 min, pause = 3 min", "1 h");
  const auto depth = flight.column("true_depth"), time = flight.column("time");
  size_t i = 0;
  while (i < depth.size() && (time[i] < 1210 || depth[i] > 0.3)) {
    ++i;
  }
  ASSERT_LT(i, depth.size());
  const double arrived = time[i];
  while (i < depth.size() && depth[i] < 10) {
    ++i;
  }
  ASSERT_LT(i, depth.size()) << "it never dived again";
  EXPECT_GT(time[i] - arrived, 180);
  EXPECT_LT(time[i] - arrived, 180 + 240);
}

}  // namespace
}  // namespace glider::tests
