// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A vehicle that is brought to the surface before the mission may begin: how long it has lasted is
// in the logs.

#include "runtime/core/runtime.h"
#include "runtime/core/wait_times.h"
#include "runtime/extctl/coming_up.h"
#include "tests/unit/runtime/resume_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <limits>
#include <string>
#include <vector>

namespace glider::runtime::testing {
namespace {

using ::testing::HasSubstr;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// When the wait is reported, s, if its cycles are `step_s` apart.
std::vector<double> reported(WaitTimes& times, double until_s, double step_s) {
  std::vector<double> found;
  for (double now = 0; now <= until_s; now += step_s) {
    if (times.isDue(now)) {
      found.push_back(now);
    }
  }
  return found;
}

TEST(WaitTimes, AreOneAMinuteAndAfterAnHourOneAnHour) {
  WaitTimes times;
  EXPECT_FALSE(times.isDue(kNone));
  const std::vector<double> first = reported(times, 600, 4);
  EXPECT_EQ(first, (std::vector<double>{0, 60, 120, 180, 240, 300, 360, 420, 480, 540, 600}));
  WaitTimes day;
  EXPECT_EQ(reported(day, 86400, 4).size(), 61U + 23U);
  EXPECT_FALSE(day.isDue(kNone));
  EXPECT_EQ(reported(day, 100, 50), (std::vector<double>{0, 100})) << "another wait";
  EXPECT_TRUE(day.isDue(0)) << "the vehicle's next mission";
}

class SurfaceFirst : public ResumeBench {
 protected:
  VehicleBench vehicle_{{.start_secs = 1000, .silence_secs = 24}};
};

TEST_F(SurfaceFirst, IsInTheLogWithItsTimeAndOnceInTheVehicles) {
  double for_s = kNone;
  boot(vehicle_);
  extctl::ComingUp coming_up(&for_s);
  runtime_->afterTick(coming_up.afterTick());
  vehicle_.run(40);
  EXPECT_EQ(logCsv().find("surface commanded"), std::string::npos);
  for (double now = 44; now <= 200; now += 4) {
    for_s = now - 44;
    vehicle_.run(now);
  }
  for (const char* line :
       {"0,event,surface commanded before the mission begins,0,an earlier program may have left "
        "targets,\n",
        "before the mission begins,60,", "before the mission begins,120,"}) {
    EXPECT_THAT(logCsv(), HasSubstr(line));
  }
  EXPECT_EQ(std::ranges::count_if(
                vehicle_.events,
                [](const auto& event) {
                  return std::string_view(event.text).starts_with("the SBC commands the surface");
                }),
            1);
}

}  // namespace
}  // namespace glider::runtime::testing
