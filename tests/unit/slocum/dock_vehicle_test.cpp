// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The check at the dock plays the SBC: the proglet of a vehicle is at the other end.

#include "hooks/extctl/port.h"
#include "hooks/transport/memory.h"
#include "simulator/slocum/science/extctl_proglet.h"
#include "tests/unit/slocum/dock_bench.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <regex>

namespace glider::slocum::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using vehicles::DockEnd;
using vehicles::DockPart;
using vehicles::DockVerdict;

/// A vehicle that floats, with the vendor's proglet for the list `file`.
class Vehicle final : public OtherEnd {
 public:
  Vehicle(const DockBench& bench, const ExtctlFile& file) : bench_(bench), file_(file) {
    values["u_mission_param_l"] = bench.plan.port.program;
    start();
  }

  std::string run(double now_s, const std::string& arrived) override {
    for (const char c : arrived) {
      received += c;
      to_science_.push_back(static_cast<uint8_t>(c));
    }
    const bool science = now_s >= science_s_ + 1;
    if (now_s >= flight_s_ + cycle_s && !(now_s > pause_s && now_s < pause_s + 9)) {
      flight_s_ = now_s;
      cycle(now_s);
    }
    if (!science) {
      return "";
    }
    science_s_ = now_s;
    if (now_s >= end_s) {
      end_s = INFINITY;
      ended_ = true;
      return "$BY*1b\r\n";
    }
    if (ended_ && now_s >= back_s) {
      ended_ = false;
      start();
    }
    if (ended_) {
      return "";
    }
    proglet_->run(now_s, {this, get, set}, {this, read, write});
    return changed(std::exchange(from_science_, {}), change);
  }

  std::map<std::string, double> values = {{"x_in_gliderdos", 0}};  ///< of the flight controller
  std::string received;
  double cycle_s = 4;
  double pause_s = INFINITY;                   ///< its flight controller does nothing for 9 s
  double end_s = INFINITY, back_s = INFINITY;  ///< its end of the port
  bool obeys = true;
  double depth_m = 0.3;
  std::function<std::string(const std::string&)> change = [](const std::string& body) {
    return body;
  };

 private:
  void start() {
    proglet_ = std::make_unique<simulator::ExtctlProglet>(
        bench_.platform, file_,
        simulator::ExtctlVehicle{
            .value =
                [this](const std::string& name) {
                  const auto found = values.find(name);
                  return found == values.end() ? NAN : found->second;
                },
            .put = [this](const std::string& name, double value) { values[name] = value; }},
        simulator::ExtctlProglet::Settings{.seed = 1, .virtual_time = false});
  }
  void cycle(double now_s) {
    const double heading = values.contains("u_mission_param_a") ? values["u_mission_param_a"] : 0;
    memory_ = {{GLIDER_M_PRESENT_SECS_INTO_MISSION, now_s},
               {GLIDER_M_GPS_MAG_VAR, 0.2},
               {GLIDER_M_LAT, 3910.5 + now_s / 1e4},
               {GLIDER_M_LON, -7346.8},
               {GLIDER_M_DEPTH, depth_m},
               {GLIDER_C_HEADING, obeys ? heading : 0.5},
               {GLIDER_M_PRESENT_TIME, 1.79e9 + now_s}};
  }
  static double get(void* self, uint16_t id, bool* fresh) {
    const auto& vehicle = *static_cast<Vehicle*>(self);
    *fresh = true;
    const auto found = vehicle.memory_.find(id);
    return id == GLIDER_SCI_WATER_TEMP      ? 15 + vehicle.science_s_ / 1000
           : found == vehicle.memory_.end() ? NAN
                                            : found->second;
  }
  /// The program writes nothing that the science computer itself takes.
  static void set(void* /*self*/, uint16_t /*id*/, double /*value*/) {}
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity) {
    auto& vehicle = *static_cast<Vehicle*>(self);
    uint32_t count = 0;
    for (; count < capacity && !vehicle.to_science_.empty(); ++count) {
      bytes[count] = vehicle.to_science_.front();
      vehicle.to_science_.pop_front();
    }
    return static_cast<int32_t>(count);
  }
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count) {
    static_cast<Vehicle*>(self)->from_science_.append(reinterpret_cast<const char*>(bytes), count);
    return static_cast<int32_t>(count);
  }

  const DockBench& bench_;
  ExtctlFile file_;
  std::map<uint16_t, double> memory_;  ///< of the science computer, from the flight controller
  std::deque<uint8_t> to_science_;
  std::string from_science_;
  double science_s_ = -1, flight_s_ = -4;
  bool ended_ = false;
  std::unique_ptr<simulator::ExtctlProglet> proglet_;
};

