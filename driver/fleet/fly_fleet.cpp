// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/fleet/fly_fleet.h"

#include "driver/compile_for_flight.h"
#include "driver/exit_code.h"
#include "driver/fleet/fleet_json.h"
#include "driver/fleet/ready_vehicle.h"
#include "driver/output/flight_files.h"
#include "driver/terminal.h"
#include "flights/fleet/fleet_file.h"
#include "report/fleet/fleet_report.h"
#include "report/text.h"
#include "simulator/fleet/fleet.h"
#include "support/diagnostics/ids/command.h"
#include "support/diagnostics/ids/files.h"
#include "support/diagnostics/ids/flights.h"
#include "support/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>
#include <vector>

namespace glider::driver {
namespace {

namespace fs = std::filesystem;
using support::Result;

/// Flies all that is ready; the vehicles are in the order of `ready`.
Result<simulator::FleetFlight> fly(ReadyFleet& ready) {
  std::vector<simulator::FleetMember> members;
  for (const std::unique_ptr<ReadyVehicle>& vehicle : ready.vehicles) {
    auto member = vehicle->member();
    if (!member) {
      return std::unexpected(member.error());
    }
    members.push_back(std::move(*member));
  }
  ProgressLine line;
  const double most_s = ready.world.duration_s;
  const size_t all = members.size();
  return simulator::simulateFleet(
      ready.world, std::move(members), [&](double now_s, size_t flying) {
        line.show(fmt::format("{} of at most {}, {} of {} vehicles flying",
                              report::clockText(now_s), report::clockText(most_s), flying, all));
      });
}

std::vector<report::FleetPairReport> pairsOf(const simulator::Separations& separations) {
  std::vector<report::FleetPairReport> pairs;
  for (size_t i = 0; i < separations.pairs().size(); ++i) {
    const simulator::PairDistance& pair = separations.pairs()[i];
    pairs.push_back({pair.pair.one,
                     pair.pair.other,
                     pair.least_m,
                     pair.least_at_s,
                     {pair.least_depths_m[0], pair.least_depths_m[1]},
                     separations.series(i)});
  }
  return pairs;
}

/// Reports each pair that came too near; returns how many.
size_t judgeSeparation(const report::FleetReport& fleet) {
  size_t found = 0;
  for (const report::FleetPairReport& pair : fleet.pairs) {
    if (fleet.separation_m && pair.least_m < *fleet.separation_m) {
      ++found;
      reportWarning(support::fail(support::diagnostics::vehiclesTooNear,
                                  report::nearestText(fleet, pair),
                                  fmt::format("{:g}", *fleet.separation_m))
                        .error());
    }
  }
  return found;
}

/// Adds to each trace what its mission says of it, checks the flights and writes their files. One
/// trace is in memory at a time.
Result<size_t> writeVehicles(ReadyFleet& ready, simulator::FleetFlight& flown,
                             const fs::path& folder, report::FleetReport& fleet) {
  size_t problems = 0;
  for (size_t i = 0; i < fleet.vehicles.size(); ++i) {
    support::Trace trace = flown.take(i);
    const std::vector<support::Diagnostic> reported = ready.vehicles[i]->judge(trace);
    report::FleetVehicleReport& vehicle = fleet.vehicles[i];
    report::addFlight(trace, flown.starts[i].east_m, flown.starts[i].north_m, vehicle);
    for (const support::Diagnostic& one : reported) {
      vehicle.problems.push_back(one.message);
    }
    problems += reported.size();
    const fs::path its_folder = folder / vehicle.name;
    if (auto written = writeFlight(trace, its_folder, reported); !written) {
      return std::unexpected(written.error());
    }
    if (auto written = writeFlightSummary(trace, reported,
                                          {"events.csv", "report.html", "trace.csv"}, its_folder);
        !written) {
      return std::unexpected(written.error());
    }
  }
  return problems;
}

struct FleetChart {
  const char* name;
  std::string (*draw)(const report::FleetReport& fleet);
};
constexpr FleetChart kFleetCharts[] = {{"depths", report::drawFleetDepths},
                                       {"distances", report::drawFleetDistances},
                                       {"tracks", report::drawFleetMap}};

Result<void> writePicture(const report::FleetReport& fleet, const FleetPicture& picture,
                          const FlightFolder& folder) {
  if (picture.file.empty()) {
    return {};
  }
  const auto chart = std::ranges::find(kFleetCharts, picture.chart, &FleetChart::name);
  const std::string drawn = chart->draw(fleet);
  return drawn.empty() ? support::fail(support::diagnostics::cannotWrite, picture.file,
                                       "no two vehicles flew at the same time")
                       : support::writeFileAtomically(folder.placeOf(picture.file), drawn);
}

Result<void> writeFleet(const report::FleetReport& fleet, FlightFolder& folder) {
  const std::pair<const char*, std::string> files[] = {
      {"report.html", report::fleetPage(fleet)},
      {"distances.csv", distancesCsv(fleet)},
  };
  for (const auto& [name, text] : files) {
    if (auto written = support::writeFileAtomically(folder.staging() / name, text); !written) {
      return written;
    }
  }
  Json document = fleetJson(fleet);
  document["files"] = folder.names();
  document["files"].push_back(FlightFolder::kSummary);
  if (auto written = support::writeFileAtomically(folder.staging() / FlightFolder::kSummary,
                                                  document.dump(2) + "\n");
      !written) {
    return written;
  }
  return folder.commit();
}

report::FleetReport reportOf(const flights::Fleet& file, const ReadyFleet& ready,
                             const simulator::FleetFlight& flown) {
  report::FleetReport fleet;
  fleet.name = file.name;
  fleet.scenario = ready.world.name;
  fleet.seed = ready.seed;
  fleet.separation_m = file.separation_m;
  fleet.pairs = pairsOf(flown.separations);
  fleet.times_s = flown.separations.times();
  for (size_t i = 0; i < ready.vehicles.size(); ++i) {
    const ReadyVehicle& vehicle = *ready.vehicles[i];
    fleet.vehicles.push_back({vehicle.name(), vehicle.missionFile(), vehicle.platformName(),
                              vehicle.name() + "/report.html"});
  }
  return fleet;
}

}  // namespace

Result<flights::Fleet> fleetFor(const FleetOptions& options) {
  auto fleet = flights::loadFleet(options.file);
  if (!fleet) {
    return fleet;
  }
  fleet->seed = options.seed ? options.seed : fleet->seed;
  fleet->duration_s = options.duration_s ? options.duration_s : fleet->duration_s;
  return fleet;
}

std::vector<std::string> fleetCharts() {
  std::vector<std::string> names;
  for (const FleetChart& chart : kFleetCharts) {
    names.emplace_back(chart.name);
  }
  return names;
}

int reportFleet(const flights::Fleet& fleet, ReadyFleet& ready, simulator::FleetFlight& flown,
                double took_s, FleetOutput& output, Json* document) {
  report::FleetReport report = reportOf(fleet, ready, flown);
  const auto problems = writeVehicles(ready, flown, output.folder.staging(), report);
  if (!problems) {
    return reportFailure(problems.error());
  }
  const size_t near = judgeSeparation(report);
  if (auto drawn = writePicture(report, output.picture, output.folder); !drawn) {
    return reportFailure(drawn.error());
  }
  if (auto written = writeFleet(report, output.folder); !written) {
    return reportFailure(written.error());
  }
  if (document != nullptr) {
    document->update(fleetJson(report));
    (*document)["folder"] = output.target;
  } else if (const auto printed =
                 printSuccess(report::fleetSummary(report) +
                              fmt::format("flown in {:.1f} s; report: {}\n", took_s,
                                          (fs::path(output.target) / "report.html").string()));
             !printed) {
    return reportFailure(printed.error());
  }
  return *problems + near == 0 ? kFine : kMissionHasErrors;
}

int flyFleet(const FleetOptions& options, Json* document) {
  const auto fleet = fleetFor(options);
  if (!fleet) {
    return reportFailure(fleet.error());
  }
  int status = kFine;
  auto ready = readyFleet(*fleet, options.only, status);
  if (!ready) {
    return reportFailure(ready.error());
  }
  if (status != kFine) {
    return status;
  }
  const std::string target = options.output.empty() ? fleet->name + "-flight" : options.output;
  auto folder = FlightFolder::open(target);
  if (!folder) {
    return reportFailure(folder.error());
  }
  FleetOutput output{target, std::move(*folder), options.picture};
  const auto begin = std::chrono::steady_clock::now();
  auto flown = fly(*ready);
  if (!flown) {
    return reportFailure(flown.error());
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  return reportFleet(*fleet, *ready, *flown, took.count(), output, document);
}

}  // namespace glider::driver
