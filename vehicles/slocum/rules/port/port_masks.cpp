// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/port/port_masks.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace glider::slocum::rules {
namespace {

/// start_when.
constexpr double kNever = 5;
/// Of a `surface`: never, sci_wants_surface, no contact, and a bit of u_mission_mode.
constexpr std::initializer_list<double> kQuietStarts = {kNever, 11, 12, 15};

bool steers(const BehaviourBlock& block) {
  return block.name == "set_heading" || block.name == "goto_wpt" || block.name == "goto_list" ||
         (block.name == "nop_cmds" && block.value("nop_heading") != 0);
}

bool neverStarts(const BehaviourBlock& block) {
  return block.name != "nop_cmds" && block.value("start_when") == kNever;
}

/// Its heading or waypoint is the SBC's.
bool isSteeredBySbc(const BehaviourBlock& block) {
  return std::ranges::any_of(block.arguments, [](const Setting& argument) {
    return missionParameter(argument.value).has_value();
  });
}

Disturbance masks(const Layer& layer, const char* what, const char* change) {
  return {Disturbance::Kind::Masks, layer.range,
          fmt::format("{} {}{}", layer.label(), what,
                      layer.start_text.empty() ? "" : fmt::format(" ({})", layer.start_text)),
          change};
}

}  // namespace

std::vector<Disturbance> portMasks(const MissionFile& vehicle, const PortFile& port) {
  std::vector<Disturbance> found;
  size_t lowest = 0;
  for (size_t i = 0; i < vehicle.behaviours.size(); ++i) {
    lowest = isSteeredBySbc(vehicle.behaviours[i]) ? i + 1 : lowest;
  }
  for (const Layer& layer : port.layers) {
    const BehaviourBlock& block = vehicle.behaviours[layer.number - 1];
    if (block.lacks_file || layer.number > lowest) {
      continue;
    }
    if (block.name == "surface" && !isOneOf(block.value("start_when"), kQuietStarts)) {
      found.push_back(masks(layer, "brings the vehicle to the surface while the mission flies",
                            "if this is intended, change nothing; otherwise delete it"));
    } else if (steers(block) && !isSteeredBySbc(block) && !neverStarts(block)) {
      found.push_back(masks(layer, "stands above the heading of the SBC and replaces it",
                            "delete it, or move it below"));
    }
  }
  return found;
}

}  // namespace glider::slocum::rules
