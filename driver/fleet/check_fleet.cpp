// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/fleet/check_fleet.h"

#include "flights/launch_choice.h"
#include "flights/scenario_choice.h"
#include "ir/core/inside.h"
#include "ir/prove/geometry/apart.h"
#include "ir/prove/geometry/area_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::driver {
namespace {

/// How far from the edges of a requirement's geofences control must be given, m.
double marginOf(const ir::prove::Findings& found, size_t requirement) {
  const auto verdict = std::ranges::find(found.requirements, requirement,
                                         &ir::prove::RequirementVerdict::requirement);
  return verdict != found.requirements.end() ? verdict->start_margin_m
                                             : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<std::string> FleetCheck::missions() const {
  std::vector<std::string> missions;
  for (const flights::FleetVehicle& vehicle : fleet_.vehicles) {
    const std::string file = vehicle.mission.string();
    if (std::ranges::find(missions, file) == missions.end()) {
      missions.push_back(file);
    }
  }
  return missions;
}

void FleetCheck::take(const analysis::CheckedFile& checked) {
  Known known;
  if (checked.compilation && checked.compilation->checked && checked.found.ok()) {
    known.checked = checked.compilation->checked;
    const std::vector<ir::Requirement>& required = known.checked->mission().requirements;
    for (size_t i = 0; i < required.size() && i < checked.found.requirements.size(); ++i) {
      const bool stays = std::ranges::any_of(required[i].geofences, &ir::Geofence::keep_in);
      known.tried |= stays;
      if (stays && checked.found.requirements[i].verdict == "proved") {
        known.kept.insert(known.kept.end(), required[i].geofences.begin(),
                          required[i].geofences.end());
        known.start_margin_m = std::max(known.start_margin_m, marginOf(checked.proved, i));
      }
    }
  }
  known_[checked.found.path] = std::move(known);
}

support::Result<void> FleetCheck::settle() {
  for (const flights::FleetVehicle& vehicle : fleet_.vehicles) {
    const Known* known = knownOf(vehicle);
    if (known == nullptr || known->checked == nullptr) {
      continue;
    }
    if (auto values = flights::chooseParameters(known->checked->mission(), {vehicle.settings, ""});
        !values) {
      return std::unexpected(flights::ofVehicle(vehicle, values.error()));
    }
    const auto scenario = flights::chooseScenario(fleet_.scenario, known->checked->platform());
    if (!scenario) {
      return std::unexpected(scenario.error());
    }
    const simulator::GeoPosition start = flights::startOf(vehicle, *scenario);
    starts_[vehicle.name] = {start.latitude_deg, start.longitude_deg};
  }
  return checkTalk(fleet_, talking());
}

std::vector<Talking> FleetCheck::talking() const {
  std::vector<Talking> talking;
  for (const flights::FleetVehicle& vehicle : fleet_.vehicles) {
    const Known* known = knownOf(vehicle);
    if (known != nullptr && known->checked != nullptr) {
      talking.push_back({&vehicle, &known->checked->mission(), &known->checked->platform()});
    }
  }
  return talking;
}

/// How the vehicles take turns; empty if none of them shares anything.
std::string FleetCheck::talkText() const {
  for (const Talking& vehicle : talking()) {
    if (!vehicle.mission->shares.empty()) {
      const uint32_t slots = flights::slotsOf(fleet_);
      const double slot_s = slotOf(*vehicle.platform);
      return fmt::format(
          "they take turns in {} slots of {:g} s, a round every {:g} s; what each "
          "promises holds when no message arrives\n",
          slots, slot_s, slots * slot_s);
    }
  }
  return "";
}

const FleetCheck::Known* FleetCheck::knownOf(const flights::FleetVehicle& vehicle) const {
  const auto found = known_.find(vehicle.mission.string());
  return found != known_.end() ? &found->second : nullptr;
}

/// The proofs of the areas rest on where control is given: near where the fleet file says.
std::string FleetCheck::doubtAboutStart(const flights::FleetVehicle& vehicle,
                                        const Known& known) const {
  const std::string file = vehicle.mission.filename().string();
  const auto found = starts_.find(vehicle.name);
  if (found == starts_.end()) {
    return fmt::format("it is not known where {} starts", vehicle.name);
  }
  const ir::Position& start = found->second;
  const auto assumed = ir::assumedStart(known.checked->mission());
  if (assumed && !ir::isInside(*assumed, start)) {
    return fmt::format("{} does not start where `{}` assumes it", vehicle.name, file);
  }
  for (const ir::Geofence& area : known.kept) {
    const auto inside = ir::prove::AreaMap(area, {start}).clearance(area, {start});
    if (!inside.right_side) {
      return fmt::format("{} starts outside the area in which `{}` stays", vehicle.name, file);
    }
    if (inside.distance_m < known.start_margin_m) {
      return fmt::format("{} starts within {:.0f} m of the edge of its area; {:.0f} m are needed",
                         vehicle.name, std::ceil(inside.distance_m),
                         std::ceil(known.start_margin_m));
    }
  }
  return "";
}

std::string FleetCheck::doubtAbout(const flights::FleetVehicle& vehicle) const {
  const Known* known = knownOf(vehicle);
  const std::string file = vehicle.mission.filename().string();
  if (known == nullptr || known->checked == nullptr) {
    return fmt::format("`{}` has errors", file);
  }
  if (known->kept.empty()) {
    return known->tried ? fmt::format("it is not proved that `{}` stays in its area", file)
                        : fmt::format(
                              "`{}` promises no area: `require always inside(…)`, or `require "
                              "always distance(place) < 2 km`",
                              file);
  }
  return doubtAboutStart(vehicle, *known);
}

PairVerdict FleetCheck::judge(const flights::FleetVehicle& one,
                              const flights::FleetVehicle& other) const {
  PairVerdict verdict{one.name, other.name, 0, false, ""};
  for (const flights::FleetVehicle* vehicle : {&one, &other}) {
    verdict.reason = doubtAbout(*vehicle);
    if (!verdict.reason.empty()) {
      return verdict;
    }
  }
  verdict.apart_m = ir::prove::leastApart(knownOf(one)->kept, knownOf(other)->kept);
  verdict.proved = verdict.apart_m >= *fleet_.separation_m;
  if (!verdict.proved) {
    verdict.reason = verdict.apart_m > 0
                         ? fmt::format("their areas are only {:.0f} m apart", verdict.apart_m)
                         : "their areas overlap";
  }
  return verdict;
}

std::vector<PairVerdict> FleetCheck::pairs() const {
  std::vector<PairVerdict> verdicts;
  for (size_t i = 0; fleet_.separation_m && i < fleet_.vehicles.size(); ++i) {
    for (size_t j = i + 1; j < fleet_.vehicles.size(); ++j) {
      verdicts.push_back(judge(fleet_.vehicles[i], fleet_.vehicles[j]));
    }
  }
  return verdicts;
}

std::string FleetCheck::text() const {
  const std::vector<PairVerdict> all = pairs();
  std::string text;
  constexpr size_t kMostLines = 20;
  size_t open = 0;
  for (const PairVerdict& pair : all) {
    open += pair.proved ? 0 : 1;
    if (pair.proved && all.size() <= kMostLines) {
      text += fmt::format("proved: {} and {} are always {:.0f} m apart or more\n", pair.one,
                          pair.other, pair.apart_m);
    } else if (!pair.proved && open <= kMostLines) {
      text += fmt::format("undecided: {:g} m between {} and {}: {}\n", *fleet_.separation_m,
                          pair.one, pair.other, pair.reason);
    }
  }
  if (!all.empty()) {
    text += "  while their missions are in control, on the premises of the proofs of their areas\n";
  }
  const std::string separation =
      all.empty() ? ""
                  : fmt::format(", separation proved for {} of {} pair{}", all.size() - open,
                                all.size(), all.size() == 1 ? "" : "s");
  return text + talkText() +
         fmt::format("{}: fleet of {} vehicle{}, {} mission{}{}\n", fleet_.file.string(),
                     fleet_.vehicles.size(), fleet_.vehicles.size() == 1 ? "" : "s",
                     missions().size(), missions().size() == 1 ? "" : "s", separation);
}

Json FleetCheck::json() const {
  Json document = {{"file", fleet_.file.string()}};
  document["separation_m"] = fleet_.separation_m ? Json(*fleet_.separation_m) : Json(nullptr);
  document["vehicles"] = Json::array();
  for (const flights::FleetVehicle& vehicle : fleet_.vehicles) {
    document["vehicles"].push_back({{"name", vehicle.name}, {"mission", vehicle.mission.string()}});
  }
  document["pairs"] = Json::array();
  for (const PairVerdict& pair : pairs()) {
    document["pairs"].push_back({{"vehicles", {pair.one, pair.other}},
                                 {"verdict", pair.proved ? "proved" : "undecided"},
                                 {"least_m", pair.apart_m},
                                 {"reason", pair.reason}});
  }
  return document;
}

}  // namespace glider::driver
