// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/aborts.h"

#include "vehicles/slocum/mission_files/behaviour_catalogue.h"
#include "vehicles/slocum/rules/settings.h"
#include "vehicles/slocum/rules/way_up.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <utility>

namespace glider::slocum::rules {
namespace {

Ending aborted(const std::string& limits, const platforms::Platform& platform, double from_m) {
  return {fmt::format("an abort ({})", limits),
          climbParts(platform, from_m),
          "the vehicle itself",
          "",
          "",
          {}};
}

/// overtime counts for the layers, so it is theirs to tell.
void addParameter(const BehaviourBlock& abend, const Layer& layer, std::string_view limit,
                  const std::string& text, std::vector<Ending>& endings) {
  if (limit != "overtime") {
    const Doubt doubt = changesInFlight(abend, layer.label(), limit);
    endings.push_back(
        {fmt::format("an abort ({})", text), {}, "", doubt.why, doubt.change, layer.range});
  }
}

}  // namespace

void addAborts(const MissionFile& vehicle, std::span<const Layer> layers,
               const platforms::Platform& platform, double deepest_m,
               std::vector<Ending>& endings) {
  const auto abend = std::ranges::find(vehicle.behaviours, "abend", &BehaviourBlock::name);
  if (abend == vehicle.behaviours.end()) {
    return;
  }
  const Layer& layer = layers[static_cast<size_t>(abend - vehicle.behaviours.begin())];
  std::vector<std::string> others;
  for (const KnownArgument& limit : findBehaviour("abend")->arguments) {
    const double value = abend->value(limit.name);
    const bool off = value < 0 || (value == 0 && limit.unit == "bool");
    std::string text = fmt::format("{} {:.7g}", limit.name, value);
    if (missionParameter(value)) {
      addParameter(*abend, layer, limit.name, text, endings);
    } else if (off || limit.name.ends_with("sample_time")) {
      continue;
    } else if (limit.name == "overdepth") {
      endings.push_back(
          aborted(text, platform, std::max(deepest_m, abortsWithin(*abend, platform))));
    } else {
      others.push_back(std::move(text));
    }
  }
  endings.push_back(aborted(fmt::format("{}", fmt::join(others, ", ")), platform, deepest_m));
}

double abortsWithin(const BehaviourBlock& abend, const platforms::Platform& platform) {
  const auto& hull = platform.envelope;
  return std::min(abend.value("overdepth"), hull.greatest_depth_m) + hull.inflection_overshoot_m +
         hull.vertical_rate_m_s *
             std::max(abend.value("overdepth_sample_time"), platform.world.tick_gap_s);
}

}  // namespace glider::slocum::rules
