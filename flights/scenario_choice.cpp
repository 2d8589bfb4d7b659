// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/scenario_choice.h"

#include "compiler/boards.h"
#include "compiler/share.h"
#include "frontend/spelling.h"
#include "hooks/protocol/nap_times.h"
#include "simulator/family/family.h"
#include "simulator/sensors/provided.h"
#include "simulator/simulator.h"
#include "support/diagnostics/ids/flights.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace glider::flights {
namespace {

constexpr double kHour_s = 3600;

std::filesystem::path bundledScenarios() {
  return compiler::shareDirectory() / "scenarios";
}

}  // namespace

std::vector<std::string> scenarioNames() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(bundledScenarios(), ignored)) {
    if (entry.path().extension() == ".toml") {
      names.push_back(entry.path().stem().string());
    }
  }
  std::ranges::sort(names);
  return names;
}

namespace {

/// The path of a file, or of a scenario that comes with glidercc for a bare name.
support::Result<std::filesystem::path> scenarioPath(const std::string& wanted) {
  if (wanted.ends_with(".toml")) {
    return wanted;
  }
  const auto names = scenarioNames();
  if (std::ranges::find(names, wanted) == names.end()) {
    auto failure = support::fail(support::diagnostics::unknownScenario, wanted,
                                 fmt::to_string(fmt::join(names, ", ")));
    if (const auto near = frontend::closest(wanted, {names.begin(), names.end()}); !near.empty()) {
      failure.error().hint = fmt::format("did you mean `{}`?", near);
    }
    return failure;
  }
  return bundledScenarios() / (wanted + ".toml");
}

}  // namespace

support::Result<simulator::Scenario> chooseScenario(const std::string& wanted,
                                                    const platforms::Platform& platform,
                                                    const support::ShowDiagnostics& show) {
  const auto path = scenarioPath(wanted);
  if (!path) {
    return std::unexpected(path.error());
  }
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  auto scenario =
      simulator::loadScenario(*path, platform, sources, diagnostics, bundledScenarios());
  if (show) {
    show(diagnostics, sources);
  }
  if (scenario && !scenario->vehicle.battery.sbc_W) {
    const auto board = compiler::usualBoard(platform);
    if (!board) {
      return std::unexpected(board.error());
    }
    if (*board && (*board)->power) {
      const platforms::BoardPower& power = *(*board)->power;
      scenario->vehicle.battery.sbc_W = power.running_W;
      if (power.sleep) {
        scenario->vehicle.battery.sbc_asleep_W = power.sleep->asleep_W;
      }
    }
  }
  return scenario;
}

std::vector<std::string> scenariosWith(const platforms::Platform& platform,
                                       std::string_view sensor) {
  std::vector<std::string> names = scenarioNames();
  std::erase_if(names, [&](const std::string& name) {
    const auto scenario = chooseScenario(name, platform);
    return !scenario ||
           std::ranges::any_of(simulator::sensorsNotCarried(*scenario),
                               [&](const auto& missing) { return missing.name == sensor; });
  });
  return names;
}

bool hasBundledSkeleton(const simulator::Scenario& scenario) {
  std::error_code error;
  return std::filesystem::equivalent(scenario.skeleton_path.parent_path(), bundledScenarios(),
                                     error) &&
         !error;
}

namespace {

/// A note if the scenario has batteries of its own that hold another charge, empty otherwise.
std::string carryPack(const ir::Mission& mission, simulator::Scenario& scenario) {
  simulator::BatterySettings& battery = scenario.vehicle.battery;
  constexpr double kJoulesPerKilojoule = 1000;
  constexpr double kSecondsPerHour = 3600;
  constexpr double kSame = 0.02;
  if (!mission.pack) {
    return "";
  }
  const double wanted_C = mission.pack->capacity_C;
  const double wanted_kJ = simulator::energyOfCharge(battery.power, wanted_C) / kJoulesPerKilojoule;
  if (!battery.own_capacity) {
    battery.power.capacity_kj = wanted_kJ;
    return "";
  }
  const double part = battery.power.capacity_kj / wanted_kJ;
  return std::abs(part - 1) <= kSame
             ? ""
             : fmt::format(
                   "the batteries of scenario `{}` hold {:.4g} Ah, those of the mission's "
                   "line `pack` {:.4g} Ah",
                   scenario.name, part * wanted_C / kSecondsPerHour, wanted_C / kSecondsPerHour);
}

/// A note if the mission file that comes with glidercc was changed for it, empty otherwise.
std::string letSleep(const ir::Mission& mission, const platforms::Platform& platform,
                     simulator::Scenario& scenario) {
  const simulator::Family* family = simulator::familyOf(platform);
  if (!mission.nap_s || family == nullptr || family->raise_nap_secs == nullptr ||
      !hasBundledSkeleton(scenario)) {
    return "";
  }
  const auto nap_secs =
      family->raise_nap_secs(scenario.own, std::ceil(*mission.nap_s + int{kHookAroundNapSecs}));
  return nap_secs ? fmt::format(
                        "the bundled {} lets the SBC sleep, with nap_secs {:g}; the vehicle's "
                        "own mission file needs as much",
                        scenario.skeleton_path.filename().string(), *nap_secs)
                  : "";
}

}  // namespace

std::vector<std::string> equipFor(const ir::Mission& mission, const platforms::Platform& platform,
                                  simulator::Scenario& scenario) {
  std::vector<std::string> notes = {carryPack(mission, scenario),
                                    letSleep(mission, platform, scenario)};
  std::erase(notes, "");
  return notes;
}

std::string setDuration(simulator::Scenario& scenario, const platforms::Platform& platform,
                        double duration_s) {
  scenario.duration_s = duration_s;
  const simulator::Family* family = simulator::familyOf(platform);
  if (family == nullptr || !hasBundledSkeleton(scenario)) {
    return "";
  }
  const auto before = family->raise_overtime(scenario.own, duration_s);
  return before ? fmt::format(
                      "overtime of the bundled {0} is raised from {1:g} h to {2:g} h for this "
                      "duration; the vehicle's own mission file needs an overtime as long",
                      scenario.skeleton_path.filename().string(), *before / kHour_s,
                      duration_s / kHour_s)
                : "";
}

support::Result<void> flyVehiclesOwn(const std::filesystem::path& file,
                                     const platforms::Platform& platform,
                                     simulator::Scenario& scenario,
                                     const support::ShowDiagnostics& show) {
  const simulator::Family* family = simulator::familyOf(platform);
  if (family == nullptr) {
    return simulator::checkPlatform(platform);  // which reports that
  }
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  auto loaded = family->load_own(file, sources, diagnostics, scenario.own);
  if (show) {
    show(diagnostics, sources);
  }
  if (loaded) {
    scenario.skeleton_path = file;
  }
  return loaded;
}

}  // namespace glider::flights
