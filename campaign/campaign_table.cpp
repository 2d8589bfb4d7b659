// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/campaign_table.h"

#include "campaign/campaign_counts.h"
#include "support/counted.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace glider::campaign {

using simulator::FaultKind;
using simulator::Manner;
using simulator::Verdict;

namespace {

/// The numbers of one row of the table.
struct Counts {
  std::array<uint64_t, 4> flights{};  ///< exited, exited after a release, released, violation
  double deepest_m = 0;

  void add(const Verdict& verdict, size_t column) {
    ++flights[column];
    deepest_m = std::max(deepest_m, verdict.deepest_m);
  }
  [[nodiscard]] uint64_t all() const { return flights[0] + flights[1] + flights[2] + flights[3]; }
};

size_t columnOf(const Verdict& verdict) {
  switch (verdict.outcome) {
    case Verdict::Outcome::Exited:
      return verdict.releases == 0 ? 0 : 1;
    case Verdict::Outcome::Released:
      return 2;
    case Verdict::Outcome::Violation:
      break;
  }
  return 3;
}

/// Empty for what was not flown.
std::string row(const std::string& name, const Counts& counts) {
  if (counts.all() == 0) {
    return "";
  }
  return fmt::format("{:<24}{:>8}{:>9}{:>18}{:>13}{:>12.1f}{:>11}\n", name, counts.all(),
                     counts.flights[0], counts.flights[1], counts.flights[2], counts.deepest_m,
                     counts.flights[3]);
}

/// Of flights in which the mission never had control, where no fault is the reason for all of them;
/// otherwise empty.
std::string idleLine(uint64_t idle, uint64_t idle_without_fault, uint64_t all) {
  if (idle_without_fault == 0 && 2 * idle <= all) {
    return "";
  }
  return fmt::format(
      "\nin {} of {} the mission was never in control of the vehicle: fly it once "
      "with `glidercc sim`, which reports why\n",
      idle, support::counted(all, "flight"));
}

std::string head(const char* what) {
  return fmt::format("{:<24}{:>8}{:>9}{:>18}{:>13}{:>12}{:>11}\n", what, "flights", "exited",
                     "after release", "released", "deepest (m)", "VIOLATION");
}

}  // namespace

const char* outcomeName(const Verdict& verdict) {
  constexpr std::array<const char*, 4> kNames = {"exited", "exited after release", "released",
                                                 "VIOLATION"};
  return kNames[columnOf(verdict)];
}

std::string campaignTable(const CampaignPlan& plan, const CampaignResult& result) {
  std::array<Counts, simulator::kFaultKinds> kinds{};
  std::array<Counts, simulator::kManners> manners{};
  std::vector<Counts> programs(plan.boards.size() + 1);
  Counts all;
  uint64_t idle = 0, idle_without_fault = 0;
  eachFlown(plan, result, [&](const CampaignFlight& flight, const Verdict& verdict) {
    const size_t column = columnOf(verdict);
    const bool never = verdict.instructions == 0;
    idle += never;
    idle_without_fault += never && flight.kind == FaultKind::None;
    kinds[static_cast<size_t>(flight.kind)].add(verdict, column);
    manners[static_cast<size_t>(flight.manner)].add(verdict, column);
    programs[flight.board ? *flight.board + 1 : 0].add(verdict, column);
    all.add(verdict, column);
  });
  if (all.all() == 0) {
    return "no flight was flown\n";
  }
  std::string out = head("fault");
  for (size_t kind = 0; kind < kinds.size(); ++kind) {
    out += row(simulator::nameOf(static_cast<FaultKind>(kind)), kinds[kind]);
  }
  out += row("all", all) + "\n" + head("when");
  for (size_t manner = 0; manner < manners.size(); ++manner) {
    out += row(simulator::nameOf(static_cast<Manner>(manner)), manners[manner]);
  }
  out += "\n" + head("SBC") + row("in process", programs[0]);
  for (size_t board = 0; board < plan.boards.size(); ++board) {
    out += row(plan.boards[board], programs[board + 1]);
  }
  return out + idleLine(idle, idle_without_fault, all.all());
}

std::string requirementLines(const CampaignPlan& plan, const CampaignResult& result) {
  std::string out;
  for (const RequirementCount& count : requirementCounts(plan, result)) {
    const CampaignMission& flown = plan.missions[count.mission];
    out += fmt::format("{}: `{}`: {} in {} of {}{}\n", flown.file,
                       flown.requirements[count.requirement],
                       flown.isAssumption(count.requirement) ? "broken" : "violated",
                       count.violated, support::counted(count.flights, "flight"),
                       count.first ? fmt::format(", first in flight {}", *count.first) : "");
  }
  return out.empty() ? out : "\nrequirements and assumptions, with these faults\n" + out;
}

std::string violationLines(const CampaignPlan& plan, const CampaignResult& result,
                           const std::string& command) {
  constexpr int kMost = 20;
  std::string out;
  int shown = 0, violations = 0;
  eachFlown(plan, result, [&](const CampaignFlight& flight, const Verdict& verdict) {
    if (verdict.outcome != Verdict::Outcome::Violation || ++violations > kMost) {
      return;
    }
    ++shown;
    out +=
        fmt::format("flight {} ({}, {}, {}): at {:.0f} s {}\n  {} --only {} -o flight{}\n",
                    flight.number, plan.missions[flight.mission].file,
                    simulator::nameOf(flight.kind), simulator::nameOf(flight.manner),
                    verdict.violation_s, verdict.violation, command, flight.number, flight.number);
  });
  return violations > shown ? out + fmt::format("and {} more violations\n", violations - shown)
                            : out;
}

}  // namespace glider::campaign
