// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The power of a vehicle: its table as `glidercc platform` prints it, and as flights draw it,
// compared with figures that were published or measured.

#include "tests/support/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr double kSecondsPerDay = 86400, kJoulesPerWattHour = 3600;

struct FlownEnergy {
  double mean_W = 0;
  json consumers;  ///< Wh by device

  [[nodiscard]] double share(const std::string& device) const {
    double sum = 0;
    for (const auto& [name, used_Wh] : consumers.items()) {
      sum += used_Wh.get<double>();
    }
    return consumers.value(device, 0.0) / sum;
  }
};

class PowerCommand : public ::testing::Test {
 protected:
  [[nodiscard]] Outcome glidercc(const std::string& arguments) const {
    return runShell("cd " + folder_.path().string() + " && $GLIDERCC " + arguments);
  }

  /// Half a day of yos to 45 m with a surfacing of 15 min every 3 h, as stock missions have.
  [[nodiscard]] FlownEnergy fly(const std::string& battery, const std::string& sensors = "",
                                const std::string& water = "") const {
    const std::string name =
        "mission m\nstate s\nbegin\n  flightroute heading(90 deg)\n"
        "  flightprofile yo_and_surface(5 m, 45 m, period = 3 h, pause = "
        "15 min)\n  sensors missiontime, depth, temp" +
        sensors + "\n  events\n    case missiontime >= 11 h exit\nend\n";
    (void)folder_.write("m.mission", name);
    (void)folder_.write("w.toml", "name = \"w\"\nskeleton = \"" GLIDER_SOURCE_DIR
                                  "/scenarios/skeleton.mi\"\n"
                                  "duration_s = 43200\nseed = 1\n[start]\nlatitude_deg = 39.175\n"
                                  "longitude_deg = -73.83\n[ocean]\nsurface_temp_degC = 20\n"
                                  "bottom_temp_degC = 8\nthermocline_depth_m = 14\n"
                                  "thermocline_thickness_m = 3\ndensity_kgm3 = 1025\n"
                                  "water_depth_m = 100\n" +
                                      water +
                                      "[vehicle]\ndrag = 0.12\n"
                                      "[vehicle.battery]\n" +
                                      battery);
    const Outcome flown = glidercc("sim m.mission --scenario w.toml -o f --format json");
    EXPECT_EQ(flown.status, 0) << flown.err;
    const json flight = json::parse(slurp(folder_.path() / "f" / "flight.json"));
    const json& figures = flight.at("figures");
    FlownEnergy energy{figures.at("energy").at("used").get<double>() * kJoulesPerWattHour /
                           figures.at("duration").get<double>(),
                       json::object()};
    for (const json& one : figures.at("energy").at("consumers")) {
      energy.consumers[one.at("device").get<std::string>()] = one.at("used");
    }
    return energy;
  }

  TemporaryFolder folder_;
};

/// Two operators' logs have 3.8 W, and 90 days with a pack of 8424 Wh are 3.9 W; an alkaline pack
/// of 7.8 MJ lasts 26 days at the 3.5 W of its maker's example. A CTD takes 4.2 % of that pack in
/// 30 days at half of the time and twice the power of ours. They carry a fluorometer, and so does
/// this one.
TEST_F(PowerCommand, AFlightWithoutTheSbcDrawsWhatRealVehiclesDo) {
  const FlownEnergy stock = fly("sbc_W = 0\n", ", chlorophyll", "chlorophyll_ugpl = 1\n");
  EXPECT_NEAR(stock.mean_W, 3.9, 0.25 * 3.9);
  EXPECT_NEAR(7.8e6 / stock.mean_W / kSecondsPerDay, 26, 0.25 * 26);
  EXPECT_NEAR(stock.share("ctd"), 0.042, 0.01);
  EXPECT_EQ(stock.share("SBC"), 0);
  double sum_Wh = 0;
  for (const auto& [name, used_Wh] : stock.consumers.items()) {
    sum_Wh += used_Wh.get<double>();
  }
  EXPECT_NEAR(sum_Wh * kJoulesPerWattHour, stock.mean_W * 39664, 0.01 * stock.mean_W * 39664);
}

/// The paper: the SBC, 3.42 W, is too hungry for a glider.
TEST_F(PowerCommand, TheSbcMoreThanHalvesTheEndurance) {
  const FlownEnergy stock = fly("sbc_W = 0\n");
  const FlownEnergy with = fly("");
  EXPECT_NEAR(with.mean_W - stock.mean_W, 3.42, 0.01) << "that of the board ts7800";
  EXPECT_GT(with.mean_W, 2 * stock.mean_W);
  EXPECT_GT(with.share("SBC"), 0.5);
}

TEST_F(PowerCommand, ADeviceDrawsWhileTheMissionReadsIt) {
  const std::string carried = "surface_oxygen_uM = 250\nbottom_oxygen_uM = 200\n";
  const FlownEnergy with = fly("sbc_W = 0\n", ", oxygen", carried);
  const FlownEnergy without = fly("sbc_W = 0\n", "", carried);
  EXPECT_EQ(without.consumers.count("optode"), 0U);
  EXPECT_NEAR(with.mean_W - without.mean_W, 0.2, 0.01);
}

