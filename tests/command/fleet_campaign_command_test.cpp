// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `glidercc campaign` of a fleet: trouble in what its vehicles send each other.

#include "tests/support/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <gmock/gmock.h>
#include <set>
#include <string>

namespace glider::tests {
namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;

/// A vehicle tells how deep the other one is to dive.
constexpr const char* kTeller = R"(mission teller
share bottom: length = 20 m in 0 m .. 60 m precision 1 m every 2 min
require always depth < 40 m
state out
begin
  flightprofile yo(5 m, 20 m)
  sensors       missiontime, depth
  events
    case missiontime >= 40 min exit
end
)";
/// The other one does it; `%` is how.
constexpr const char* kTrusting = R"(mission trusting
share bottom: length in 0 m .. 60 m precision 1 m every 2 min
var to: length = 20 m in 0 m .. 60 m
require always depth < 40 m
state out
begin
  flightprofile yo(5 m, 20 m)
  sensors       missiontime, depth, peer.bottom
  events
    case missiontime >= 40 min exit
    case peer.bottom >= 10 m   do set to = peer.bottom end goto follow
end
state follow
begin
  flightprofile yo(5 m, %)
  sensors       missiontime, depth, peer.bottom
  events
    case missiontime >= 40 min exit
    case peer.bottom >= 10 m && (peer.bottom > to || peer.bottom < to) do set to = peer.bottom end stay
end
)";

class FleetCampaign : public ::testing::Test {
 protected:
  FleetCampaign() {
    (void)folder_.write("teller.mission", kTeller);
    trusting("clamp(to, 10 m, 30 m)");
    fleet("");
  }
  void trusting(const std::string& bottom) const {
    std::string text = kTrusting;
    (void)folder_.write("trusting.mission", text.replace(text.find('%'), 1, bottom));
  }
  void fleet(const std::string& head) const {
    (void)folder_.write("f.toml", head + R"(
[[vehicle]]
name = "ada"
mission = "teller.mission"
[[vehicle]]
name = "bob"
mission = "trusting.mission"
bearing_deg = 90
distance_m = 400
)");
  }
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    return runShell("cd " + folder_.path().string() + " && $GLIDERCC campaign f.toml " + arguments);
  }
  /// The flights of a campaign.
  [[nodiscard]] json flights(const std::string& arguments) const {
    const Outcome flown = run(arguments + " --format json");
    EXPECT_LE(flown.status, 1) << flown.err;
    return json::parse(flown.out)["flights"];
  }

  const TemporaryFolder folder_;
};

TEST_F(FleetCampaign, EachKindOfTroubleDoesWhatItSays) {
  const json all = flights("--flights 24 --jobs 2");
  ASSERT_EQ(all.size(), 24U);
  const char* const kinds[] = {"none", "loss", "silence", "noise", "liar", "several"};
  double none = 0, loss = 0;
  for (const json& one : all) {
    EXPECT_EQ(one["fault"], kinds[one["number"].get<size_t>() % 6]);
    EXPECT_TRUE(one["violations"].empty()) << one;
    EXPECT_GT(one["sent"].get<int>(), 30);
    if (one["fault"] == "silence") {
      EXPECT_EQ(one["received"], 0);
    }
    none += one["fault"] == "none" ? one["received"].get<double>() : 0;
    loss += one["fault"] == "loss" ? one["received"].get<double>() : 0;
  }
  EXPECT_LT(loss, 0.85 * none);
}

TEST_F(FleetCampaign, TheSameSeedFliesTheSame) {
  const json one = flights("--flights 12 --seed 4 --jobs 1");
  EXPECT_EQ(one, flights("--flights 12 --seed 4 --jobs 2"));
  EXPECT_NE(one, flights("--flights 12 --seed 5"));
}

/// The prover refutes it, and the campaign must see why.
TEST_F(FleetCampaign, AMissionThatTrustsALiarIsFound) {
  trusting("clamp(to, 10 m, 60 m)");
  const Outcome flown = run("--flights 20 --fault liar");
  EXPECT_EQ(flown.status, 1);
  EXPECT_THAT(flown.out, HasSubstr("bob: `require always depth < 40 m` does not hold\n  glidercc "
                                   "campaign f.toml --fault liar --seed 1 --only "));
  EXPECT_THAT(flown.out, HasSubstr("ada: `require always depth < 40 m`: violated in 0 of 20"));
  const json quiet = flights("--flights 3 --fault silence");
  for (const json& one : quiet) {
    EXPECT_TRUE(one["violations"].empty());
  }
}

