// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/way_up.h"

#include "vehicles/slocum/rules/idle_slots.h"
#include "vehicles/slocum/rules/settings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

namespace glider::slocum::rules {
namespace {

double sum(const std::vector<Part>& parts) {
  return std::accumulate(parts.begin(), parts.end(), 0.0,
                         [](double total, const Part& part) { return total + part.seconds; });
}

/// "start_when 12": its when_secs is the time itself.
std::string waitOf(const Layer& surface) {
  return surface.start_text.substr(0, surface.start_text.find(','));
}

class WayUpSearch {
 public:
  WayUpSearch(std::span<const Layer> layers, const slocum::MissionFile& vehicle,
              const platforms::Platform& platform, double deepest_m)
      : layers_(layers), vehicle_(vehicle), platform_(platform), deepest_m_(deepest_m) {
    std::ranges::copy_if(layers, std::back_inserter(flying_),
                         [](const Layer& layer) { return layer.role == Role::Flies; });
  }

  WayUp run() {
    if (const auto blind = unreadSensor(vehicle_, platform_)) {
      return unproved(*blind);
    }
    const auto anywhere =
        std::ranges::find_if(flying_, [](const Layer& layer) { return !layer.deepest_m; });
    if (anywhere != flying_.end()) {
      return {
          {},
          "",
          fmt::format("{} ({}) may command anything below", anywhere->label(), anywhere->argument),
          anywhere->change,
          anywhere->range};
    }
    std::optional<WayUp> best;
    for (const Layer& layer : layers_) {
      auto way = layer.role == Role::Surfaces ? by(layer) : std::nullopt;
      if (way && (!best || sum(way->parts) < sum(best->parts))) {
        best = std::move(way);
      }
    }
    if (!best) {
      return noWay();
    }
    const IdleSlots idle = idleSlots(layers_, vehicle_);
    return idle.any() ? abortedBefore(idle, *best) : beforeTheAbort(std::move(*best));
  }

 private:
  static WayUp unproved(const Doubt& doubt) {
    return {{}, "", doubt.why, doubt.change, doubt.range};
  }

  [[nodiscard]] bool allEnd() const {
    return std::ranges::all_of(flying_, [](const Layer& layer) { return layer.legs.has_value(); });
  }
  /// What waits at the surface climbs itself.
  static bool climbs(const Layer& flying) { return flying.legs == 0; }
  [[nodiscard]] bool standsAboveAll(const Layer& surface) const {
    return std::ranges::all_of(flying_, [&](const Layer& layer) {
      return layer.number > surface.number || climbs(layer);
    });
  }

  /// What `surface` guarantees; none: nothing.
  [[nodiscard]] std::optional<WayUp> by(const Layer& surface) const {
    if (!standsAboveAll(surface)) {
      return std::nullopt;
    }
    WayUp way;
    way.by = fmt::format("{} ({})", surface.label(), surface.start_text);
    way.range = surface.range;
    if (surface.start == Start::Idle && allEnd()) {
      addFlights(way);
    } else if (surface.start == Start::InTime) {
      way.parts.push_back({waitOf(surface), surface.starts_within_s});
      way.parts.push_back({"1 cycle", platform_.world.tick_gap_s});
      addWaits(way);
    } else {
      return std::nullopt;
    }
    const auto climb = climbParts(platform_, deepest_m_);
    way.parts.insert(way.parts.end(), climb.begin(), climb.end());
    return way;
  }

  /// A stack without commands is aborted.
  [[nodiscard]] WayUp abortedBefore(const IdleSlots& idle, const WayUp& way) const {
    return {{},
            "",
            fmt::format("nothing {} {} until {} starts, and the vehicle aborts{}{}",
                        idle.unsure.empty() ? "commands" : "is sure to command", idle.text(),
                        way.by, idle.unsure.empty() ? "" : ": ", fmt::join(idle.unsure, ", ")),
            fmt::format("write {}a behaviour `surface` with start_when 1",
                        idle.pitch_and_pump ? "" : "a `set_heading` without an end, or "),
            way.range};
  }

