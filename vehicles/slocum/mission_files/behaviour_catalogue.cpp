// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/mission_files/behaviour_catalogue.h"

#include "support/check.h"
#include "support/diagnostics/ids/vehicle.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace glider::slocum {

namespace {

struct Row {
  std::string_view behaviour;  ///< empty in an argument's row
  KnownArgument argument;
};

constexpr auto kRows = std::to_array<Row>({
#define BEHAVIOUR(name) {#name, {}},
#define ARGUMENT(name, unit, fallback) {{}, {#name, #unit, fallback}},
#define OTHER(name, unit, fallback) {{}, {#name, #unit, fallback}},
#include "vehicles/slocum/mission_files/behaviours.def"
#undef BEHAVIOUR
#undef ARGUMENT
#undef OTHER
});

struct Catalogue {
  std::vector<KnownArgument> arguments;
  std::vector<KnownBehaviour> behaviours;

  Catalogue() {
    arguments.reserve(kRows.size());  // the spans below stay valid
    for (const Row& row : kRows) {
      if (!row.behaviour.empty()) {
        behaviours.push_back({row.behaviour, {arguments.data() + arguments.size(), 0}});
        continue;
      }
      arguments.push_back(row.argument);
      auto& list = behaviours.back().arguments;
      list = {list.data(), list.size() + 1};
    }
  }
};

/// Number of single-letter changes between two names, for "did you mean".
size_t distance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) {
    row[j] = j;
  }
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = std::exchange(row[0], i);
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, replaced}));
    }
  }
  return row.back();
}

constexpr size_t kLongestName = 64;  // bounds the work on hostile input

/// The argument whose name is nearest to `name`, if it is near.
const KnownArgument* nearest(const KnownBehaviour& known, std::string_view name) {
  constexpr size_t kNear = 3;
  if (name.size() > kLongestName || known.arguments.empty()) {
    return nullptr;
  }
  const auto found = std::ranges::min_element(
      known.arguments, {},
      [&](const KnownArgument& argument) { return distance(argument.name, name); });
  return distance(found->name, name) <= kNear ? &*found : nullptr;
}

/// A b_arg of sensors_in that switches a proglet, of which vehicles have many: c_profile_on.
bool isProgletSwitch(const KnownBehaviour& known, std::string_view name) {
  return known.name == "sensors_in" && name.starts_with("c_") && name.ends_with("_on");
}

/// Whether a set_heading steers to a heading that its file does not give: the vehicle's default is
/// 1000 rad, which only a bank or a fin to its limit can be.
bool lacksHeading(const BehaviourBlock& block) {
  constexpr double kHeading = 1, kRelativeToCurrent = 5;
  if (block.name != "set_heading" || block.find("heading_value") != nullptr) {
    return false;
  }
  const double use = block.value("use_heading");
  return use == kHeading || use == kRelativeToCurrent;
}

}  // namespace

const KnownArgument* KnownBehaviour::find(std::string_view argument) const {
  const auto found = std::ranges::find(arguments, argument, &KnownArgument::name);
  return found == arguments.end() ? nullptr : &*found;
}

std::span<const KnownBehaviour> knownBehaviours() {
  static const Catalogue catalogue;
  return catalogue.behaviours;
}

const KnownBehaviour* findBehaviour(std::string_view name) {
  const auto all = knownBehaviours();
  const auto found = std::ranges::find(all, name, &KnownBehaviour::name);
  return found == all.end() ? nullptr : &*found;
}

bool drivesMotors(std::string_view name) {
  constexpr std::string_view kOthers[] = {"sample",   "sensors_in", "compass_cal",
                                          "comatose", "bconsci",    "badd_b"};
  return findBehaviour(name) != nullptr && std::ranges::find(kOthers, name) == std::end(kOthers);
}

bool isNearlyABehaviour(std::string_view name) {
  constexpr size_t kNear = 2;
  return name.size() <= kLongestName &&
         std::ranges::any_of(knownBehaviours(), [&](const KnownBehaviour& known) {
           return distance(known.name, name) <= kNear;
         });
}

const Setting* BehaviourBlock::find(std::string_view argument) const {
  const auto found = std::ranges::find(arguments, argument, &Setting::name);
  return found == arguments.end() ? nullptr : &*found;
}

double BehaviourBlock::value(std::string_view argument) const {
  if (const Setting* given = find(argument)) {
    return given->value;
  }
  const KnownBehaviour* known = findBehaviour(name);
  const KnownArgument* row = known != nullptr ? known->find(argument) : nullptr;
  CHECK(row != nullptr, "the catalogue lacks a b_arg that the code reads");
  return row->fallback;
}

std::optional<double> raiseOvertime(MissionFile& mission, double seconds) {
  const auto abend = std::ranges::find(mission.behaviours, "abend", &BehaviourBlock::name);
  if (abend == mission.behaviours.end()) {
    return std::nullopt;
  }
  const auto overtime = std::ranges::find(abend->arguments, "overtime", &Setting::name);
  const bool limits = overtime != abend->arguments.end() && overtime->value >= 0 &&
                      overtime->value < seconds;  // below 0 there is no limit
  return limits ? std::optional(std::exchange(overtime->value, seconds)) : std::nullopt;
}

std::optional<double> raiseNapSecs(MissionFile& mission, double seconds) {
  const auto hookbeh = std::ranges::find(mission.behaviours, "hookbeh", &BehaviourBlock::name);
  if (hookbeh == mission.behaviours.end() || hookbeh->value("nap_secs") >= seconds) {
    return std::nullopt;
  }
  const auto given = std::ranges::find(hookbeh->arguments, "nap_secs", &Setting::name);
  if (given != hookbeh->arguments.end()) {
    given->value = seconds;
  } else {
    hookbeh->arguments.push_back({"nap_secs", "s", seconds, {}, {}});
  }
  return seconds;
}

void checkArguments(const BehaviourBlock& block, support::DiagnosticEngine& diagnostics) {
  const KnownBehaviour* known = findBehaviour(block.name);
  if (known == nullptr) {
    return;
  }
  for (const Setting& given : block.arguments) {
    const bool any = given.name == "args_from_file" || isProgletSwitch(*known, given.name);
    if (any || known->find(given.name) != nullptr) {
      continue;
    }
    if (const KnownArgument* meant = nearest(*known, given.name)) {
      diagnostics.report(support::diagnostics::unknownBehaviourArgument, given.name_range,
                         block.name, given.name,
                         "did you mean `" + std::string(meant->name) + "`?");
    } else {
      diagnostics.report(support::diagnostics::argumentWithoutEffect, given.name_range, given.name,
                         block.name, "the simulator does not know it");
    }
  }
  if (lacksHeading(block)) {
    diagnostics.report(support::diagnostics::missingArgument, block.range, block.name,
                       "heading_value", "X");
  }
}

}  // namespace glider::slocum
