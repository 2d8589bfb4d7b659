// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/idle_slots.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace glider::slocum::rules {
namespace {

using slocum::BehaviourBlock;

/// The slots that a behaviour commands. Those that fly command pitch and pump together.
struct Slots {
  bool heading = false;
  bool pitch_and_pump = false;
};

/// What waits at the surface climbs, and steers if nothing else does.
bool waitsAtSurface(const Layer& layer) {
  return layer.role == Role::Flies && layer.legs == 0;
}

class Stack {
 public:
  Stack(std::span<const Layer> layers, const slocum::MissionFile& vehicle)
      : layers_(layers), vehicle_(vehicle) {}

  IdleSlots idle() const {
    Slots held;
    std::vector<std::pair<Slots, std::string>> unsure;
    for (const Layer& layer : layers_) {
      const BehaviourBlock& block = blockOf(layer);
      const Slots slots = layer.role == Role::Surfaces ? caught(layer) : commanded(block);
      const std::string doubt = layer.role == Role::Surfaces ? "" : whyUnsure(layer, block);
      if (doubt.empty()) {
        held.heading |= slots.heading;
        held.pitch_and_pump |= slots.pitch_and_pump;
      } else {
        unsure.emplace_back(slots, layer.label() + " has " + doubt);
      }
    }
    IdleSlots idle{!held.heading, !held.pitch_and_pump, {}};
    for (auto& [slots, text] : unsure) {
      if ((slots.heading && idle.heading) || (slots.pitch_and_pump && idle.pitch_and_pump)) {
        idle.unsure.push_back(std::move(text));
      }
    }
    return idle;
  }

 private:
  [[nodiscard]] const BehaviourBlock& blockOf(const Layer& layer) const {
    return vehicle_.behaviours[layer.number - 1];
  }
  [[nodiscard]] bool fliesBelow(const Layer& layer) const {
    return std::ranges::any_of(layers_, [&](const Layer& other) {
      return other.number > layer.number && other.role == Role::Flies && !waitsAtSurface(other);
    });
  }

  /// The slots of which one that is idle below `surface` starts it; it then commands all of them.
  /// Those that stand above it only replace commands.
  [[nodiscard]] Slots caught(const Layer& surface) const {
    const double code = blockOf(surface).value("start_when");
    if (surface.start == Start::Idle) {
      const bool sees_heading = isOneOf(code, {1, 3}) || !fliesBelow(surface);
      return {sees_heading, true};
    }
    // Code 12 does not start while there is contact, however short its time is.
    const bool always =
        surface.start == Start::InTime && isOneOf(code, {0, 6, 9}) && surface.starts_within_s == 0;
    return {always, always};
  }

  [[nodiscard]] static Slots commanded(const BehaviourBlock& block) {
    if (block.lacks_file) {
      return {};
    }
    const bool steers = block.name == "set_heading" || block.name == "goto_wpt" ||
                        block.name == "goto_list" ||
                        (block.name == "nop_cmds" && block.value("nop_heading") != 0);
    const bool flies = block.name == "yo" || block.name == "dive_to" || block.name == "climb_to" ||
                       block.name == "drift_at_depth";
    return {steers, flies};
  }

  /// The b_arg for which `block` may command nothing in some cycle: it perhaps does not start, or
  /// ends, if only until its next start. Empty: it commands its slots, or what is below it does.
  [[nodiscard]] std::string whyUnsure(const Layer& layer, const BehaviourBlock& block) const {
    const auto has = [&](const char* argument) {
      return fmt::format("{} {:.7g}", argument, block.value(argument));
    };
    const Slots slots = commanded(block);
    if (!slots.heading && !slots.pitch_and_pump) {
      return "";
    }
    if (block.name == "nop_cmds") {
      return block.value("secs_to_run") < 0 ? "" : has("secs_to_run");
    }
    if (!startsForCertain(layer, block, slots)) {
      return has("start_when");
    }
    if (block.name == "goto_list") {
      const bool some = !block.waypoints.empty() || block.value("num_waypoints") >= 1;
      const bool endless = block.value("num_legs_to_run") == -1;
      return !some ? has("num_waypoints") : endless ? "" : has("num_legs_to_run");
    }
    if (block.name == "dive_to" || block.name == "climb_to") {
      return has("target_depth");
    }
    if (block.name == "drift_at_depth") {
      return has("stop_when_hover_for");
    }
    constexpr double kNever = 5;
    if (block.value("stop_when") != kNever) {
      return has("stop_when");
    }
    const bool ends = block.name == "yo" && !(block.value("num_half_cycles_to_do") < 0);
    return ends ? has("num_half_cycles_to_do") : "";
  }

  /// At the latest as soon as a slot of its own has no command from below.
  [[nodiscard]] bool startsForCertain(const Layer& layer, const BehaviourBlock& block,
                                      Slots slots) const {
    const double code = block.value("start_when");
    return isOneOf(code, {0, 1}) || (slots.heading && code == 3) ||
           (isOneOf(code, {2, 4}) && (slots.pitch_and_pump || !fliesBelow(layer)));
  }

  std::span<const Layer> layers_;
  const slocum::MissionFile& vehicle_;
};

}  // namespace

std::string IdleSlots::text() const {
  return heading && pitch_and_pump ? "heading, pitch and pump"
         : heading                 ? "heading"
                                   : "pitch and pump";
}

IdleSlots idleSlots(std::span<const Layer> layers, const slocum::MissionFile& vehicle) {
  return Stack(layers, vehicle).idle();
}

}  // namespace glider::slocum::rules
