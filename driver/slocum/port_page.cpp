// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/slocum/port_page.h"

#include "ir/prove/context/duration_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>
#include <string_view>
#include <vector>

namespace glider::driver {
namespace {

/// "4 h", "90 min": never less than it is.
std::string timeText(double seconds) {
  constexpr double kHour = 3600, kMinute = 60, kParts = 100;
  const bool long_time = seconds >= 2 * kHour;
  const double parts = std::ceil(seconds / (long_time ? kHour : kMinute) * kParts - 1e-6);
  return fmt::format("{:.6g} {}", parts / kParts, long_time ? "h" : "min");
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

/// "no contact for 14400 s + turn 120 s + …".
std::string sumText(const slocum::rules::Ending& silence) {
  std::vector<std::string> parts;
  for (const slocum::rules::Part& part : silence.parts) {
    parts.push_back(fmt::format("{} {:.0f} s", part.what, part.seconds));
  }
  return fmt::format("{}", fmt::join(parts, " + "));
}

std::string boundText(const slocum::PortPlan& plan, const slocum::rules::Ending& silence) {
  return fmt::format(
      "The vehicle keeps the last depths and heading that it has received, for ever: nothing on it "
      "monitors the port. What brings it up then is its own `surface` with `start_when` 12, after "
      "{0} without contact. So **it is at the surface {1} after its last contact, at the latest**, "
      "if its depth sensor and pump work: {2}. The depth is the greatest at which its `abend` may "
      "find it (`overdepth` {3:.4g}), for any last command. `glidercc check` on this folder "
      "proves it again, also after you have added behaviours to the mission file.\n\n"
      "There it waits {4} for its operator, goes on between the last depths if none answers, and "
      "comes up again {0} later. End the mission in that call if the computer does not answer: "
      "`report ++ sci_generic_b` no longer counts.\n",
      timeText(plan.choice.surface_after_s), ir::prove::durationOf(silence.seconds()),
      sumText(silence), plan.overdepth_m, timeText(slocum::kOperatorWait));
}

}  // namespace

std::string portPage(const slocum::PortPlan& plan, const PortPageFiles& files,
                     const slocum::rules::Ending& silence) {
  return fmt::format(
      "# {0} by the port for a backseat driver\n\n"
      "Written by `glidercc build --dialect extctl`. These files belong together: the program "
      "steers only while the vehicle flies "
      "`{1}.mi`, whose `u_mission_param_l` is {2}.\n\n"
      "## What goes where\n\n{3}\n"
      "## At the dock\n\n"
      "| step | do | see |\n|---|---|---|\n"
      "| | before they are in one hull, each of the two computers at the other end of a cable: "
      "`glidercc dock FOLDER --port DEVICE` | no line is `NOT GOOD` |\n"
      "| 1 | switch the computer in the payload bay on | the program waits for the vehicle |\n"
      "| 2 | at the vehicle: `put c_extctl_on 1`, `report ++ sci_generic_b` | a number that counts "
      "up every 4 s: the program answers |\n"
      "| 3 | at the vehicle: `run {1}.mi` | it stays at the surface until the program steers |\n"
      "| 4 | at the vehicle: `report ++ sci_generic_a`, `report ++ u_mission_param_d` | the state "
      "of "
      "the mission, from 1; the depth to dive to, m |\n\n"
      "## If the computer in the payload bay fails\n\n{4}",
      plan.mission, plan.file, plan.port.program, whereTable(plan, files),
      boundText(plan, silence));
}

}  // namespace glider::driver
