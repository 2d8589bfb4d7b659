// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a brief says of a mission, in words.

#include "analysis/brief/brief_of.h"
#include "analysis/brief/in_words.h"
#include "analysis/brief/summary.h"
#include "analysis/brief/written.h"
#include "vehicles/vehicle.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <gmock/gmock.h>

namespace glider::analysis {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kBriefed = R"(# SPDX-License-Identifier: Apache-2.0
#########
# Looks for warm water.

# Then it goes home.

mission m
const far = 39 N 74 W   # beyond the shelf
                        # in deep water
# Warm enough to stay.
param warm : temperature = 4 degC in 1 degC .. 9 degC where warm < 8 degC
var n : number = 0 in 0 .. 9
always
  case depth > 50 m  exit
# Finds it.
# Slowly.
state first
begin
  flightroute nav(far)
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors lat, lon every 8 s, missiontime, depth
  entry do log "in`side", depth, n end
  events
    case depth > 3 m
      do
        set n = clamp(n + 1, 0, 9)
        if n > 3 then set n = 0 else log "few" end
      end
      stay
    case missiontime >= 1 h  goto second(1 h,
                                         2)
    case missiontime >= 2 h  call third
end
state second(limit: time, k: number)
begin
  flightroute nav(3910.5, -7349.8)
  flightprofile dive_to(9, .454)
  sensors statetime
  events
    case statetime > limit && k > 1  exit
end
state third
begin
  flightprofile surfaced
  sensors statetime, pitch
  events
    case statetime > 1 h || pitch > 40 deg  return
end
)";

class BriefOf : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { setenv("GLIDERCC_SHARE", GLIDER_BINARY_DIR "/share/glidercc", 1); }
  void SetUp() override {
    auto compiled = compiler::compileText("m.mission", kBriefed);
    ASSERT_TRUE(compiled);
    compilation_ = std::move(*compiled);
    for (const auto& one : compilation_.diagnostics.sorted()) {
      EXPECT_EQ(one.severity, support::Severity::Warning) << one.message;
    }
    ASSERT_TRUE(compilation_.checked);
  }
  void compile(const char* text) {
    auto compiled = compiler::compileText("m.mission", text);
    ASSERT_TRUE(compiled);
    compilation_ = std::move(*compiled);
    ASSERT_TRUE(compilation_.checked);
  }
  [[nodiscard]] report::Brief brief(report::CheckedMission found = {}) const {
    const ir::prove::Findings proved;
    return briefOf({compilation_,
                    proved,
                    found,
                    usual_.get(),
                    {{"warm", "temperature", "4 degC", "1 degC to 9 degC", ""}},
                    {"m-host", "0123", ""},
                    "glidercc 0"});
  }

  compiler::Compilation compilation_;
  const std::unique_ptr<vehicles::OwnMission> usual_ =
      vehicles::families::slocum.usual_own_mission();
};

TEST_F(BriefOf, CommentsAreThoseOfTheDeclaration) {
  const Written written(compilation_);
  EXPECT_EQ(written.head(), "Looks for warm water. Then it goes home.");
  EXPECT_EQ(written.commentOf("first"), "Finds it. Slowly.");
  EXPECT_EQ(written.commentOf("second"), "");
  const report::Brief of = brief();
  ASSERT_EQ(of.values.size(), 2U);
  EXPECT_EQ(of.values[0].name, "far");
  EXPECT_EQ(of.values[0].value, "39 00.000 N 74 00.000 W");
  EXPECT_EQ(of.values[0].meaning, "beyond the shelf in deep water");
  EXPECT_EQ(of.values[1].kind, "variable");
  EXPECT_EQ(of.values[1].range, "0 to 9");
  EXPECT_EQ(of.values[1].meaning, "");
  ASSERT_EQ(of.parameters.size(), 1U);
  EXPECT_EQ(of.parameters[0].meaning, "Warm enough to stay.");
  EXPECT_EQ(of.parameters[0].range, "1 degC to 9 degC");
  EXPECT_THAT(of.conditions, ElementsAre("warm < 8 degC"));
}

