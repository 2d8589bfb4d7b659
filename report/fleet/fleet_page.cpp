// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/brief/html.h"
#include "report/figures.h"
#include "report/fleet/fleet_report.h"
#include "report/svg/svg_text.h"
#include "report/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::report {
namespace {

constexpr std::string_view kFleetStyle = R"css(<style>
body { font: 15px/1.45 "Helvetica Neue", Helvetica, Arial, "Liberation Sans", "DejaVu Sans", sans-serif; color: #1b2733; background: #ffffff; margin: 0 auto; max-width: 980px; padding: 16px }
h1 { font-size: 24px; margin: 0 }
h2 { font-size: 18px; margin: 24px 0 6px }
.about { color: #566573; margin: 2px 0 12px }
table { border-collapse: collapse; width: 100% }
th { text-align: left; border-bottom: 2px solid #8895a1 }
th, td { padding: 3px 12px 3px 0; vertical-align: top }
td { border-bottom: 1px solid #d5dbe1 }
svg { max-width: 100%; height: auto }
.bad { border: 2px solid #a61b1b; padding: 6px 12px; margin: 8px 0 }
.bad p { margin: 2px 0 }
.colour { display: inline-block; width: 12px; height: 12px; margin-right: 6px }
</style>
)css";

using html::raw;
using html::table;

std::string nameWithColour(const FleetReport& fleet, size_t i) {
  const FleetVehicleReport& vehicle = fleet.vehicles[i];
  return fmt::format("<span class=\"colour\" style=\"background:{}\"></span><a href=\"{}\">{}</a>",
                     vehicleColour(fleet, i), raw(vehicle.page), raw(vehicle.name));
}

std::string outcome(const FleetVehicleReport& vehicle) {
  const size_t count = vehicle.problems.size();
  return count == 0 ? "went well" : fmt::format("{} problem{}", count, count == 1 ? "" : "s");
}

std::string inUnit(double value, const char* unit, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f} {}", value, decimals, unit) : "";
}

/// What the page and the terminal say of a vehicle: mission, vehicle, flown, distance, deepest,
/// energy, outcome.
std::vector<std::string> cellsOf(const FleetVehicleReport& vehicle) {
  const FlightFigures& figures = vehicle.figures;
  constexpr double kKilometre = 1000;
  return {vehicle.mission_file,
          vehicle.platform,
          clockText(figures.duration_s),
          inUnit(figures.distance_m / kKilometre, "km", 1),
          inUnit(figures.deepest_m, "m", 0),
          inUnit(figures.energy.used_Wh, "Wh", 0),
          outcome(vehicle)};
}

const std::vector<std::string> kHeads = {"vehicle", "mission", "kind",   "flown",
                                         "track",   "deepest", "energy", "result"};

std::string vehicleTable(const FleetReport& fleet) {
  std::vector<std::vector<std::string>> rows;
  for (size_t i = 0; i < fleet.vehicles.size(); ++i) {
    std::vector<std::string> row = {nameWithColour(fleet, i)};
    for (const std::string& cell : cellsOf(fleet.vehicles[i])) {
      row.push_back(raw(cell));
    }
    rows.push_back(std::move(row));
  }
  return table(kHeads, rows);
}

const std::vector<std::string> kMessageHeads = {"messages", "sent",   "received",
                                                "lost",     "on air", "modem"};

/// What the modems did: a row for each vehicle that used its own.
std::vector<std::vector<std::string>> messageRows(const FleetReport& fleet) {
  std::vector<std::vector<std::string>> rows;
  for (const FleetVehicleReport& vehicle : fleet.vehicles) {
    if (const auto& modem = vehicle.modem) {
      constexpr double kKilojoule = 1000;
      rows.push_back(
          {vehicle.name, fmt::format("{}", modem->sent), fmt::format("{}", modem->received),
           fmt::format("{}", modem->lost), fmt::format("{:.0f} s", modem->on_air_s),
           fmt::format("{:.1f} kJ",
                       (modem->sent_J + modem->received_J + modem->listen_J) / kKilojoule)});
    }
  }
  return rows;
}

std::string messageTable(const FleetReport& fleet) {
  std::vector<std::vector<std::string>> rows = messageRows(fleet);
  for (std::vector<std::string>& row : rows) {
    row.front() = raw(row.front());
  }
  return rows.empty() ? "" : "<h2>Messages</h2>\n" + table(kMessageHeads, rows);
}

/// A table for the terminal; the first row is its head.
std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows) {
    for (size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], width(plain(row[i])));
    }
  }
  std::string out;
  for (const auto& row : rows) {
    std::string line;
    for (size_t i = 0; i < row.size(); ++i) {
      line += padded(plain(row[i]), widths[i] + 2);
    }
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return out;
}

/// The pairs that flew at the same time, the nearest first.
std::vector<const FleetPairReport*> byDistance(const FleetReport& fleet) {
  std::vector<const FleetPairReport*> pairs;
  for (const FleetPairReport& pair : fleet.pairs) {
    if (std::isfinite(pair.least_m)) {
      pairs.push_back(&pair);
    }
  }
  std::ranges::stable_sort(pairs, {}, [](const FleetPairReport* pair) { return pair->least_m; });
  return pairs;
}

std::string pairTable(const FleetReport& fleet) {
  constexpr size_t kMostRows = 20;
  std::vector<std::vector<std::string>> rows;
  for (const FleetPairReport* pair : byDistance(fleet)) {
    if (rows.size() == kMostRows) {
      break;
    }
    rows.push_back(
        {raw(fleet.vehicles[pair->one].name), raw(fleet.vehicles[pair->other].name),
         inUnit(pair->least_m, "m", 0), clockText(pair->least_at_s),
         fmt::format("{:.0f} and {:.0f} m", pair->least_depths_m[0], pair->least_depths_m[1])});
  }
  return rows.empty() ? "<p>No two vehicles flew at the same time.</p>\n"
                      : table({"vehicle", "and", "least distance", "at", "at depths of"}, rows);
}

void addProblems(SvgText& page, const FleetReport& fleet) {
  for (const FleetVehicleReport& vehicle : fleet.vehicles) {
    if (vehicle.problems.empty()) {
      continue;
    }
    page.add("<div class=\"bad\">\n<p><strong>{}</strong></p>\n", raw(vehicle.name));
    for (const std::string& problem : vehicle.problems) {
      page.add("<p>{}</p>\n", html::words(problem));
    }
    page.add("</div>\n");
  }
  for (const FleetPairReport& pair : fleet.pairs) {
    if (fleet.separation_m && pair.least_m < *fleet.separation_m) {
      page.add("<div class=\"bad\"><p>{}: {:g} m are required.</p></div>\n",
               raw(nearestText(fleet, pair)), *fleet.separation_m);
    }
  }
}

}  // namespace

