// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What arrives damaged at the SBC is in the log of its mission.

#include "runtime/core/runtime.h"
#include "tests/unit/runtime/resume_bench.h"

#include <gtest/gtest.h>

#include <regex>

namespace glider::runtime::testing {
namespace {

class DamagedInput : public ResumeBench {
 protected:
  /// The events, each with its number.
  [[nodiscard]] std::vector<std::string> events() const {
    const std::string text = logCsv();
    const std::regex event("damaged input on the line[^\n]*");
    std::vector<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), event), last; at != last; ++at) {
      found.push_back(at->str());
    }
    return found;
  }
  void disturb(int times) {
    for (int i = 0; i < times; ++i) {
      vehicle_.disturb(std::string("\x05\x11\x22\x33\x44\x00", 6));
    }
  }

  VehicleBench vehicle_{{.silence_secs = 24}};
};

TEST_F(DamagedInput, IsLoggedWithItsNumberAtMostOnceAMinute) {
  boot(vehicle_);
  vehicle_.run(40);
  EXPECT_TRUE(events().empty());
  disturb(3);
  vehicle_.run(60);
  ASSERT_EQ(events().size(), 1U);
  EXPECT_EQ(events()[0], "damaged input on the line,3,,");
  disturb(1);
  vehicle_.run(80);
  disturb(1);
  vehicle_.run(90);
  EXPECT_EQ(events().size(), 1U) << "noise does not fill the log";
  vehicle_.run(120);
  ASSERT_EQ(events().size(), 2U);
  EXPECT_EQ(events()[1], "damaged input on the line,2,,");
}

TEST_F(DamagedInput, IsCountedByTheDialectIfThereIsOne) {
  uint32_t damaged = 0;
  boot(vehicle_);
  runtime_->countDamageBy(&damaged);
  disturb(3);
  vehicle_.run(40);
  EXPECT_TRUE(events().empty()) << "frames within the program are whole";
  damaged = 7;
  vehicle_.run(60);
  ASSERT_EQ(events().size(), 1U);
  EXPECT_EQ(events()[0], "damaged input on the line,7,,");
}

}  // namespace
}  // namespace glider::runtime::testing
