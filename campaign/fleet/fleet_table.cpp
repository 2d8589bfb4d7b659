// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/fleet/fleet_table.h"

#include "campaign/campaign_counts.h"
#include "support/counted.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace glider::campaign {
namespace {

/// The numbers of one row of the table.
struct FleetCounts {
  uint64_t flights = 0, exited = 0, violated = 0, received = 0, lost = 0;
  double deepest_m = 0, nearest_m = std::numeric_limits<double>::infinity();

  void add(const FleetVerdict& verdict) {
    ++flights;
    exited += verdict.exited ? 1U : 0U;
    violated += verdict.violations.empty() ? 0U : 1U;
    received += verdict.received;
    lost += verdict.lost;
    deepest_m = std::max(deepest_m, verdict.deepest_m);
    nearest_m = std::min(nearest_m, verdict.nearest_m);
  }
};

constexpr const char* kColumns = "{:<12}{:>9}{:>12}{:>13}{:>14}{:>13}{:>11}\n";

std::string row(const std::string& name, const FleetCounts& counts) {
  if (counts.flights == 0) {
    return "";
  }
  const auto all = static_cast<double>(counts.received + counts.lost);
  const std::string received =
      all == 0 ? "-" : fmt::format("{:.0f} %", 100 * static_cast<double>(counts.received) / all);
  const std::string nearest =
      std::isfinite(counts.nearest_m) ? fmt::format("{:.0f}", counts.nearest_m) : "-";
  return fmt::format(fmt::runtime(kColumns), name, counts.flights, counts.exited, received, nearest,
                     fmt::format("{:.1f}", counts.deepest_m), counts.violated);
}

/// In how many flights a vehicle violated one of its requirements, and the first of them.
struct FleetRequirementCount {
  uint64_t flights = 0, violated = 0, first = 0;
};

FleetRequirementCount countOf(const FleetCampaignPlan& plan, const FleetCampaignResult& result,
                              size_t vehicle, size_t requirement) {
  FleetRequirementCount count;
  eachFlown(plan, result, [&](const FleetCampaignFlight& flight, const FleetVerdict& verdict) {
    ++count.flights;
    if (std::ranges::count(verdict.requirements[vehicle], requirement) != 0) {
      count.first = count.violated == 0 ? flight.number : count.first;
      ++count.violated;
    }
  });
  return count;
}

}  // namespace

std::string fleetTable(const FleetCampaignPlan& plan, const FleetCampaignResult& result) {
  std::array<FleetCounts, kFleetFaults> counts{};
  FleetCounts all;
  eachFlown(plan, result, [&](const FleetCampaignFlight& flight, const FleetVerdict& verdict) {
    counts[static_cast<size_t>(flight.fault)].add(verdict);
    all.add(verdict);
  });
  if (all.flights == 0) {
    return "no flight was flown\n";
  }
  std::string out = fmt::format(fmt::runtime(kColumns), "messages", "flights", "all exited",
                                "received", "nearest (m)", "deepest (m)", "VIOLATION");
  for (size_t fault = 0; fault < counts.size(); ++fault) {
    out += row(nameOf(static_cast<FleetFault>(fault)), counts[fault]);
  }
  return out + row("all", all);
}

std::string fleetRequirementLines(const FleetCampaignPlan& plan,
                                  const FleetCampaignResult& result) {
  std::string out;
  for (size_t vehicle = 0; vehicle < plan.vehicles.size(); ++vehicle) {
    const FleetCampaignVehicle& flown = plan.vehicles[vehicle];
    if (flown.requirements.empty() && !flown.compiled->checked->mission().requirements.empty()) {
      out += fmt::format("{}: its requirements are not checked: its mission needs code in C\n",
                         flown.name);
    }
    for (size_t i = 0; i < flown.requirements.size(); ++i) {
      const FleetRequirementCount count = countOf(plan, result, vehicle, i);
      out +=
          fmt::format("{}: `{}`: {} in {} of {}{}\n", flown.name, flown.requirements[i],
                      i >= flown.assumptions_from ? "broken" : "violated", count.violated,
                      support::counted(count.flights, "flight"),
                      count.violated == 0 ? "" : fmt::format(", first in flight {}", count.first));
    }
  }
  return out.empty() ? out : "\nrequirements and assumptions\n" + out;
}

std::string fleetViolationLines(const FleetCampaignPlan& plan, const FleetCampaignResult& result,
                                const std::string& command) {
  constexpr int kMost = 20;
  std::string out;
  int violated = 0;
  eachFlown(plan, result, [&](const FleetCampaignFlight& flight, const FleetVerdict& verdict) {
    if (verdict.violations.empty() || ++violated > kMost) {
      return;
    }
    const FleetViolation& first = verdict.violations.front();
    out += fmt::format("flight {} ({}): at {:.0f} s {}\n  {} --only {} -o flight{}\n",
                       flight.number, nameOf(flight.fault), first.at_s, first.what, command,
                       flight.number, flight.number);
  });
  return violated > kMost ? out + fmt::format("and {} more violations\n", violated - kMost) : out;
}

}  // namespace glider::campaign
