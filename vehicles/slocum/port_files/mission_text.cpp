// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/extctl/port.h"
#include "vehicles/slocum/port_files/port_plan.h"

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace glider::slocum {
namespace {

using hooks::extctl::PortSensor;

/// A b_arg from here on is not a number but u_mission_param_a, _b, …
constexpr int kFirstParameter = 1'000'000;
constexpr double kNominalPitch = 0.4538;
/// As far as the pump goes: the vehicle clips it.
constexpr int kWholePump = 1000;

/// Before the SBC has written any, all behaviours must be able to fly.
double initialValue(PortSensor parameter) {
  switch (parameter) {
    case PortSensor::DiveDepth:
      return hooks::extctl::kFirstDiveDepth;
    case PortSensor::ClimbDepth:
      return hooks::extctl::kFirstClimbDepth;
    case PortSensor::DivePitch:
      return -kNominalPitch;
    case PortSensor::ClimbPitch:
      return kNominalPitch;
    case PortSensor::Heading:
    case PortSensor::WaypointLongitude:
    case PortSensor::WaypointLatitude:
    case PortSensor::WantsSurface:
    case PortSensor::State:
    case PortSensor::Beat:
    case PortSensor::Time:
    case PortSensor::Program:
    case PortSensor::InGliderDos:
    case PortSensor::Count:
      break;
  }
  return 0;
}

/// The text of a mission file as it grows.
class Text {
 public:
  template <typename... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    text_ += fmt::format(format, std::forward<Arguments>(arguments)...) + "\n";
  }
  void sensor(std::string_view name, std::string_view unit, double value) {
    line("sensor: {}({}) {}", name, unit, value);
  }
  void behaviour(std::string_view name, std::string_view why) {
    line("\n# {}\nbehavior: {}", why, name);
  }
  void argument(std::string_view name, std::string_view unit, double value) {
    line("    b_arg: {}({}) {}", name, unit, value);
  }
  /// An argument that the SBC sets.
  void argument(std::string_view name, std::string_view unit, PortSensor parameter) {
    line("    b_arg: {}({}) {}", name, unit, kFirstParameter + static_cast<int>(parameter));
  }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

void head(const PortPlan& plan, Text& text) {
  text.line(
      "# {0}.mi: flies the mission {1} by the port for a backseat driver (extctl).\n"
      "# Written by glidercc together with the program for the SBC; neither flies "
      "without the other.\n",
      plan.file, plan.mission);
  // Together: where it is 0, `sample` with sensor_type 0 may switch nothing on.
  text.sensor("c_science_all_on_enabled", "bool", 1);
  for (size_t i = 0; i < plan.extctl.parameters.size(); ++i) {
    const ExtctlSensor& parameter = plan.extctl.parameters[i];
    text.sensor(parameter.name, parameter.unit, initialValue(static_cast<PortSensor>(i)));
  }
  text.sensor("u_mission_param_l", "nodim", plan.port.program);
  text.line("# At the surface until the SBC steers.");
  text.sensor("sci_wants_surface", "enum", 2);
  if (plan.choice.release == Release::MissionModes) {
    text.sensor("u_mission_mode", "nodim", kGliderPortModeSurface);
  }
}

void climb(Text& text) {
  text.argument("c_use_bpump", "enum", 2);
  text.argument("c_bpump_value", "X", kWholePump);
  text.argument("c_use_pitch", "enum", 3);
  text.argument("c_pitch_value", "X", kNominalPitch);
}

void guards(const PortPlan& plan, Text& text) {
  text.behaviour("abend", "The vehicle's own limits.");
  text.argument("overdepth", "m", plan.overdepth_m);
  text.argument("overdepth_sample_time", "s", 15);
  text.argument("overtime", "s", -1);
  text.argument("samedepth_for", "s", 1800);
  text.argument("stalled_for", "s", 1800);
  text.behaviour(
      "surface",
      "Without contact for this long it comes up, for any command of the SBC, and waits.");
  text.argument("start_when", "enum", 12);
  text.argument("when_secs", "s", plan.choice.surface_after_s);
  text.argument("end_action", "enum", 1);
  text.argument("gps_wait_time", "s", 300);
  text.argument("keystroke_wait_time", "s", kOperatorWait);
  climb(text);
}

void surfacing(const PortPlan& plan, Text& text) {
  text.behaviour("surface", "The SBC commands the surface.");
  if (plan.choice.release == Release::MissionModes) {
    text.argument("start_when", "enum", 15);
    text.argument("when_secs", "s", kGliderPortModeSurface);
  } else {
    text.argument("start_when", "enum", 11);
  }
  text.argument("end_action", "enum", 2);
  text.argument("gps_wait_time", "s", 300);
  climb(text);
}

void steering(const PortPlan& plan, Text& text) {
  if (plan.choice.release == Release::MissionModes) {
    text.behaviour("goto_wpt", "The waypoint of the SBC, while its bit of u_mission_mode is set.");
    text.argument("start_when", "enum", 15);
    text.argument("stop_when", "enum", 15);
    text.argument("when_secs", "s", kGliderPortModeWaypoint);
    text.argument("wpt_units", "enum", 2);
    text.argument("wpt_x", "X", PortSensor::WaypointLongitude);
    text.argument("wpt_y", "X", PortSensor::WaypointLatitude);
    text.argument("end_action", "enum", 2);
  }
  text.behaviour("set_heading", "The heading of the SBC, from magnetic north.");
  text.argument("use_heading", "bool", 1);
  text.argument("heading_value", "X", PortSensor::Heading);
  text.argument("start_when", "enum", 0);
  text.argument("stop_when", "enum", 5);
}

void gliding(const PortPlan& plan, Text& text) {
  text.behaviour("yo", "Between the two depths of the SBC.");
  text.argument("start_when", "enum", 2);
  text.argument("num_half_cycles_to_do", "nodim", -1);
  text.argument("d_target_depth", "m", PortSensor::DiveDepth);
  text.argument("d_target_altitude", "m", plan.choice.least_altitude_m);
  text.argument("d_use_bpump", "enum", 2);
  text.argument("d_bpump_value", "X", -kWholePump);
  text.argument("d_use_pitch", "enum", 3);
  text.argument("d_pitch_value", "X", PortSensor::DivePitch);
  text.argument("c_target_depth", "m", PortSensor::ClimbDepth);
  text.argument("c_target_altitude", "m", -1);
  text.argument("c_use_bpump", "enum", 2);
  text.argument("c_bpump_value", "X", kWholePump);
  text.argument("c_use_pitch", "enum", 3);
  text.argument("c_pitch_value", "X", PortSensor::ClimbPitch);
  text.argument("end_action", "enum", 2);
}

void sensing(Text& text) {
  text.behaviour("sample", "The science sensors are on throughout.");
  text.argument("sensor_type", "enum", 0);
  text.argument("state_to_sample", "enum", 15);
  text.argument("intersample_time", "s", 0);
  text.behaviour("sensors_in", "The flight sensors in each cycle.");
  text.argument("c_att_time", "s", 0);
  text.argument("c_pressure_time", "s", 0);
  text.argument("c_alt_time", "s", 0);
  text.argument("c_extctl_on", "s", 1);
}

}  // namespace

std::string printPortMission(const PortPlan& plan) {
  Text text;
  head(plan, text);
  guards(plan, text);
  surfacing(plan, text);
  steering(plan, text);
  gliding(plan, text);
  sensing(text);
  return text.take();
}

std::string printProglet(const PortPlan& plan) {
  return fmt::format(
      "# The port of the SBC. Set uart to the one that it is wired to; bit 0: it has its own "
      "power.\n"
      "proglet = extctl\n"
      "    uart       = 6      # {} baud, as extctl.ini says\n"
      "    bit        = 0\n"
      "    start_snsr = c_extctl_on(sec)\n",
      plan.extctl.baud);
}

}  // namespace glider::slocum