TEST_F(BriefOf, ProfilesAndRoutesNameTheirArguments) {
  const report::Brief of = brief();
  ASSERT_EQ(of.states.size(), 3U);
  EXPECT_EQ(of.states[0].profile.name, "yo");
  EXPECT_EQ(of.states[0].profile.with,
            "top = `5 m`, bottom = `20 m`, dive = `26 deg`, climb = `26 deg`");
  EXPECT_THAT(of.states[0].profile.comment, HasSubstr("Up and down between two depths"));
  EXPECT_EQ(of.states[0].route.with, "to = `far` (`39 00.000 N 74 00.000 W`)");
  EXPECT_EQ(of.states[1].profile.with, "bottom = `9 m`, dive = `.454 rad`");
  EXPECT_EQ(of.states[1].route.with, "to = `39 10.500 N 73 49.800 W`");
  EXPECT_EQ(of.states[2].profile.name, "surfaced");
  EXPECT_EQ(of.states[2].profile.comment, "Stays at the surface.");
  EXPECT_EQ(of.states[1].parameters, "limit: time, k: number");
  EXPECT_EQ(of.states[0].deepest, "at most 25 m deep");
  EXPECT_EQ(of.states[2].deepest, "at most 25 m deep as its climb to the surface begins");
}

TEST_F(BriefOf, EventsAreSentencesInTheirOrder) {
  const report::Brief of = brief();
  ASSERT_EQ(of.always.size(), 1U);
  EXPECT_EQ(of.always[0].when, "depth > 50 m");
  EXPECT_EQ(of.always[0].then, "ends the mission");
  const auto& first = of.states[0];
  EXPECT_EQ(first.samples, "`lat` and `lon` every 8 s; `missiontime` and `depth` on every tick");
  EXPECT_EQ(first.entry, "logs “in'side” with `depth` and `n`");
  ASSERT_EQ(first.events.size(), 3U);
  EXPECT_EQ(first.events[0].then,
            "sets `n` to `clamp(n + 1, 0, 9)`, (if `n > 3`: sets `n` to `0`; otherwise: logs "
            "“few”); then stays");
  EXPECT_EQ(first.events[1].when, "missiontime >= 1 h");
  EXPECT_EQ(first.events[1].then, "goes to `second` with `limit` = `1 h` and `k` = `2`");
  EXPECT_EQ(first.events[2].then, "calls `third`");
  EXPECT_EQ(of.states[2].events.at(0).then, "returns to the state that called");
}

/// Named arguments come in any order, and some are left out.
TEST_F(BriefOf, NamedArgumentsKeepTheirNames) {
  compile(R"(mission m
param w: position = 39.175 N 73.83 W
const shelf = 39 N 74 W
flightprofile saw(shallow: length, deep: length)
begin
  entry do descend(deep, 26 deg) end
  events
    case depth >= deep do ascend(shallow, 26 deg) end stay
    case depth <= shallow do descend(deep, 26 deg) end stay
end
state one
begin
  flightroute circle(radius = 300 m, centre = w)
  flightprofile yo(bottom = 30 m, top = 4 m, climb = 20 deg)
  sensors depth, lat, lon, missiontime
  events
    case missiontime > 1 h goto two
end
state two
begin
  flightroute along(capture = 100 m, track = [39.175 N 73.83 W, shelf])
  flightprofile yo_and_surface(4 m, 30 m, pause = 5 min, period = 2 h)
  sensors depth, lat, lon, missiontime
  events
    case routedone || missiontime > 2 h goto three
end
state three
begin
  flightroute circle(3910.5, -7349.8, radius = 200 m)
  flightprofile saw(deep = 33 m, shallow = 6 m)
  sensors depth, lat, lon, missiontime
  events
    case missiontime > 3 h exit
end
)");
  const report::Brief of = brief();
  ASSERT_EQ(of.states.size(), 3U);
  EXPECT_EQ(of.states[0].route.with, "centre = `w`, radius = `300 m`");
  EXPECT_EQ(of.states[0].profile.with, "top = `4 m`, bottom = `30 m`, climb = `20 deg`");
  EXPECT_EQ(of.states[1].route.with,
            "track = `[39 10.500 N 73 49.800 W, shelf]`, capture = `100 m`");
  EXPECT_EQ(of.states[1].profile.with,
            "top = `4 m`, bottom = `30 m`, period = `2 h`, pause = `5 min`");
  EXPECT_EQ(of.states[2].route.with, "centre = `39 10.500 N 73 49.800 W`, radius = `200 m`");
  EXPECT_EQ(of.states[2].profile.with, "shallow = `6 m`, deep = `33 m`");
}

