// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// How a vehicle fares over a bottom that its altimeter would detect, if nothing were wrong with it.
// scripts/soak/depths flies all and prints the table.

#include "tests/depths/depth_faults.h"
#include "tests/depths/depth_flight.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace glider::tests {
namespace {

constexpr double kGreatestBottom = 60;  // max_depth, m
constexpr double kBottomHours = 1.5;

/// A shelf on which no target can be reached: its bottom is flat, or rises where the vehicle goes.
struct Shelf {
  const char* name;
  double water_m;
  double slope;  ///< m of depth lost per m of way
  Plan plan;
};
constexpr Shelf kShelves[] = {
    {"yo to 55 m over 45 m", 45, 0, {.top_m = 4, .bottom_m = 55}},
    {"yo to 50 m towards a shore", 60, 0.015, {.top_m = 4, .bottom_m = 50}},
    {"steep yo to 55 m over 30 m", 30, 0, {.top_m = 4, .bottom_m = 55, .pitch_rad = 0.6}}};

Dived flyOver(const Shelf& shelf, simulator::Faults faults) {
  simulator::Scenario scenario = diveScenario(hookbehSkeleton(kGreatestBottom), shelf.water_m);
  scenario.duration_s = kBottomHours * 3600;
  scenario.ocean.bottom.slope = shelf.slope;
  scenario.ocean.bottom.slope_bearing_rad = scenario.vehicle.initial_heading_rad + 3.14159;
  scenario.faults = std::move(faults);
  return flyDive(&shelf.plan, scenario, 1);
}

struct BottomRow {
  int contacts = 0;
  double on_bottom_s = 0, clearance_m = 1e9;
  std::string violation;
  bool differs = false;
};

BottomRow rowOf(const DepthFault& fault, uint64_t times) {
  BottomRow row;
  std::vector<DepthFault> parts = fault.parts();
  for (const Shelf& shelf : kShelves) {
    for (uint64_t k = 0; k < times; ++k) {
      const double from_s = k == 0 ? 0 : 600 + 250.0 * static_cast<double>(k);
      const Dived dived = flyOver(shelf, fault.from(from_s));
      row.contacts = std::max(row.contacts, dived.contacts);
      row.on_bottom_s = std::max(row.on_bottom_s, dived.on_bottom_s);
      row.clearance_m = std::min(row.clearance_m, dived.clearance_m);
      row.violation = row.violation.empty() && !dived.bottom_violation.empty()
                          ? fmt::format("{}: {}", shelf.name, dived.bottom_violation)
                          : row.violation;
      std::erase_if(parts, [&](const DepthFault& part) {
        return flyOver(shelf, part.from(from_s)).fingerprint != dived.fingerprint;
      });
    }
  }
  row.differs = parts.empty();
  return row;
}

/// docs/depths.md names these: a stuck altimeter that sways as fast as the vehicle dives looks like
/// one that receives echoes of the bottom, and a pitch of 86 degrees hides that a dive has stopped.
bool breaksTheBound(const DepthFault& fault) {
  return (fault.name.find("sways") != std::string::npos && fault.name.ends_with("stuck")) ||
         fault.name == "m_altitude missing, m_pitch = 1.5" ||
         fault.name == "m_altitude = 50, m_pitch = 1.5";
}

TEST(BottomDepths, OfAWholeVehicleAreClear) {
  for (const Shelf& shelf : kShelves) {
    const Dived dived = flyOver(shelf, {});
    EXPECT_EQ(dived.contacts, 0) << shelf.name;
    EXPECT_GT(dived.clearance_m, 1) << shelf.name;
    EXPECT_EQ(dived.bottom_violation, "") << shelf.name;
    EXPECT_LT(dived.clearance_m, 5) << shelf.name << ": the bottom does not matter here";
  }
}

TEST(BottomDepths, MeetNoBottomTwiceWhateverTheAltimeterSays) {
  const uint64_t times = wantedNumber("GLIDER_DEPTHS_ALL", 0);
  const bool all = times != 0;
  if (all) {
    fmt::print("| fault | contacts | the longest, s | least clearance, m |\n|---|---|---|---|\n");
  }
  size_t number = 0;
  const char* only = std::getenv("GLIDER_DEPTHS_ONLY");
  for (const DepthFault& fault : altimeterFaults()) {
    if (only != nullptr && fault.name.find(only) == std::string::npos) {
      continue;
    }
    if (!all && number++ % 5 != 0) {  // the suite's share
      continue;
    }
    const BottomRow row = rowOf(fault, all ? times : 2);
    EXPECT_TRUE(row.differs) << fault.name << ": a flight without one of its faults is the same";
    if (!breaksTheBound(fault)) {
      EXPECT_EQ(row.violation, "") << fault.name;
    }
    if (all) {
      fmt::print("| {} | {} | {:.0f} | {:.1f} |{}\n", fault.name, row.contacts, row.on_bottom_s,
                 std::max(0.0, row.clearance_m), row.violation.empty() ? "" : " **violation**");
      std::fflush(stdout);
    }
  }
}

}  // namespace
}  // namespace glider::tests
