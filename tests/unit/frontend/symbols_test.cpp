// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What an editor learns about the names of a mission, valid or with errors.

#include "tests/unit/frontend/symbols_of.h"

#include <gmock/gmock.h>

namespace glider::frontend {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing_support::SymbolsRun;

constexpr std::string_view kMission = R"(mission tour
const home = 39.2 N 73.9 W   # where the boat waits
const lapse = 2 degC / 10 m
const track: path = [39.2 N 73.9 W, 39.3 N 73.9 W]
# How deep it goes.
# Not deeper.
param bottom: length = 25 m in 10 m .. 30 m
var reach: number = 0
extern function oxygen(depth: length, temp: temperature): number in 0 .. 500
extern sensor ping: length in 0 m .. 120 m stale after 10 s
extern flightroute spiral(centre: position) reads ping, depth
flightprofile saw(top: length) begin
  var down: bool = true
  entry do set down = depth < top descend(top, 26 deg) end
  events
    case down stay
end
state start begin
  flightprofile saw(bottom)
  sensors missiontime, depth every 4 s
  events
    case oxygen(depth, temp) < 90 do set reach = min(reach + 1, 5) end goto leg(home)
    case spread(temp, 10 m of m_depth) > lapse * 1 m exit
end
state leg(to: position) begin
  flightroute spiral(to)
  flightprofile yo(5 m, bottom, 26 deg, 26 deg)
  var laps: number = 0
  events
    case distance(to) < 200 m && laps > reach call start
end
require never leg after start
require reach leg
)";

TEST(Symbols, OfArrays) {
  const SymbolsRun run{
      "mission m\nvar recent[8]: temperature = unknown\nconst depths = [10 m, 20 m]\n"
      "param n[2]: number = 0\nstate s begin flightprofile surfaced events\n"
      "case true do set recent[0] = temp for i in 0 .. 1 do set recent[n[i]] = temp end end stay\n"
      "end\n"};
  EXPECT_THAT(run.declared(),
              HasSubstr("variable recent: temperature[8] [degC] at 2:5, used 6:18 6:58\n"
                        "constant depths: length[2] [m] at 3:7\n"
                        "parameter n: number[2] at 4:7, used 6:65\n"));
}

TEST(Symbols, OfARightMission) {
  const SymbolsRun run{std::string(kMission)};
  EXPECT_EQ(run.declared(), R"(mission tour: tour at 1:9
constant home: position at 2:7, used 22:81
constant lapse: temperature/length [degC/m] at 3:7, used 23:42
constant track: path at 4:7
parameter bottom: length [m] at 7:7, used 19:21 27:25
variable reach: number at 8:5, used 22:42 22:54 30:41
function oxygen: oxygen(depth: length, temp: temperature): number at 9:17, used 22:10
sensor ping: length [m] at 10:15, used 11:51
route spiral: spiral(centre: position) at 11:20, used 26:15
profile saw: saw(top: length) at 12:15, used 19:17
parameter saw.top: length [m] at 12:19, used 14:31 14:43
variable saw.down: bool at 13:7, used 14:16 16:10
state start: start at 18:7, used 30:52 32:25
state leg: leg(to: position) at 25:7, used 22:77 32:15 33:15
parameter leg.to: position at 25:11, used 26:22 30:19
variable leg.laps: number at 28:7, used 30:34
)");
}

TEST(Symbols, NamesOfVehiclesAreNamesOfNothingElse) {
  const SymbolsRun run{
      "mission m\nvar bob: length = 3 m\nvar vehicles: length = bob\n"
      "vehicles ada, bob\nconst c = vehicles + 1 m\n"};
  EXPECT_THAT(run.declared(), HasSubstr("variable bob: length [m] at 2:5, used 3:24\n"));
  EXPECT_THAT(run.declared(), HasSubstr("variable vehicles: length [m] at 3:5, used 5:11\n"));
}

TEST(Symbols, BuiltInNamesAreUsedToo) {
  const SymbolsRun run{std::string(kMission)};
  EXPECT_EQ(run.at("set down = depth"),
            "sensor depth: length [m], used 11:57 14:23 20:24 22:17 23:31");
  EXPECT_EQ(run.at("descend"), "command descend: descend(to: length, pitch: angle), used 14:35");
  EXPECT_EQ(run.at("distance"), "function distance: distance(p [, q]), used 30:10");
  EXPECT_EQ(run.at("missiontime"), "clock missiontime: time [s], used 20:11");
  EXPECT_THAT(run.at("flightprofile yo"),
              HasSubstr("profile yo: yo(top: length, bottom: length, "
                        "dive: angle = usual_pitch, climb: angle = usual_pitch) at "));
  EXPECT_EQ(run.at("5 m"), "nothing");
}

TEST(Symbols, AreDescribedByTheirComments) {
  const SymbolsRun run{std::string(kMission)};
  const auto description = [&](std::string_view text) {
    return run.table.at(run.file, run.after(text))->description;
  };
  EXPECT_EQ(description("const home"), "where the boat waits");
  EXPECT_EQ(description("param bottom"), "How deep it goes. Not deeper.");
  EXPECT_EQ(description("var reach"), "var reach: number = 0");
  EXPECT_EQ(description("state leg"), "state leg(to: position)");
  EXPECT_EQ(description("state leg(to"), "parameter of state `leg`");
  EXPECT_EQ(description("sensors missiontime"),
            "time since the computer in the payload bay got control");
  EXPECT_THAT(description("flightprofile yo"), HasSubstr("Up and down between two depths"));
}