TEST_F(FleetCampaign, OneFlightIsFlownAgain) {
  trusting("clamp(to, 10 m, 60 m)");
  const json all = flights("--flights 20 --fault liar");
  size_t number = 0;
  while (number < all.size() && all[number]["violations"].empty()) {
    ++number;
  }
  ASSERT_LT(number, all.size());
  const Outcome again =
      run("--fault liar --only " + std::to_string(number) + " -o again --format json");
  EXPECT_EQ(again.status, 1);
  const json document = json::parse(again.out);
  EXPECT_EQ(document["flight"], all[number]);
  EXPECT_THAT(document["trouble"].get<std::string>(), HasSubstr("ada sends "));
  const json report = json::parse(slurp(folder_.path() / "again" / "flight.json"));
  uint64_t sent = 0;
  for (const json& vehicle : report["vehicles"]) {
    sent += vehicle["modem"]["sent"].get<uint64_t>();
  }
  EXPECT_EQ(sent, all[number]["sent"].get<uint64_t>());
  EXPECT_THAT(report["vehicles"][1].dump(), HasSubstr("this flight violates the requirement"));
}

/// scripts/soak/fleets flies them 2000 times.
TEST_F(FleetCampaign, TheExamplesKeepWhatTheyPromise) {
  for (const char* name : {"thermocline", "relay", "loop"}) {
    const std::string file = std::string(GLIDER_SOURCE_DIR "/missions/fleet/") + name + ".toml";
    EXPECT_EQ(runShell("$GLIDERCC check --strict " + file).status, 0) << name;
    const Outcome flown = runShell("$GLIDERCC campaign --flights 6 " + file);
    EXPECT_EQ(flown.status, 0) << flown.out;
    EXPECT_THAT(flown.out, ContainsRegex("all +6 +6 ")) << flown.out;
  }
}

TEST_F(FleetCampaign, TheReportIsThatOfTheFlight) {
  const json all = flights("--flights 6 --fault loss");
  for (size_t number = 0; number < all.size(); ++number) {
    const Outcome again = run("--fault loss --only " + std::to_string(number) + " -o again");
    const json report = json::parse(slurp(folder_.path() / "again" / "flight.json"));
    uint64_t received = 0;
    for (const json& vehicle : report["vehicles"]) {
      received += vehicle["modem"]["received"].get<uint64_t>();
    }
    EXPECT_EQ(received, all[number]["received"].get<uint64_t>()) << number;
  }
}

/// Without trouble, chance alone loses some; the same in each flight would be one flight.
TEST_F(FleetCampaign, EachFlightHasItsOwnChance) {
  std::set<int> received;
  for (const json& one : flights("--flights 8 --fault none")) {
    received.insert(one["received"].get<int>());
  }
  EXPECT_GT(received.size(), 2U);
}

/// hookbeh refuses the dive, so the vehicle is never in control.
TEST_F(FleetCampaign, WhatTheChecksOfAVehicleFindIsAViolation) {
  std::string deep = kTeller;
  deep.replace(deep.find("yo(5 m, 20 m)"), 13, "yo(5 m, 65 m)");
  deep.replace(deep.find("depth < 40 m"), 12, "depth < 90 m");
  (void)folder_.write("teller.mission", deep);
  const Outcome flown = run("--flights 1 --duration 2h");
  EXPECT_EQ(flown.status, 1);
  EXPECT_THAT(flown.out, HasSubstr(" ada: the mission does not release control\n"));
}

TEST_F(FleetCampaign, SeparationIsJudged) {
  fleet("separation_m = 600\n");
  const Outcome flown = run("--flights 1");
  EXPECT_EQ(flown.status, 1);
  EXPECT_THAT(flown.out,
              ContainsRegex("flight 0 \\(none\\): at [0-9]+ s ada and bob were 39[0-9] m apart\n"));
}

TEST_F(FleetCampaign, RefusesWhatItDoesNotHave) {
  for (const char* option : {"--csv x", "--resume x", "--part 1/2", "--set a=1", "--link x.o",
                             "--scenario shelf_slope", "--boards 5"}) {
    const Outcome refused = run(option);
    EXPECT_EQ(refused.status, 2) << option;
    EXPECT_THAT(refused.err, HasSubstr("a fleet file excludes --")) << option;
  }
  EXPECT_THAT(run("trusting.mission").err, HasSubstr("a fleet file flies alone"));
  EXPECT_THAT(run("--fault delay").err, HasSubstr("none, loss, silence, noise, liar and several"));
  EXPECT_EQ(run("--fault delay --fault none").status, 2) << "one of them is of a vehicle";
  EXPECT_THAT(runShell("cd " + folder_.path().string() +
                       " && $GLIDERCC campaign teller.mission --fault silence --fault delay")
                  .err,
              HasSubstr("`silence` is of the messages of a fleet"));
  const Outcome brief = run("--duration 10min --flights 1");
  EXPECT_EQ(brief.status, 1);
  EXPECT_THAT(brief.err, HasSubstr("[GL9387 "));
}

TEST_F(FleetCampaign, AFleetThatIsSilentHasNothingToDisturb) {
  (void)folder_.write("f.toml", R"(
[[vehicle]]
name = "ada"
mission = "quiet.mission"
)");
  (void)folder_.write("quiet.mission", R"(mission quiet
state out
begin
  flightprofile yo(5 m, 20 m)
  sensors       missiontime
  events
    case missiontime >= 40 min exit
end
)");
  const Outcome refused = run("");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("no mission shares anything"));
}

}  // namespace
}  // namespace glider::tests
