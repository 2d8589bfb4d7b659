// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/slocum/port_page.h"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>

namespace glider::driver {
namespace {

/// "4 h", "90 min".
std::string timeText(double seconds) {
  constexpr double kHour = 3600, kMinute = 60;
  return seconds >= 2 * kHour ? fmt::format("{:.3g} h", seconds / kHour)
                              : fmt::format("{:.3g} min", seconds / kMinute);
}

std::string whereTable(const slocum::PortPlan& plan, const PortPageFiles& files) {
  return fmt::format(
      "| file | goes to |\n|---|---|\n"
      "| `{}` | the computer in the payload bay (board {}), started at power-up: `{} --port DEVICE "
      "--baud {} --log FILE --checkpoint FILE` |\n"
      "| `{}` | `\\config` of the science computer |\n"
      "| `{}` | its lines go into `proglets.dat` of the science computer; set `uart` to the port "
      "that "
      "is wired |\n"
      "| `{}` | `\\missions` of the flight computer |\n",
      files.program, files.board, std::filesystem::path(files.program).filename().string(),
      plan.extctl.baud, files.sensors, files.proglet, files.vehicle_mission);
}

std::string boundText(const slocum::PortPlan& plan) {
  constexpr double kSlowestClimb = 0.05;  // m/s, as the vehicle's environment model says
  const double climb_s = (plan.choice.greatest_depth_m + plan.overshoot_m) / kSlowestClimb;
  return fmt::format(
      "The vehicle keeps the last depths and heading that it has received, for ever: nothing on it "
      "monitors "
      "the port. What brings it up then is its own `surface` with `start_when` 12: after {} "
      "without "
      "contact it climbs, which takes {} at most from {:.4g} m, and waits for its operator. So "
      "**it is at the "
      "surface {} after its last contact, at the latest**, if its depth sensor and pump work.\n",
      timeText(plan.choice.surface_after_s), timeText(climb_s), plan.choice.greatest_depth_m,
      timeText(plan.choice.surface_after_s + climb_s));
}

}  // namespace

std::string portPage(const slocum::PortPlan& plan, const PortPageFiles& files) {
  return fmt::format(
      "# {0} by the port for a backseat driver\n\n"
      "Written by `glidercc build --dialect extctl`. These files belong together: the program "
      "steers only while the vehicle flies "
      "`{1}.mi`, whose `u_mission_param_l` is {2}.\n\n"
      "## What goes where\n\n{3}\n"
      "## At the dock\n\n"
      "| step | type at the vehicle | see |\n|---|---|---|\n"
      "| the port | `put c_extctl_on 1` | the program's lights, or its log: `the link` |\n"
      "| what arrives | `report ++ sci_generic_b` | a number that counts up every 4 s while the "
      "program answers |\n"
      "| the arguments | `report ++ u_mission_param_d` | the depth to dive to, once the mission "
      "has begun |\n"
      "| go | `run {1}.mi` | the vehicle stays at the surface until the program steers |\n\n"
      "## If the computer in the payload bay fails\n\n{4}",
      plan.mission, plan.file, plan.port.program, whereTable(plan, files), boundText(plan));
}

}  // namespace glider::driver