TEST(Symbols, AreVisibleInTheirScopes) {
  const SymbolsRun run{std::string(kMission)};
  for (std::string_view name : {"home", "bottom", "start", "yo", "depth", "min", "descend"}) {
    EXPECT_TRUE(run.sees("case distance(", name)) << name;
  }
  EXPECT_TRUE(run.sees("case distance(", "laps"));
  EXPECT_FALSE(run.sees("case oxygen(", "laps"));
  EXPECT_FALSE(run.sees("case oxygen(", "down"));
  // A profile sees no name of the mission.
  EXPECT_TRUE(run.sees("case down", "top"));
  EXPECT_TRUE(run.sees("case down", "ping"));
  EXPECT_FALSE(run.sees("case down", "home"));
  EXPECT_FALSE(run.sees("case down", "start"));
  EXPECT_EQ(SymbolsRun("mission m\nconst c = 1\nflightprofile p begin events case c > 0 stay end\n")
                .at("const c"),
            "constant c: number at 2:7");
}

TEST(Symbols, OfTwoWithOneNameTheFirstIsMeant) {
  const SymbolsRun run("mission m\nconst a = 1\nconst a = 2 m\nstate s begin events case a > 0");
  EXPECT_EQ(run.at("case a"), "constant a: number at 2:7, used 4:27");
  // A state may be called like a sensor.
  const SymbolsRun states("mission m\nstate depth begin events case depth > 1 goto depth end\n");
  EXPECT_EQ(states.at("goto depth"), "state depth: depth at 2:7, used 2:46");
}

TEST(Symbols, WordsOfTheLanguageThatAreNames) {
  const SymbolsRun run(
      "mission m\nvar within: number = 0\nstate m begin\n  events\n"
      "    case within > 1 do set within = 2 end goto m\nend\nresume within 5 min\n"
      "require exit within 1 h\n");
  EXPECT_EQ(run.at("var within"), "variable within: number at 2:5, used 5:10 5:28");
  EXPECT_EQ(run.at("state m"), "state m: m at 3:7, used 5:48");
}

TEST(Symbols, WhatIsBrokenHasNoType) {
  const SymbolsRun run(
      "mission m\nconst a = 5 m + 3 s\nconst b = nowhere\nconst c: lenght = 5 m\n"
      "const d: length = 5 s\nvar e: = 5\nparam f\nstate s(x: lenght, y) begin end\n"
      "const g = a\nconst last = 5 m\nstate t( begin end\n");
  EXPECT_EQ(run.declared(), R"(mission m: m at 1:9
constant a: ? at 2:7, used 9:11
constant b: ? at 3:7
constant c: ? at 4:7
constant d: length [m] at 5:7
variable e: ? at 6:5
parameter f: ? at 7:7
state s: ? at 8:7
parameter s.x: ? at 8:9
parameter s.y: ? at 8:20
constant g: ? at 9:7
constant last: length [m] at 10:7
state t: ? at 11:7
)");
}

TEST(Symbols, AHalfTypedGuard) {
  const SymbolsRun run(
      "mission m\nconst top = 5 m\nstate s begin\n  flightprofile surfaced\n"
      "  var laps: number = 0\n  events\n    case laps > 1 && dep\nend\nstate t begin\n"
      "  events\n    case depth < top goto s\nend\n");
  EXPECT_EQ(run.at("&& dep"), "nothing");
  EXPECT_TRUE(run.sees("&& dep", "depth"));
  EXPECT_TRUE(run.sees("&& dep", "laps"));
  EXPECT_EQ(run.at("case laps"), "variable s.laps: number at 5:7, used 7:10");
  EXPECT_EQ(run.at("state s"), "state s: s at 3:7, used 11:27");
  EXPECT_EQ(run.at("const top"), "constant top: length [m] at 2:7, used 11:18");
}

TEST(Symbols, WithoutAnEndOrABegin) {
  const std::string head = "mission m\nstate s begin\n";
  const std::string members = "  var laps: number = 0\n  events\n";
  const std::string first = "    case laps > 1 do set laps = 0 end stay\n";
  const std::string last = "    case laps > 2 exit\n";
  const std::string next = "state t begin events case true goto s end\n";
  for (const std::string& text :
       {head + members + first + last + next,
        "mission m\nstate s\n" + members + first + last + "end\n" + next,
        head + members + "    case laps > 1 do set laps = 0 stay\n" + last + "end\n" + next,
        head + members + "    case laps > 1 set laps = 0 end stay\n" + last + "end\n" + next}) {
    const SymbolsRun run(text);
    EXPECT_THAT(run.at("var laps"), HasSubstr("variable s.laps: number at 3:7, used 5:10 5:"))
        << text;
    EXPECT_THAT(run.at("var laps"), HasSubstr(" 6:10")) << text;
    EXPECT_THAT(run.at("state s"), HasSubstr("state s: s at 2:7, used ")) << text;
    EXPECT_THAT(run.at("state t"), HasSubstr("state t: t at ")) << text;
    EXPECT_TRUE(run.sees("laps > 2", "laps")) << text;
    EXPECT_FALSE(run.sees("case true", "laps")) << text;
  }
}

TEST(Symbols, OfTextsThatAreNotAMission) {
  for (const char* text : {"", "mission", "state", "extern", "extern function", "const",
                           "var :", "state s(", "state s(x", "state s(x:", "flightprofile p(x:",
                           "flightprofile", "goto", "require never a after", "end end end", "/*",
                           "\xFF\xFE", "((((((((", "\xEF\xBB\xBFmission m"}) {
    const SymbolsRun run(text);
    for (const Symbol& symbol : run.table.symbols()) {
      EXPECT_THAT(symbol.name, Not(testing::IsEmpty())) << text;
    }
  }
}

}  // namespace
}  // namespace glider::frontend