TEST(DockVehicleItself, ItsMarksCrossBetweenItsComputersLate) {
  DockBench bench;
  Vehicle vehicle(bench, bench.plan.extctl);
  const std::string mark =
      fmt::format("{}:{}.000000", static_cast<uint32_t>(hooks::extctl::PortSensor::Program), 77);
  double reported_s = NAN;
  for (double now_s = 0; now_s < 60; now_s += 0.5) {
    if (now_s == 30) {
      vehicle.values["u_mission_param_l"] = 77;
    }
    const std::string said = vehicle.run(now_s, "");
    reported_s =
        std::isnan(reported_s) && said.find(mark) != std::string::npos ? now_s : reported_s;
  }
  EXPECT_GE(reported_s, 30 + simulator::ExtctlProglet::kLeastDelay);
  EXPECT_LE(reported_s, 31 + simulator::ExtctlProglet::kMostDelay);
}

/// With the sensor that follows a written heading.
struct WithHeading : DockBench {
  WithHeading() { usePlan({GLIDER_M_DEPTH, GLIDER_SCI_WATER_TEMP, GLIDER_C_HEADING}); }
};

TEST(DockVehicle, AllIsGoodForAVehicleThatFliesTheMissionFile) {
  WithHeading bench;
  Vehicle vehicle(bench, bench.plan.extctl);
  const auto result = bench.check(vehicle);
  EXPECT_EQ(result.played, DockPart::Sbc) << "it was found by itself";
  EXPECT_THAT(withVerdict(result, DockVerdict::NotGood), IsEmpty());
  EXPECT_THAT(withVerdict(result, DockVerdict::NotChecked), IsEmpty());
  EXPECT_EQ(result.checks.size(), 10U);
  EXPECT_EQ(vehicle.received, "") << "nothing is written unless it is asked for";
  EXPECT_THAT(checkNamed(result, "cycles").measured, HasSubstr("one each 4 s, none missing"));
  EXPECT_FALSE(result.has_begun);
}

TEST(DockVehicle, CyclesThatAreTooRareForAReadingToStayKnownAreNotGood) {
  WithHeading bench;
  Vehicle vehicle(bench, bench.plan.extctl);
  vehicle.cycle_s = 9;
  const auto result = bench.check(vehicle);
  EXPECT_THAT(withVerdict(result, DockVerdict::NotGood), Contains("cycles"));
  EXPECT_THAT(checkNamed(result, "cycles").measured, HasSubstr("three must fit into the 20 s"));
}

TEST(DockVehicle, ADepthThatIsNoNumberIsNotGood) {
  WithHeading bench;
  Vehicle vehicle(bench, bench.plan.extctl);
  size_t depth = 0;
  while (bench.plan.extctl.sensors().at(depth).name != "m_depth") {
    ++depth;
  }
  const std::string pair = "," + std::to_string(depth) + ":";
  vehicle.change = [pair](const std::string& body) {
    return std::regex_replace(body, std::regex(pair + "[^,]*"), pair + "nan");
  };
  const auto result = bench.check(vehicle);
  EXPECT_THAT(withVerdict(result, DockVerdict::NotGood), Contains("values"));
  EXPECT_THAT(checkNamed(result, "values").measured, HasSubstr("no number: `m_depth`"));
}

TEST(DockVehicle, ASensorThatItsListLacksShiftsAllOthers) {
  WithHeading bench;
  ExtctlFile file = bench.plan.extctl;
  file.reported.erase(file.reported.begin() + 5);  // m_lon
  Vehicle vehicle(bench, file);
  const auto result = bench.check(vehicle);
  EXPECT_EQ(checkNamed(result, "cycles").verdict, DockVerdict::NotGood);
  EXPECT_THAT(checkNamed(result, "cycles").measured, HasSubstr("was reported 0 times"));
  EXPECT_EQ(checkNamed(result, "values").verdict, DockVerdict::NotGood);
  EXPECT_THAT(checkNamed(result, "values").measured,
              AllOf(HasSubstr("`c_heading` (index "), HasSubstr("1790000")));
  EXPECT_THAT(checkNamed(result, "sensors").measured, HasSubstr("silent: `m_present_time`"));
  EXPECT_THAT(checkNamed(result, "cycles").todo, HasSubstr("another extctl.ini"));
}

TEST(DockVehicle, ASensorMoreInItsListIsAnIndexThatTheFolderDoesNotHave) {
  WithHeading bench;
  ExtctlFile file = bench.plan.extctl;
  file.reported.push_back({"m_lat_copy", "nodim"});
  Vehicle vehicle(bench, file);
  vehicle.values["m_lat_copy"] = 1;
  const auto result = bench.check(vehicle);
  EXPECT_EQ(checkNamed(result, "indices").verdict, DockVerdict::NotGood);
  EXPECT_THAT(checkNamed(result, "indices").measured,
              HasSubstr(fmt::format("{}", bench.plan.extctl.sensors().size())));
}

