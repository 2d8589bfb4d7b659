// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/port/port_doubts.h"

#include "hooks/extctl/port.h"
#include "vehicles/slocum/mission_files/behaviour_catalogue.h"
#include "vehicles/slocum/port_files/port_plan.h"
#include "vehicles/slocum/rules/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace glider::slocum::rules {
namespace {

using hooks::extctl::PortSensor;

/// The bit of u_mission_mode that commands the surface.
constexpr auto kSurfaceMode = static_cast<double>(kGliderPortModeSurface);

/// A b_arg that reads a mission parameter of the SBC.
struct Read {
  const char* argument;
  PortSensor parameter;
};
constexpr Read kYoReads[] = {{"d_target_depth", PortSensor::DiveDepth},
                             {"d_pitch_value", PortSensor::DivePitch},
                             {"c_target_depth", PortSensor::ClimbDepth},
                             {"c_pitch_value", PortSensor::ClimbPitch}};

/// A b_arg that has this value, or is left out where that is what the vehicle takes.
struct Fixed {
  const char* argument;
  double value;
};
constexpr Fixed kYoHas[] = {
    {"start_when", 2},  {"stop_when", 5},         {"num_half_cycles_to_do", -1},
    {"d_use_bpump", 2}, {"d_use_pitch", 3},       {"c_use_bpump", 2},
    {"c_use_pitch", 3}, {"c_target_altitude", -1}};
constexpr Read kWaypointReads[] = {{"wpt_x", PortSensor::WaypointLongitude},
                                   {"wpt_y", PortSensor::WaypointLatitude}};
constexpr Fixed kWaypointHas[] = {{"start_when", 15},
                                  {"stop_when", 15},
                                  {"when_secs", kGliderPortModeWaypoint},
                                  {"wpt_units", 2},
                                  {"end_action", 2}};
constexpr Fixed kHeadingHas[] = {{"use_heading", 1}, {"start_when", 0}, {"stop_when", 5}};

/// What is in force before the first command: at the surface, and just below it.
constexpr struct {
  PortSensor parameter;
  double value;
} kAtFirst[] = {{PortSensor::DiveDepth, hooks::extctl::kFirstDiveDepth},
                {PortSensor::ClimbDepth, hooks::extctl::kFirstClimbDepth}};

/// A dive that ends at an altitude of more ends where an altimeter first receives an echo, m.
constexpr double kMostAltitude = 100;
/// A `surface` without contact: its start_when, and the end_actions after which the mission goes
/// on.
constexpr double kNoContact = 12;
constexpr std::initializer_list<double> kResumes = {1, 2, 4};

class DoubtSearch {
 public:
  DoubtSearch(const MissionFile& vehicle, const PortFile& port, const platforms::Platform& platform)
      : vehicle_(vehicle), port_(port), platform_(platform) {}

  std::vector<Disturbance> run() {
    yo(vehicle_.behaviours[port_.driven - 1], port_.layers[port_.driven - 1]);
    heading();
    waypoints();
    surfacing();
    timers();
    port();
    atFirst();
    return std::move(found_);
  }

 private:
  void add(const support::SourceRange& range, std::string what) {
    found_.push_back({Disturbance::Kind::Prevents, range, std::move(what),
                      "write it as `glidercc build --dialect extctl` does"});
  }

  [[nodiscard]] static bool reads(const BehaviourBlock& block, const Read& read) {
    return missionParameter(block.value(read.argument)) == static_cast<int>(read.parameter);
  }
  /// Reports an argument that is not as it must be.
  void compare(const BehaviourBlock& block, const Layer& layer, const Fixed& wanted) {
    const double value = block.value(wanted.argument);
    if (value != wanted.value) {
      add(layer.range, fmt::format("{} has {} {:.7g}, not {:.7g}", layer.label(), wanted.argument,
                                   value, wanted.value));
    }
  }

  void compareRead(const BehaviourBlock& block, const Layer& layer, const Read& read) {
    if (!reads(block, read)) {
      add(layer.range,
          fmt::format("{} takes its {} not from the SBC's", layer.label(), read.argument));
    }
  }

