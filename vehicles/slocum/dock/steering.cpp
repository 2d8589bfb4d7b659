// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/dock/steering.h"

#include "hooks/extctl/port.h"
#include "vehicles/slocum/dock/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::slocum {
namespace {

using hooks::extctl::PortSensor;
using vehicles::DockCheck;

constexpr double kEast = 1.570796;  // rad from magnetic north
/// The vehicle's own sensor that follows the heading, if the mission reads it.
constexpr const char* kFollower = "c_heading";
/// A value needs up to 8 s from one computer's behaviours to the other's.
constexpr double kTurnSecs = 20;
constexpr double kSurface = 2;

uint32_t at(PortSensor sensor) {
  return static_cast<uint32_t>(sensor);
}

std::string nameOf(const DockSetup& setup, PortSensor sensor) {
  return setup.plan.extctl.sensors()[at(sensor)].name;
}

/// What keeps a vehicle with the mission file of the folder where it is.
std::string restText() {
  return fmt::format(",{}:{:.6f},{}:{:.6f},{}:{:.6f}", at(PortSensor::DiveDepth),
                     hooks::extctl::kFirstDiveDepth, at(PortSensor::ClimbDepth),
                     hooks::extctl::kFirstClimbDepth, at(PortSensor::WantsSurface), kSurface);
}

}  // namespace

std::string Steering::question() const {
  const DockSetup& setup = run_.setup();
  const auto row = [&](PortSensor sensor, const std::string& value) {
    return fmt::format("  {:<18} {}\n", nameOf(setup, sensor), value);
  };
  return fmt::format("To be written to the vehicle on {}, each {:.3g} s for {:.3g} s:\n",
                     run_.host().device, setup.times.cycle_s, setup.times.steer_s) +
         row(PortSensor::Heading,
             fmt::format("0, then {:.2f} rad, and back each {:.0f} s: if a mission flies, the fin "
                         "may move",
                         kEast, kTurnSecs)) +
         row(PortSensor::DiveDepth, fmt::format("{} m", hooks::extctl::kFirstDiveDepth)) +
         row(PortSensor::ClimbDepth, fmt::format("{} m", hooks::extctl::kFirstClimbDepth)) +
         row(PortSensor::WantsSurface, "2: come up, or stay at the surface") +
         row(PortSensor::State, "0") + row(PortSensor::Beat, "1, 2, 3, …") +
         row(PortSensor::Time, "0") +
         fmt::format(
             "At the end, also after Ctrl-C, {} and {} are set to 0; the others stay as "
             "`{}.mi` begins.\n",
             nameOf(setup, PortSensor::Heading), nameOf(setup, PortSensor::Beat), setup.plan.file);
}

void Steering::write(bool east) {
  const double heading = east ? kEast : 0;
  if (heading != wanted_rad_ || turns_ == 0) {
    wanted_rad_ = heading;
    wanted_s_ = run_.now();
    follows_ = false;
    ++turns_;
  }
  run_.line().say(fmt::format("SW,{}:{:.6f}{},{}:0.000000,{}:{}.000000,{}:0.000000",
                              at(PortSensor::Heading), heading, restText(), at(PortSensor::State),
                              at(PortSensor::Beat), ++count_, at(PortSensor::Time)));
}

void Steering::take(const std::string& body) {
  record_.take(body, run_.now());
  constexpr double kSame = 0.001;
  if (!follows_ && std::fabs(record_.value(kFollower) - wanted_rad_) < kSame) {
    follows_ = true;
    delays_s.push_back(run_.now() - wanted_s_);
  }
}

void Steering::steer() {
  const DockTimes& times = run_.setup().times;
  const double begin_s = run_.now();
  const double turn_s = kTurnSecs * times.cycle_s / kCycleSecs;
  for (uint32_t i = 0; run_.now() - begin_s < times.steer_s; ++i) {
    const double since_s = run_.now() - begin_s;
    // East first: 0 is what the mission file begins with.
    write(static_cast<uint32_t>(since_s / turn_s) % 2 == 0);
    run_.host().progress(
        fmt::format("{:.0f} of {:.0f} s, writing to the vehicle", since_s, times.steer_s));
    if (!run_.hearUntil(begin_s + (i + 1) * times.cycle_s,
                        [this](const std::string& body) { take(body); })) {
      break;
    }
  }
  takeBack();
}

/// Nothing is acknowledged: three times, as the program does.
void Steering::takeBack() {
  constexpr int kTimes = 3;
  run_.host().progress("setting back what was written");
  for (int i = 0; i < kTimes && !run_.line().gone(); ++i) {
    run_.line().say(fmt::format("SW,{}:0.000000{},{}:0.000000,{}:0.000000,{}:0.000000",
                                at(PortSensor::Heading), restText(), at(PortSensor::State),
                                at(PortSensor::Beat), at(PortSensor::Time)));
    const double until_s = run_.now() + run_.setup().times.cycle_s / 4;
    while (run_.now() < until_s || !run_.line().isIdle()) {
      for (const std::string& body : run_.line().hear()) {
        record_.take(body, run_.now());
      }
      if (run_.line().gone() || run_.now() > until_s + 2) {
        break;
      }
      constexpr double kPause = 0.002;
      run_.host().sleep(kPause);
    }
  }
  taken_back_ = !run_.line().gone() && run_.line().isIdle();
}

std::vector<DockCheck> Steering::findings() const {
  const DockSetup& setup = run_.setup();
  const std::string what = "follows what is written";
  std::vector<DockCheck> checks;
  if (record_.indexOf(kFollower) == record_.sensors.size()) {
    checks.push_back(notChecked(
        "steering", what, fmt::format("extctl.ini has no `{}`, which would show it", kFollower),
        fmt::format("look at the vehicle: `report ++ {}` has counted to {}",
                    nameOf(setup, PortSensor::Beat), count_)));
  } else if (delays_s.size() == turns_ && turns_ > 0) {
    const auto [least, most] = std::ranges::minmax(delays_s);
    checks.push_back(good("steering", what,
                          fmt::format("`{}` followed {}, {:.1f} to {:.1f} s after it was written",
                                      kFollower, counted(turns_, "time"), least, most)));
  } else {
    checks.push_back(notGood(
        "steering", what,
        fmt::format("`{}` followed {} of {}", kFollower, delays_s.size(), counted(turns_, "time")),
        fmt::format("at the vehicle: does it fly `{}.mi`, and does `report ++ {}` count?",
                    setup.plan.file, nameOf(setup, PortSensor::Beat))));
  }
  checks.push_back(
      taken_back_
          ? good("taken-back", "what was written is taken back", "written three times at the end")
          : notGood(
                "taken-back", "what was written is taken back", "the line went away before",
                fmt::format("at the vehicle type `put {} 0`", nameOf(setup, PortSensor::Heading))));
  return checks;
}

}  // namespace glider::slocum