TEST(DockVehicle, SilentSensorsAreNamedAndCountOnlyAfterHello) {
  for (const bool says_hello : {true, false}) {
    WithHeading bench;
    Vehicle vehicle(bench, bench.plan.extctl);
    vehicle.values.erase("x_in_gliderdos");
    vehicle.change = [&](const std::string& body) {
      return body == "HI" && !says_hello ? "" : body;
    };
    const auto result = bench.check(vehicle);
    EXPECT_EQ(checkNamed(result, "sensors").verdict,
              says_hello ? DockVerdict::NotGood : DockVerdict::NotChecked);
    EXPECT_THAT(checkNamed(result, "sensors").measured, HasSubstr("silent: `x_in_gliderdos`"));
  }
}

TEST(DockVehicle, ValuesThatASensorCannotHaveAreNamed) {
  WithHeading bench;
  Vehicle vehicle(bench, bench.plan.extctl);
  vehicle.depth_m = -400;
  EXPECT_THAT(checkNamed(bench.check(vehicle), "values").measured,
              HasSubstr("not possible: `m_depth` (index"));

  const auto sensors = bench.plan.extctl.sensors();
  const auto at = std::ranges::find(sensors, "m_lat", &ExtctlSensor::name) - sensors.begin();
  for (const char* value : {"69696969.0", "3970.5"}) {
    WithHeading again;
    Vehicle third(again, again.plan.extctl);
    third.change = [&](const std::string& body) {
      return body.starts_with("SD") ? body + fmt::format(",{}:{}", at, value) : body;
    };
    EXPECT_EQ(checkNamed(again.check(third), "values").verdict,
              value[0] == '6' ? DockVerdict::Good : DockVerdict::NotGood)
        << value;
  }
}

TEST(DockVehicle, TheMissionFileIsKnownByItsNumber) {
  WithHeading bench;
  Vehicle vehicle(bench, bench.plan.extctl);
  vehicle.values["u_mission_param_l"] = 4711;
  const auto other = bench.check(vehicle);
  EXPECT_EQ(checkNamed(other, "mission-file").verdict, DockVerdict::NotGood);
  EXPECT_THAT(checkNamed(other, "mission-file").measured, HasSubstr("is 4711"));

  WithHeading at_prompt;
  Vehicle waiting(at_prompt, at_prompt.plan.extctl);
  waiting.values["u_mission_param_l"] = 0;
  waiting.values["x_in_gliderdos"] = 1;
  const auto prompt = at_prompt.check(waiting);
  EXPECT_EQ(checkNamed(prompt, "mission-file").verdict, DockVerdict::NotChecked);
  EXPECT_THAT(checkNamed(prompt, "mission-file").todo, HasSubstr("run bench.mi"));
}

TEST(DockVehicle, TheEndOfItsPortIsNoticed) {
  for (const bool returns : {true, false}) {
    WithHeading bench;
    Vehicle vehicle(bench, bench.plan.extctl);
    vehicle.end_s = 60;
    vehicle.back_s = returns ? 75 : INFINITY;
    const auto result = bench.check(vehicle);
    EXPECT_EQ(checkNamed(result, "port-restarts").verdict,
              returns ? DockVerdict::Good : DockVerdict::NotGood);
    EXPECT_THAT(checkNamed(result, "port-restarts").measured,
                AllOf(HasSubstr("closed 1 time ($BY), last at 60."),
                      HasSubstr(returns ? "it reports again" : "nothing after that")));
  }
}

TEST(DockVehicle, MissingCyclesAreNoticed) {
  WithHeading bench;
  Vehicle vehicle(bench, bench.plan.extctl);
  vehicle.pause_s = 61;
  const auto result = bench.check(vehicle);
  EXPECT_THAT(checkNamed(result, "cycles").measured, HasSubstr("; 1 gap before the next"));
  EXPECT_EQ(checkNamed(result, "cycles").verdict, DockVerdict::NotGood);
}

TEST(DockVehicle, WritesOnlyAfterTheUserHasAgreed) {
  for (const bool agrees : {true, false}) {
    WithHeading bench;
    std::string asked;
    bench.confirm = [&](const std::string& text) {
      asked = text;
      return agrees;
    };
    Vehicle vehicle(bench, bench.plan.extctl);
    const auto result = bench.check(vehicle);
    EXPECT_THAT(asked, AllOf(HasSubstr("u_mission_param_a"), HasSubstr("sci_wants_surface"),
                             HasSubstr("/dev/bench"), HasSubstr("Ctrl-C")));
    if (!agrees) {
      EXPECT_EQ(vehicle.received, "");
      EXPECT_EQ(checkNamed(result, "steering").verdict, DockVerdict::NotChecked);
      continue;
    }
    EXPECT_EQ(vehicle.received.find("$MD"), std::string::npos);
    expectOnPage(result);
    EXPECT_EQ(checkNamed(result, "steering").verdict, DockVerdict::Good)
        << checkNamed(result, "steering").measured;
    EXPECT_THAT(checkNamed(result, "steering").measured, HasSubstr("followed 3 times, "));
    EXPECT_EQ(checkNamed(result, "taken-back").verdict, DockVerdict::Good);
    EXPECT_THAT(withVerdict(result, DockVerdict::NotGood), IsEmpty());
  }
}

