// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/port/port_whole.h"

#include "support/check.h"
#include "support/source_manager.h"
#include "vehicles/slocum/mission_files/read.h"
#include "vehicles/slocum/rules/aborts.h"
#include "vehicles/slocum/rules/settings.h"
#include "vehicles/slocum/rules/way_up.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

namespace glider::slocum::rules {
namespace {

constexpr const char* kWays[] = {"`exit`", "silence of the SBC", "a line that fails"};

/// What flies above the SBC's `yo` replaces its commands, also while the SBC steers.
void addMasking(const PortFile& port, std::vector<Ending>& endings) {
  for (const Layer& layer : port.layers) {
    if (layer.number < port.driven && layer.role == Role::Flies && !(layer.deepest_m == 0.0)) {
      endings.push_back(
          {"masking by " + layer.label(),
           {},
           "",
           fmt::format("{} ({}) stands above the `yo` of the SBC and replaces it", layer.label(),
                       layer.argument.empty() ? "it dives" : layer.argument),
           "delete it, or move it below",
           layer.range});
    }
  }
}

}  // namespace

Whole portWhole(const MissionFile& vehicle, const PortFile& port,
                const platforms::Platform& platform) {
  Whole all{port.deepest_m, {}};
  if (const auto setting = doubtfulSetting(vehicle, platform)) {
    all.endings.push_back(
        {"any loss of control", {}, "", setting->why, setting->change, setting->range});
    return all;
  }
  if (std::isinf(port.deepest_m)) {
    all.endings.push_back(
        {"any loss of control",
         {},
         "",
         "a damaged sentence on the line may command any depth, and abend has no "
         "fixed `overdepth` that bounds it",
         "give abend an `overdepth` of at most 10 m below what the vehicle can, and an "
         "`overdepth_sample_time` of 15 s",
         port.layers[port.driven - 1].range});
    return all;
  }
  const WayUp up = wayUp(port.layers, vehicle, platform, port.deepest_m);
  for (const char* after : kWays) {
    all.endings.push_back({after, up.parts, up.by, up.why_not, up.change, up.range});
  }
  addMasking(port, all.endings);
  addAborts(vehicle, port.layers, platform, port.deepest_m, all.endings);
  return all;
}

Whole portWhole(const PortPlan& plan, const platforms::Platform& platform) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const uint32_t file = sources.add(plan.file + ".mi", printPortMission(plan));
  const auto vehicle = readMission(sources, file, diagnostics);
  CHECK(vehicle, "the mission file that is written for the port cannot be read");
  Whole whole = portWhole(*vehicle, portFileOf(*vehicle, platform), platform);
  CHECK(whole.proved(), "the mission file that is written for the port may leave a vehicle below");
  return whole;
}

std::vector<std::string> missingGuards(const VehicleFile& file) {
  return {
      "without hookbeh nothing on the vehicle watches the SBC: until its own surfacing, and again "
      "after it, the vehicle flies on between the last depths that it has received",
      fmt::format("without hookbeh nothing compares the depth with the CTD, or looks whether the "
                  "vehicle answers: {} has overdepth {:.4g} and what else its abend says",
                  file.name, file.aborts.overdepth_m.value_or(0)),
  };
}

}  // namespace glider::slocum::rules