  void yo(const BehaviourBlock& block, const Layer& layer) {
    for (const Read& read : kYoReads) {
      compareRead(block, layer, read);
    }
    for (const Fixed& one : kYoHas) {
      compare(block, layer, one);
    }
    for (const auto& [argument, sign] :
         {std::pair{"d_bpump_value", -1.0}, {"c_bpump_value", 1.0}}) {
      if (!(sign * block.value(argument) >= platform_.envelope.pump_cc / 2)) {
        add(layer.range, fmt::format("{} has {} {:.7g}, which is less than half of the pump's way",
                                     layer.label(), argument, block.value(argument)));
      }
    }
    const double altitude = block.value("d_target_altitude");
    const double least = PortChoice{}.least_altitude_m;
    if (!(altitude >= least && altitude <= kMostAltitude)) {
      add(layer.range,
          fmt::format(
              "{} has d_target_altitude {:.7g}, not a height of {:.7g} to {:.7g} m above the "
              "bottom, and nothing else keeps the vehicle off it",
              layer.label(), altitude, least, kMostAltitude));
    }
    // A leg that is over too soon turns the vehicle where the SBC has not commanded it.
    for (const char* argument : {"d_stop_when_stalled_for", "c_stop_when_stalled_for",
                                 "d_stop_when_hover_for", "c_stop_when_hover_for"}) {
      const KnownArgument* known = findBehaviour("yo")->find(argument);
      if (known != nullptr && !(block.value(argument) >= known->fallback)) {
        add(layer.range, fmt::format("{} has {} {:.7g}, less than the usual {:.7g}", layer.label(),
                                     argument, block.value(argument), known->fallback));
      }
    }
  }

  void heading() {
    for (const Layer& layer : port_.layers) {
      const BehaviourBlock& block = vehicle_.behaviours[layer.number - 1];
      if (block.name == "set_heading" && !block.lacks_file &&
          reads(block, {"heading_value", PortSensor::Heading})) {
        for (const Fixed& one : kHeadingHas) {
          compare(block, layer, one);
        }
        return;
      }
    }
    add(port_.layers[port_.driven - 1].range,
        "no `set_heading` takes its heading_value from the SBC's");
  }

  /// One that takes anything from the SBC steers by its waypoint alone.
  void waypoints() {
    for (const Layer& layer : port_.layers) {
      const BehaviourBlock& block = vehicle_.behaviours[layer.number - 1];
      const bool sbcs = std::ranges::any_of(block.arguments, [](const Setting& argument) {
        return missionParameter(argument.value).has_value();
      });
      if (block.name != "goto_wpt" || block.lacks_file || !sbcs) {
        continue;
      }
      for (const Read& read : kWaypointReads) {
        compareRead(block, layer, read);
      }
      for (const Fixed& one : kWaypointHas) {
        compare(block, layer, one);
      }
    }
  }

  /// Each is to come up now and then, and to go on.
  void timers() {
    for (const Layer& layer : port_.layers) {
      const BehaviourBlock& block = vehicle_.behaviours[layer.number - 1];
      if (block.name != "surface" || block.lacks_file || block.value("start_when") != kNoContact) {
        continue;
      }
      const double secs = block.value("when_secs");
      if (!missionParameter(secs) && !(secs >= kLeastSurfaceAfter && secs <= kMostSurfaceAfter)) {
        add(layer.range,
            fmt::format(
                "{} brings the vehicle up when it has had no contact for {:.7g} s (when_secs), "
                "which is not between {:.7g} s and {:.7g} s",
                layer.label(), secs, kLeastSurfaceAfter, kMostSurfaceAfter));
      }
      if (!isOneOf(block.value("end_action"), kResumes)) {
        add(layer.range, fmt::format("{} has end_action {:.7g}, after which the SBC's mission does "
                                     "not go on",
                                     layer.label(), block.value("end_action")));
      }
    }
  }