std::string nearestText(const FleetReport& fleet, const FleetPairReport& pair) {
  return fmt::format("{} and {} were {:.0f} m apart at {}, at depths of {:.0f} and {:.0f} m",
                     fleet.vehicles[pair.one].name, fleet.vehicles[pair.other].name, pair.least_m,
                     clockText(pair.least_at_s), pair.least_depths_m[0], pair.least_depths_m[1]);
}

std::string fleetPage(const FleetReport& fleet) {
  SvgText page;
  page.add("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
  page.add(
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'unsafe-inline'\">\n");
  page.add("<meta name=\"viewport\" content=\"width=device-width\">\n<title>{}: fleet</title>\n",
           raw(fleet.name));
  page.add(kFleetStyle);
  page.add("</head>\n<body>\n<h1>{}</h1>\n", raw(fleet.name));
  page.add("<p class=\"about\">{} vehicle{}, scenario {}, seed {}{}</p>\n", fleet.vehicles.size(),
           fleet.vehicles.size() == 1 ? "" : "s", raw(fleet.scenario), fleet.seed,
           fleet.separation_m ? fmt::format(", {:g} m of separation required", *fleet.separation_m)
                              : "");
  addProblems(page, fleet);
  page.add(vehicleTable(fleet));
  page.add("<h2>Tracks</h2>\n");
  page.add(drawFleetMap(fleet));
  page.add("<h2>Depths</h2>\n");
  page.add(drawFleetDepths(fleet));
  if (fleet.vehicles.size() > 1) {
    page.add("<h2>Distances</h2>\n");
    page.add(drawFleetDistances(fleet));
    page.add(pairTable(fleet));
  }
  page.add("{}", messageTable(fleet));
  page.add("</body>\n</html>\n");
  return page.take();
}

std::string fleetSummary(const FleetReport& fleet) {
  std::vector<std::vector<std::string>> rows = {kHeads};
  for (const FleetVehicleReport& vehicle : fleet.vehicles) {
    std::vector<std::string> row = {vehicle.name};
    std::ranges::move(cellsOf(vehicle), std::back_inserter(row));
    rows.push_back(std::move(row));
  }
  std::string out = aligned(rows);
  std::vector<std::vector<std::string>> messages = messageRows(fleet);
  if (!messages.empty()) {
    messages.insert(messages.begin(), kMessageHeads);
    out += aligned(messages);
  }
  const auto nearest = byDistance(fleet);
  return out + (nearest.empty() ? "" : "nearest: " + nearestText(fleet, *nearest.front()) + "\n");
}

}  // namespace glider::report
