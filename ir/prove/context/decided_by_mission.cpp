// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/decided_by_mission.h"

#include "ir/core/ops.h"
#include "ir/prove/context/vehicle_clock.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace glider::ir::prove {
namespace {

/// By the name in the language, or else by the vehicle's.
struct Row {
  std::string_view name;
  Decider decider;
};

constexpr auto kRows = std::to_array<Row>({
    // Clocks and counters: they say how long the mission has lasted.
    {"m_present_time", Decider::Counted},
    {"m_present_secs_into_mission", Decider::Counted},
    {"sci_m_present_time", Decider::Counted},
    {"m_cycle_number", Decider::Counted},
    // Where profiles lead to.
    {"depth", Decider::Commanded},
    {"depthrate", Decider::Commanded},
    {"m_depth_state", Decider::Commanded},
    {"pressure", Decider::Commanded},
    {"scipressure", Decider::Commanded},
    {"pitch", Decider::Commanded},
    // Where routes lead to.
    {"heading", Decider::Commanded},
    {"lat", Decider::Commanded},
    {"lon", Decider::Commanded},
    {"gpslat", Decider::Commanded},
    {"gpslon", Decider::Commanded},
    {"m_x_lmc", Decider::Commanded},
    {"m_y_lmc", Decider::Commanded},
    {"m_dist_to_wpt", Decider::Commanded},
    {"x_dr_state", Decider::Commanded},
    // The motors follow the commands.
    {"m_ballast_pumped", Decider::Commanded},
    {"m_de_oil_vol", Decider::Commanded},
    {"m_battpos", Decider::Commanded},
    {"m_fin", Decider::Commanded},
    // What hookbeh says of the commands. x_hook_guard, x_hook_masked and x_hook_nap_secs are the
    // vehicle's.
    {"x_hook_state", Decider::Commanded},
    {"x_hook_sequence", Decider::Commanded},
    {"x_hook_answer", Decider::Commanded},
    {"x_hook_session", Decider::Commanded},
});

/// The vehicle's prefixes: c_ is commanded, cc_ and dc_c_ are the layered control's, the SBC writes
/// sci_hook_, and the others count dives and climbs.
constexpr auto kPrefixes = std::to_array<Row>({
    {"c_", Decider::Commanded},
    {"cc_", Decider::Commanded},
    {"dc_c_", Decider::Commanded},
    {"sci_hook_", Decider::Commanded},
    {"m_num_", Decider::Counted},
    {"m_tot_num_", Decider::Counted},
});

}  // namespace

Decider deciderOf(const platforms::PlatformSensor& sensor) {
  const auto row = std::ranges::find_if(
      kRows, [&](const Row& one) { return one.name == sensor.alias || one.name == sensor.name; });
  if (row != kRows.end()) {
    return row->decider;
  }
  if (isCalendarClock(&sensor)) {
    return Decider::Counted;
  }
  const auto prefix = std::ranges::find_if(
      kPrefixes, [&](const Row& one) { return sensor.name.starts_with(one.name); });
  return prefix != kPrefixes.end() ? prefix->decider : Decider::Sea;
}

Decider deciderOf(const Mission& mission, const platforms::Platform& platform, const Expr& expr) {
  if (groupOf(expr.op) == OpGroup::Clock) {
    return Decider::Counted;
  }
  if (expr.op == Op::Variable) {
    return Decider::Launched;
  }
  if (expr.op != Op::Sensor) {
    return Decider::Nobody;
  }
  const platforms::PlatformSensor* row = platform.find(mission[expr.sensor].vehicle_name);
  return row != nullptr ? deciderOf(*row) : Decider::Sea;
}

}  // namespace glider::ir::prove