  /// As vehicles are flown that have no c_extctl_on in `sensors_in`: `sample` of all science
  /// sensors together, or of the port's own type, throughout.
  [[nodiscard]] bool samplesThePort() const {
    constexpr double kAll = 0, kPortType = 90, kThroughout = 15;
    const bool together = settingInForce(vehicle_, "c_science_all_on_enabled").value != 0;
    return std::ranges::any_of(vehicle_.behaviours, [&](const BehaviourBlock& block) {
      const double type = block.name == "sample" ? block.value("sensor_type") : -1;
      return ((type == kAll && together) || type == kPortType) &&
             block.value("state_to_sample") == kThroughout &&
             block.value("intersample_time") >= 0 &&
             block.value("intersample_time") <= platform_.envelope.cycle_s;
    });
  }

  /// The proglet runs by c_extctl_on, which is how often.
  void port() {
    const SettingInForce on = settingInForce(vehicle_, "c_extctl_on");
    const bool given = on.range.valid();
    if (!given && samplesThePort()) {
      return;
    }
    if (!(on.value > 0 && on.value <= platform_.envelope.cycle_s)) {
      add(given ? on.range : port_.layers[port_.driven - 1].range,
          given ? fmt::format("c_extctl_on is {:.7g}, not 1: the vehicle does not read the SBC's "
                              "port in each cycle",
                              on.value)
                : "nothing switches the SBC's port on (c_extctl_on of `sensors_in`)");
    }
  }

  /// Started by sci_wants_surface or, where the vehicle has mission modes, by a bit of them.
  [[nodiscard]] bool isWished(const BehaviourBlock& block) const {
    const double code = block.value("start_when");
    const bool modes = settingOf("u_mission_mode") != nullptr;
    return modes ? code == 15 && block.value("when_secs") == kSurfaceMode : code == 11;
  }
  void surfacing() {
    for (const Layer& layer : port_.layers) {
      const BehaviourBlock& block = vehicle_.behaviours[layer.number - 1];
      if (layer.role != Role::Surfaces || !isWished(block)) {
        continue;
      }
      constexpr double kAtOnce = 2;
      if (block.value("end_action") != kAtOnce) {
        compare(block, layer, {"end_action", kAtOnce});
      } else if (layer.number > port_.driven) {
        add(layer.range, layer.label() + " stands below the `yo` of the SBC, which replaces it");
      }
      return;
    }
    add(port_.layers[port_.driven - 1].range,
        "no `surface` starts when the SBC commands the surface");
  }

  [[nodiscard]] const Setting* settingOf(std::string_view name) const {
    const auto found = std::ranges::find(vehicle_.sensors, name, &Setting::name);
    return found == vehicle_.sensors.end() ? nullptr : &*found;
  }
  void atFirst() {
    for (const auto& [parameter, value] : kAtFirst) {
      const std::string name =
          fmt::format("u_mission_param_{}", static_cast<char>('a' + static_cast<int>(parameter)));
      initial(name, value);
    }
    if (settingOf("u_mission_mode") != nullptr) {
      initial("u_mission_mode", kSurfaceMode);
    } else {
      initial("sci_wants_surface", 2);
    }
  }
  void initial(const std::string& name, double value) {
    const Setting* setting = settingOf(name);
    if (setting == nullptr || setting->value != value) {
      add(setting != nullptr ? setting->value_range : port_.layers[port_.driven - 1].range,
          fmt::format(
              "before the SBC's first command {} is {}, not {:.7g}", name,
              setting != nullptr ? fmt::format("{:.7g}", setting->value) : std::string("not set"),
              value));
    }
  }

  const MissionFile& vehicle_;
  const PortFile& port_;
  const platforms::Platform& platform_;
  std::vector<Disturbance> found_;
};

}  // namespace

std::vector<Disturbance> portDoubts(const MissionFile& vehicle, const PortFile& port,
                                    const platforms::Platform& platform) {
  return DoubtSearch(vehicle, port, platform).run();
}

}  // namespace glider::slocum::rules
