// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a mission commands its instruments: rule S8 of ir/README.md.

#include "compiler/compilation.h"
#include "hooks/protocol/sampling.h"
#include "ir/eval/interpreter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace glider::ir {
namespace {

constexpr char kMission[] = R"(mission m
param often : time = 30 s in 4 s .. 1 h
state one
begin
  flightprofile yo(5 m, 40 m)
  sensors missiontime, depth, temp
  sample fluorometer every often on climbs below 10 m, ctd off
  events
    case temp > 20 degC call two
    case missiontime > 100 s goto plain
end
state two
begin
  flightprofile yo(5 m, 40 m)
  sensors statetime
  sample optode, ctd off when depth < 10 m
  events
    case statetime > 8 s return
end
state plain
begin
  flightprofile yo(5 m, 40 m)
  sensors missiontime
  events
    case missiontime > 1 h exit
end
)";

double wordOf(uint32_t ctd, uint32_t fluorometer, uint32_t optode) {
  return ctd + 32.0 * fluorometer + 1024.0 * optode;
}

/// A flight of it.
class SampledFlight {
 public:
  SampledFlight() : mission_(compiled()), interpreter_(mission_, 1) {}

  double start() { return interpreter_.start().sampling; }
  double tick(double time, double depth, double state, double temp = 10) {
    std::vector<SensorUpdate> frame{{sensor("m_depth"), depth}, {sensor("sci_water_temp"), temp}};
    if (!std::isnan(state)) {
      frame.push_back({sensor("m_depth_state"), state});
    }
    return interpreter_.tick(time, frame).sampling;
  }

 private:
  static Mission compiled() {
    setenv("GLIDERCC_SHARE", GLIDER_BINARY_DIR "/share/glidercc", 1);
    const auto built = compiler::compileText("m.mission", kMission);
    EXPECT_TRUE(built && built->checked);
    return built->checked->mission();
  }
  SensorId sensor(const std::string& name) const {
    for (uint32_t i = 0; i < mission_.sensors.size(); ++i) {
      if (mission_.sensors[i].vehicle_name == name) {
        return {i};
      }
    }
    ADD_FAILURE() << name;
    return {0};
  }

  Mission mission_;
  Interpreter interpreter_;
};

constexpr double kDives = 1, kClimbs = 2, kNotTold = std::numeric_limits<double>::quiet_NaN();
const uint32_t kEvery30 = hookSamplingCode(30);
constexpr uint32_t kOff = kHookSamplingOff, kOn = kHookSamplingFastest;

TEST(MissionSampling, FollowsItsConditionOnEachTick) {
  SampledFlight flight;
  EXPECT_EQ(flight.start(), wordOf(kOff, kEvery30, 0)) << "what is not known does not switch off";
  EXPECT_EQ(flight.tick(4, 20, kDives), wordOf(kOff, kOff, 0));
  EXPECT_EQ(flight.tick(8, 20, kClimbs), wordOf(kOff, kEvery30, 0));
  EXPECT_EQ(flight.tick(12, 9, kClimbs), wordOf(kOff, kOff, 0));
}

TEST(MissionSampling, ReadsWhileItsConditionIsUnknown) {
  SampledFlight flight;
  flight.start();
  EXPECT_EQ(flight.tick(4, 20, kDives), wordOf(kOff, kOff, 0));
  EXPECT_EQ(flight.tick(60, 20, kNotTold), wordOf(kOff, kEvery30, 0)) << "m_depth_state is stale";
}

TEST(MissionSampling, IsThatOfTheCurrentState) {
  SampledFlight flight;
  flight.start();
  EXPECT_EQ(flight.tick(4, 20, kDives, 21), wordOf(0, 0, kOn)) << "called";
  EXPECT_EQ(flight.tick(8, 9, kDives), wordOf(kOff, 0, kOn)) << "off when shallow";
  EXPECT_EQ(flight.tick(16, 9, kDives), wordOf(kOff, kOff, 0)) << "returned";
  EXPECT_EQ(flight.tick(104, 9, kDives), 0) << "a state without `sample`";
}

}  // namespace
}  // namespace glider::ir