  /// All that may be flown before the stack is idle. Each behaviour may be interrupted once by each
  /// other, which then starts its leg again; and it may interrupt the climb of a surface behaviour
  /// below it.
  void addFlights(WayUp& way) const {
    const auto& world = platform_.world;
    for (const Layer& layer : flying_) {
      if (climbs(layer)) {
        continue;
      }
      const double leg_s =
          world.turn_s + deepest_m_ / world.slowest_climb_m_s + layer.stalled_s + world.tick_gap_s;
      const double legs =
          *layer.legs + static_cast<double>(flying_.size() - 1) + (hasSurfaceBelow(layer) ? 1 : 0);
      way.parts.push_back({fmt::format("{}, {:g} leg{} of at most {:.4g} m", layer.label(), legs,
                                       legs == 1 ? "" : "s", deepest_m_),
                           legs * leg_s});
    }
    addWaits(way);
  }
  void addWaits(WayUp& way) const {
    for (const Layer& layer : flying_) {
      if (climbs(layer)) {
        way.parts.push_back({layer.label() + " waits", layer.waits_s});
      }
    }
  }
  [[nodiscard]] bool hasSurfaceBelow(const Layer& flying) const {
    return std::ranges::any_of(layers_, [&](const Layer& layer) {
      return layer.role == Role::Surfaces && layer.number > flying.number;
    });
  }

  /// An abort brings it up too, but it ends the mission: what only that does is not the mission
  /// file's way.
  [[nodiscard]] WayUp beforeTheAbort(WayUp way) const {
    for (const Layer& layer : layers_) {
      const slocum::BehaviourBlock& block = vehicle_.behaviours[layer.number - 1];
      const double overtime = block.name == "abend" ? block.value("overtime") : -1;
      if (slocum::missionParameter(overtime)) {
        return unproved(changesInFlight(block, layer.label(), "overtime"));
      }
      if (overtime >= 0 && sum(way.parts) > overtime) {
        return {{},
                "",
                fmt::format("{} may need {:.0f} s, and abend aborts sooner (overtime {:g})", way.by,
                            sum(way.parts), overtime),
                "give `overtime` a longer time, or let the vehicle surface sooner",
                block.range};
      }
    }
    return way;
  }

  /// Why no behaviour brings the vehicle up, from the most particular reason to the most general.
  [[nodiscard]] WayUp noWay() const {
    for (const Layer& layer : layers_) {
      const bool blocked =
          layer.role == Role::Surfaces && layer.start != Start::Uncertain && !standsAboveAll(layer);
      if (blocked) {
        const auto above = std::ranges::find_if(
            flying_, [&](const Layer& other) { return other.number < layer.number; });
        return {{},
                "",
                fmt::format("{} stands above {} and replaces its commands", above->label(),
                            layer.label()),
                fmt::format("move {} above {}", layer.label(), above->label()),
                above->range};
      }
    }
    const auto endless =
        std::ranges::find_if(flying_, [](const Layer& layer) { return !layer.legs; });
    if (endless != flying_.end()) {
      return {{},
              "",
              fmt::format("{} ({}) flies on without an end", endless->label(), endless->argument),
              endless->change +
                  ", or put a behaviour `surface` with start_when 12 and when_secs above it",
              endless->range};
    }
    return noStart();
  }

  [[nodiscard]] WayUp noStart() const {
    WayUp none;
    none.why_not = "nothing commands pitch and pump, and the vehicle aborts";
    none.change = "write a behaviour `surface` with start_when 1";
    const auto place = [&](const auto& is) {
      const auto found = std::ranges::find_if(layers_, is);
      none.range = found == layers_.end() ? none.range : found->range;
      return found;
    };
    place([](const Layer& layer) { return layer.role == Role::Hookbeh; });
    const auto surface = place([](const Layer& layer) {
      return layer.role == Role::Surfaces && layer.start != Start::Idle;
    });
    if (surface != layers_.end()) {
      none.why_not = fmt::format("{} ({}) does not start when it should: {}", surface->label(),
                                 surface->start_text, none.why_not);
    }
    return none;
  }

  std::span<const Layer> layers_;
  const slocum::MissionFile& vehicle_;
  const platforms::Platform& platform_;
  double deepest_m_;
  std::vector<Layer> flying_;
};

}  // namespace

WayUp wayUp(std::span<const Layer> layers, const slocum::MissionFile& vehicle,
            const platforms::Platform& platform, double deepest_m) {
  return WayUpSearch(layers, vehicle, platform, deepest_m).run();
}

std::vector<Part> climbParts(const platforms::Platform& platform, double from_m) {
  const auto& world = platform.world;
  return {{"turn", world.turn_s},
          {fmt::format("climb from {:.4g} m", from_m), from_m / world.slowest_climb_m_s}};
}

}  // namespace glider::slocum::rules
