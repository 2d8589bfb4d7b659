// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// glidercc build --emit symbols, of right missions and of broken ones.

#include "tests/support/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <gmock/gmock.h>

namespace glider::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kFigure2 = GLIDER_SOURCE_DIR "/missions/figure2.mission";

Outcome symbolsOf(const std::string& file, const std::string& more = "") {
  return runShell("$GLIDERCC build " + file + " --emit symbols -o - " + more);
}

/// The symbol called `name`; null if there is none.
json named(const json& table, const std::string& name) {
  for (const json& symbol : table["symbols"]) {
    if (symbol["name"] == name) {
      return symbol;
    }
  }
  return nullptr;
}

json place(int line, int column) {
  return {{"line", line}, {"column", column}};
}

TEST(SymbolsCommand, OfARightMission) {
  const Outcome outcome = symbolsOf(kFigure2);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const json table = json::parse(outcome.out);
  EXPECT_EQ(table["version"], 1);
  EXPECT_EQ(table["symbols"][0]["kind"], "mission");
  EXPECT_EQ(table["symbols"][0]["name"], "sampleMission");
  const json depth = named(table, "depth");
  EXPECT_EQ(depth["kind"], "sensor");
  EXPECT_EQ(depth["vehicle_name"], "m_depth");
  EXPECT_EQ(depth["type"], "length");
  EXPECT_EQ(depth["unit"], "m");
  EXPECT_EQ(depth["declared"], nullptr);
  EXPECT_FALSE(depth["uses"].empty());
  EXPECT_EQ(depth["uses"][0]["file"], kFigure2);
  EXPECT_EQ(named(table, "s2")["declared"]["file"], kFigure2);
}

TEST(SymbolsCommand, OfABrokenMissionWithABrokenImport) {
  const TemporaryFolder folder;
  const auto good = folder.write("good.mission", "const home = 39.2 N 73.9 W\n");
  const auto bad =
      folder.write("bad.mission", "const far = 200 m\nconst farther =\nimport \"good\"\n");
  const std::string file =
      folder
          .write("m.mission",
                 "mission m\nimport \"nowhere\"\nimport \"bad\"\nconst é = 5\nstate s\nbegin\n"
                 "  flightroute nav(home)\n  events\n    case distance(home) < far && dep\n")
          .string();
  const Outcome outcome = symbolsOf(file);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("error"));
  const json table = json::parse(outcome.out);
  const json far = named(table, "far");
  EXPECT_EQ(far["type"], "length");
  EXPECT_EQ(far["declared"]["file"], bad.string());
  EXPECT_EQ(far["uses"][0]["begin"], place(9, 27));
  EXPECT_EQ(far["uses"][0]["end"], place(9, 30));
  EXPECT_EQ(named(table, "home")["type"], "position");
  EXPECT_EQ(named(table, "home")["declared"]["file"], good.string());
  EXPECT_EQ(named(table, "farther")["type"], nullptr);
  EXPECT_EQ(named(table, "s")["kind"], "state");
  EXPECT_EQ(named(table, "nav")["kind"], "route");
}

TEST(SymbolsCommand, OfAMissionWithWrongTypes) {
  const TemporaryFolder folder;
  const std::string file =
      folder
          .write("m.mission",
                 "mission m\nvar laps: lenght = 0\nstate s\nbegin\n  flightprofile surfaced\n"
                 "  events\n    case laps + 1 s > 3 m exit\nend\n")
          .string();
  const Outcome outcome = symbolsOf(file);
  EXPECT_EQ(outcome.status, 1);
  const json laps = named(json::parse(outcome.out), "laps");
  EXPECT_EQ(laps["type"], nullptr);
  EXPECT_EQ(laps["uses"].size(), 1U);
}

TEST(SymbolsCommand, WithoutThePlatformThereAreNoSensors) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("m.mission", "mission m\nplatform slocumm\nconst a = 5 m\n").string();
  const Outcome outcome = symbolsOf(file);
  EXPECT_EQ(outcome.status, 1);
  const json table = json::parse(outcome.out);
  EXPECT_EQ(named(table, "a")["type"], "length");
  EXPECT_EQ(named(table, "depth"), nullptr);
  EXPECT_EQ(named(table, "yo")["kind"], "profile");
}

TEST(SymbolsCommand, AtAPosition) {
  const TemporaryFolder folder;
  const std::string file =
      folder
          .write("m.mission",
                 "mission m\nstate s\nbegin\n  var laps: number = 0\n  events\n"
                 "    /* é */ case laps > 1 && dep\nend\nstate t begin events case true exit end\n")
          .string();
  const Outcome inside = symbolsOf(file, "--at 6:18");
  EXPECT_EQ(inside.status, 1);
  const json laps = json::parse(inside.out);
  EXPECT_EQ(laps["symbol"]["name"], "laps");
  EXPECT_EQ(laps["symbol"]["owner"], "s");
  EXPECT_EQ(laps["symbol"]["scope"]["begin"], place(2, 1));
  EXPECT_EQ(laps["symbol"]["scope"]["end"], place(7, 4));
  const json open = json::parse(symbolsOf(file, "--at 6:99").out);
  EXPECT_EQ(open["symbol"], nullptr);
  EXPECT_THAT(open["visible"].dump(), HasSubstr("\"laps\""));
  EXPECT_THAT(open["visible"].dump(), HasSubstr("\"depth\""));
  const json elsewhere = json::parse(symbolsOf(file, "--at 99:1").out);
  EXPECT_THAT(elsewhere["visible"].dump(), testing::Not(HasSubstr("\"laps\"")));
}

TEST(SymbolsCommand, IsWrittenBesideWhereTheCommandRuns) {
  const TemporaryFolder folder;
  const std::string file = folder.write("m.mission", "mission m\nstate\n").string();
  const Outcome outcome =
      runShell("cd " + folder.path().string() + " && $GLIDERCC build m.mission --emit symbols");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(json::parse(slurp(folder.path() / "m.symbols.json"))["version"], 1);
}

TEST(SymbolsCommand, UsageErrors) {
  const TemporaryFolder folder;
  const Outcome place = symbolsOf(kFigure2, "--at 7");
  EXPECT_EQ(place.status, 2);
  EXPECT_THAT(place.err, HasSubstr("7:12"));
  EXPECT_THAT(place.out, IsEmpty());
  for (const char* wrong : {"0:1", "1:0", "1:", ":1", "1:1x", "-1:1", "1:99999999999"}) {
    EXPECT_EQ(symbolsOf(kFigure2, std::string("--at ") + wrong).status, 2) << wrong;
  }
  EXPECT_EQ(runShell("$GLIDERCC build " + kFigure2 + " --emit ast --at 1:1 -o -").status, 2);
  const std::string ir = (folder.path() / "m.ir").string();
  ASSERT_EQ(runShell("$GLIDERCC build " + kFigure2 + " --emit ir -o " + ir).status, 0);
  const Outcome text = symbolsOf(ir);
  EXPECT_EQ(text.status, 2);
  EXPECT_THAT(text.err, HasSubstr("GL9351"));
}

}  // namespace
}  // namespace glider::tests