TEST_F(PowerCommand, AnEmptyPackEndsTheFlight) {
  (void)fly("");  // writes the mission and the scenario
  ASSERT_EQ(runShell("cd " + folder_.path().string() +
                     " && sed -i 's/^.vehicle.battery.$/&\\ncapacity_kJ = 18/' w.toml")
                .status,
            0);
  const Outcome flown = glidercc("sim m.mission --scenario w.toml -o f");
  EXPECT_EQ(flown.status, 1) << flown.err;
  EXPECT_THAT(flown.err, HasSubstr("[GL9398 pack-empty]"));
  EXPECT_THAT(flown.err, HasSubstr("most went to: "));
  EXPECT_THAT(flown.out, HasSubstr("the batteries are empty at "));
}

/// The mission's own account, at the nominal voltage of a full pack, against the simulator's.
TEST_F(PowerCommand, AMissionReadsWhatItsPackHasLeft) {
  (void)fly("");  // writes the scenario
  (void)folder_.write("m.mission",
                      "mission m\npack 2 Ah at 14.4 V reserve 20 %\nalways\n"
                      "  case energyleft < 70 % do log \"used\", energyused, energyleft end exit\n"
                      "state s\nbegin\n  flightroute heading(90 deg)\n"
                      "  flightprofile yo(5 m, 45 m)\n  sensors missiontime, depth\n  events\n"
                      "    case missiontime >= 11 h exit\nend\n");
  const Outcome flown = glidercc("sim m.mission --scenario w.toml -o f --format json");
  EXPECT_EQ(flown.status, 0) << flown.err;
  const json flight = json::parse(slurp(folder_.path() / "f" / "flight.json"));
  const json& energy = flight.at("figures").at("energy");
  constexpr double kFullV = 14.4, kEmptyV = 10;
  EXPECT_NEAR(energy.at("capacity").get<double>(),
              2 * (kFullV - kEmptyV) / std::log(kFullV / kEmptyV), 1e-6)
      << "the vehicle carries that pack";
  ASSERT_EQ(runShell("cd " + folder_.path().string() +
                     " && sed 's/^.vehicle.battery.$/&\\ncapacity_kJ = 360/' w.toml > own.toml")
                .status,
            0);
  const Outcome with_own = glidercc("sim m.mission --scenario own.toml -o g --format json");
  EXPECT_EQ(with_own.status, 0);
  EXPECT_THAT(with_own.err, HasSubstr("hold 8.287 Ah, those of the mission's line `pack` 2 Ah"));
  const json own = json::parse(slurp(folder_.path() / "g" / "flight.json"));
  EXPECT_NEAR(own.at("figures").at("energy").at("capacity").get<double>(), 100, 1e-6)
      << "a scenario's own batteries count";
  const std::string events = slurp(folder_.path() / "f" / "events.csv");
  const size_t at = events.find("used ");
  ASSERT_NE(at, std::string::npos) << events;
  double used_J = 0, left = 0;
  ASSERT_EQ(std::sscanf(events.c_str() + at, "used %lf J %lf", &used_J, &left), 2);
  EXPECT_LT(left, 0.7);
  EXPECT_GT(left, 0.69);
  EXPECT_NEAR(used_J, 0.3 * 2 * kFullV * kJoulesPerWattHour, 0.01 * used_J);
  EXPECT_NEAR(used_J, energy.at("used").get<double>() * kJoulesPerWattHour, 0.1 * used_J)
      << "the voltage sags";
}

TEST_F(PowerCommand, PlatformPrintsEveryRowWithItsSource) {
  const Outcome slocum = glidercc("platform slocum");
  for (const char* text :
       {"8000 kJ (2222.22 Wh), 14.4 V full, 10 V empty, 0.47 ohm", "0.29 J/cc + 0.018 J/cc/m",
        "SBC (ts7800)", "3.42 W", "+-30 %", "the paper (OCEANS 2014)"}) {
    EXPECT_THAT(slocum.out, HasSubstr(text));
  }
  EXPECT_THAT(glidercc("platform lauv").out, HasSubstr("up to 80 W at 1700 rpm"));
  const json power = json::parse(glidercc("platform slocum --format json").out).at("power");
  EXPECT_EQ(power.at("sbc").at("board"), "ts7800");
  EXPECT_EQ(power.at("draws").at(3).at("amount_per_m"), 0.018);
  // At the surface: hotel, CTD and what is on there, against the median of real logs.
  double surface_W = 0;
  for (const json& row : power.at("draws")) {
    EXPECT_FALSE(row.at("source").get<std::string>().empty());
    if (row.at("when") == "always" || row.at("when") == "surface") {
      surface_W += row.at("amount").get<double>();
    }
  }
  EXPECT_NEAR(surface_W, 5.2, 0.1 * 5.2);
}

}  // namespace
}  // namespace glider::tests