/// In the IR it is a latitude and a longitude.
TEST_F(BriefOf, APositionIsOneValueInOneForm) {
  compile(R"(mission m
const track = [39 10.5 N 73 49.8 W, 39.2 N 73.9 W]
var back: position = 3910.5 N 7349.8 W
state one
begin
  flightprofile surfaced
  sensors lat, lon, missiontime, m_present_time
  entry do log "at", here, utc, track[1] log "p", 39 N 74 W, lat, lon end
  events
    case missiontime > 1 h do set back = 39.5 N 74 W end goto two(39.175 N 73.83 W)
end
state two(p: position)
begin
  flightprofile surfaced
  sensors lat, lon, missiontime
  events
    case missiontime > 2 h || distance(p) > 1 km || distance(back) > 1 km exit
end
)");
  const report::Brief of = brief();
  ASSERT_EQ(of.states.size(), 2U);
  EXPECT_EQ(of.states[0].entry,
            "logs “at” with `here`, `utc` and `track[1]`, logs “p” with `39 00.000 N 74 00.000 W`, "
            "`lat` and `lon`");
  EXPECT_EQ(of.states[0].events.at(0).then,
            "sets `back` to `39 30.000 N 74 00.000 W`; then goes to `two` with `p` = `39 10.500 N "
            "73 49.800 W`");
  EXPECT_EQ(of.values.at(0).value, "[39 10.500 N 73 49.800 W, 39 12.000 N 73 54.000 W]");
  EXPECT_EQ(of.values.at(1).value, "39 10.500 N 73 49.800 W");
  const auto clock = std::ranges::find(of.sensors, "m_present_time", &report::BriefSensor::name);
  ASSERT_NE(clock, of.sensors.end());
  EXPECT_EQ(clock->range, "1970-01-01T00:00:00Z to 2100-01-01T00:00:00Z");
}

TEST_F(BriefOf, ArraysAndLoopsAreToldAsTheyAreWritten) {
  auto compiled = compiler::compileText("m.mission", R"(mission m
var peaks[3]: temperature = 0 degC in -5 degC .. 45 degC
var n : number = 0 in 0 .. 2
var p : position = 39 N 74 W
state s
begin
  flightprofile surfaced
  sensors temp, lat, lon, missiontime
  events
    case temp > peaks[n] do
      push(peaks, temp) set peaks[n] = temp set p = here
      for i in 0 .. 1 do
        set peaks[i + 1] = temp
        for j in 0 .. i do if peaks[j] == temp then log "same", j end end
      end
      set n = min(n + 1, 2)
    end stay
    case missiontime > 1 h || distance(p) > 1 km exit
end
)");
  ASSERT_TRUE(compiled);
  compilation_ = std::move(*compiled);
  ASSERT_TRUE(compilation_.checked);
  const report::Brief of = brief();
  ASSERT_EQ(of.states.size(), 1U);
  EXPECT_EQ(
      of.states[0].events.at(0).then,
      "does `push(peaks, temp)`, sets `peaks[n]` to `temp`, sets `p` to `here`, (`for i in 0 "
      ".. 1`: sets `peaks[i + 1]` to `temp`, (`for j in 0 .. i`: (if `peaks[j] == temp`: logs "
      "“same” with `j`))), sets `n` to `min(n + 1, 2)`; then stays");
  EXPECT_EQ(of.values.at(0).name, "peaks[3]");
}

TEST_F(BriefOf, SensorsSayFromWhereAndWhenTheyAreUnknown) {
  const report::Brief of = brief();
  const auto depth = std::ranges::find(of.sensors, "depth", &report::BriefSensor::name);
  ASSERT_NE(depth, of.sensors.end());
  EXPECT_EQ(depth->vehicle_name, "m_depth");
  EXPECT_EQ(depth->from, "flight computer");
  EXPECT_EQ(depth->range, "0 m to 1200 m");
  EXPECT_EQ(depth->stale, "20 s");
  const auto lat = std::ranges::find(of.sensors, "lat", &report::BriefSensor::name);
  ASSERT_NE(lat, of.sensors.end());
  EXPECT_EQ(lat->range, "90 00.000 S to 90 00.000 N");
  const auto pitch = std::ranges::find(of.sensors, "pitch", &report::BriefSensor::name);
  ASSERT_NE(pitch, of.sensors.end());
  EXPECT_EQ(pitch->range, "-90 deg to 90 deg");
}