TEST(DockVehicle, WritesNothingIntoAnotherMission) {
  for (const bool at_prompt : {true, false}) {
    WithHeading bench;
    bench.confirm = [](const std::string&) { return true; };
    Vehicle vehicle(bench, bench.plan.extctl);
    vehicle.values["u_mission_param_l"] = 4711;
    vehicle.values["x_in_gliderdos"] = at_prompt ? 1 : 0;
    const auto result = bench.check(vehicle);
    EXPECT_EQ(vehicle.received.empty(), !at_prompt);
    if (!at_prompt) {
      EXPECT_THAT(checkNamed(result, "steering").measured, HasSubstr("flies another mission file"));
    }
  }
}

/// The newest value of an index in what was written.
double lastWritten(const std::string& text, uint32_t index) {
  const std::string pair = fmt::format(",{}:", index);
  const size_t at = text.rfind(pair);
  return at == std::string::npos ? NAN : std::stod(text.substr(at + pair.size()));
}

TEST(DockVehicle, TakesBackWhatItHasWritten) {
  for (const double stop_s : {1e9, 195.0, 181.0}) {
    WithHeading bench;
    bench.confirm = [](const std::string&) { return true; };
    bench.stop_s = stop_s;
    Vehicle vehicle(bench, bench.plan.extctl);
    const auto result = bench.check(vehicle);
    EXPECT_EQ(result.end, stop_s > 1e6 ? DockEnd::Complete : DockEnd::Interrupted);
    EXPECT_EQ(lastWritten(bench.written, 0), 0) << "the heading";
    EXPECT_EQ(lastWritten(bench.written, 9), 0) << "the count";
    EXPECT_EQ(lastWritten(bench.written, 3), 3);
    EXPECT_EQ(lastWritten(bench.written, 7), 2) << "it stays at the surface";
    EXPECT_EQ(checkNamed(result, "taken-back").verdict, DockVerdict::Good);
    EXPECT_GT(bench.written.find(",0:1.570796"), 0U);
  }
}

TEST(DockVehicle, WhatCouldNotBeTakenBackIsReported) {
  WithHeading bench;
  bench.confirm = [](const std::string&) { return true; };
  bench.unplug_s = 200;
  Vehicle vehicle(bench, bench.plan.extctl);
  const auto result = bench.check(vehicle);
  EXPECT_EQ(result.end, DockEnd::LineGone);
  EXPECT_EQ(checkNamed(result, "taken-back").verdict, DockVerdict::NotGood);
  EXPECT_THAT(checkNamed(result, "taken-back").todo, HasSubstr("put u_mission_param_a 0"));
}

TEST(DockVehicle, AVehicleThatDoesNotObeyIsFound) {
  WithHeading bench;
  bench.confirm = [](const std::string&) { return true; };
  Vehicle vehicle(bench, bench.plan.extctl);
  vehicle.obeys = false;
  const auto result = bench.check(vehicle);
  EXPECT_THAT(withVerdict(result, DockVerdict::NotGood), ElementsAre("steering"));
  EXPECT_THAT(checkNamed(result, "steering").measured, HasSubstr("followed 0 of 3 times"));
}

TEST(DockVehicle, WithoutASensorThatFollowsThePersonLooks) {
  DockBench bench;
  bench.confirm = [](const std::string&) { return true; };
  Vehicle vehicle(bench, bench.plan.extctl);
  const auto result = bench.check(vehicle);
  EXPECT_EQ(checkNamed(result, "steering").verdict, DockVerdict::NotChecked);
  EXPECT_THAT(checkNamed(result, "steering").todo, HasSubstr("report ++ sci_generic_b"));
}

TEST(DockVehicle, AnSbcThereIsNamed) {
  DockBench bench;
  bench.part = DockPart::Sbc;
  Vehicle vehicle(bench, bench.plan.extctl);
  vehicle.change = [](const std::string&) { return "SW,9:1.000000"; };
  EXPECT_THAT(checkNamed(bench.check(vehicle), "other-end").todo, HasSubstr("--as vehicle"));
}

}  // namespace
}  // namespace glider::slocum::testing