TEST_F(BriefOf, VerdictsKeepTheirWordsPremisesAndReasons) {
  report::CheckedMission found;
  found.requirements = {
      {{}, "require\n  stack <= 2", "proved", std::nullopt, "a premise", ""},
      {{}, "require reach third", "undecided", std::nullopt, "", "a reason"},
      {{}, "require always n < 1", "refuted", report::FlightSearch{9, "", 0, 0}, "", ""}};
  found.remarks = {{{}, "the mission ends after 1 h", report::Remark::Subject::End},
                   {{}, "if the SBC …", report::Remark::Subject::WayHome},
                   {{}, "possible livelock"}};
  const report::Brief of = brief(found);
  ASSERT_EQ(of.requirements.size(), 3U);
  EXPECT_EQ(of.requirements[0].text, "require stack <= 2");
  EXPECT_EQ(of.requirements[0].verdict, "proved");
  EXPECT_THAT(of.requirements[0].because, ElementsAre("a premise"));
  EXPECT_EQ(of.requirements[1].verdict, "undecided");
  EXPECT_THAT(of.requirements[1].because, ElementsAre("a reason"));
  EXPECT_EQ(of.requirements[2].verdict, "refuted");
  EXPECT_THAT(of.requirements[2].because, ElementsAre("none of 9 simulated flights violates it"));
  ASSERT_EQ(of.remarks.size(), 1U) << "the others are in the summary";
  EXPECT_EQ(of.remarks[0].text, "possible livelock");
  EXPECT_EQ(of.summary.front(), "Of 3 requirements: 1 violated, 1 undecided and 1 proved.");
  EXPECT_THAT(of.summary, ::testing::Contains("The mission ends after 1 h."));
}

TEST_F(BriefOf, TheSummarySaysDepthStackAndWayHome) {
  EXPECT_THAT(
      brief().summary,
      ElementsAre(
          "The mission states no requirements.",
          "The commands lead at most 25 m deep, which includes an overshoot of up to 5 m "
          "when the vehicle turns.",
          "At most 1 state waits on the call stack (`first` calls `third`).",
          "If the payload computer (SBC) fails, the vehicle takes control within 1 min 12 s "
          "and is at the surface within 11 min 32 s, from at most 25 m (assuming "
          "silence_secs 24).",
          HasSubstr("runs again within 5 min 0 s of the newest")));
}

/// What a REMUS does then is not in anything public.
TEST_F(BriefOf, TheWayHomeOfARemusIsAssumed) {
  const auto remus = vehicles::families::remus100.usual_own_mission();
  EXPECT_THAT(summaryOf(*compilation_.checked, {}, remus.get(), 25),
              Contains(AllOf(HasSubstr("the vehicle is assumed to end the override within"),
                             HasSubstr("a time-out that RECON does not state"),
                             Not(HasSubstr("takes control")))));
}

TEST_F(BriefOf, DigestsAreOfTheTextsAndTheBinary) {
  const auto hashes = brief().hashes;
  ASSERT_EQ(hashes.size(), 3U);
  EXPECT_EQ(hashes[0].of, "m.mission");
  EXPECT_EQ(hashes[0].sha256.size(), 64U);
  EXPECT_EQ(hashes[1].of, "the standard library");
  EXPECT_NE(hashes[0].sha256, hashes[1].sha256);
  EXPECT_EQ(hashes[2].sha256, "0123");
}

TEST(BriefComments, ACommentBesideIsNotOneAboveTheNext) {
  const std::string text = "a = 1  # one\n       # more\nb = 2\n  # indented\nc = 3\n";
  EXPECT_EQ(commentBeside(text, 5), "one more");
  EXPECT_EQ(commentAbove(text, text.find("b =")), "");
  EXPECT_EQ(commentAbove(text, text.find("c =")), "");
  EXPECT_EQ(commentBeside(text, text.size()), "");
  EXPECT_EQ(commentAbove("# top\nx", 6), "top");
  EXPECT_EQ(commentAbove("x", 0), "");
  EXPECT_EQ(commentAtHead(""), "");
}

}  // namespace
}  // namespace glider::analysis
