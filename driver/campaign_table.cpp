// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/campaign_table.h"

#include "driver/csv.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace glider::driver {

using simulator::FaultKind;
using simulator::LineFault;
using simulator::LineWay;
using simulator::SensorFault;
using simulator::Span;
using simulator::Verdict;

namespace {

/// exited, exited after a hand-back, handed back, violation.
using Counts = std::array<uint64_t, 4>;

size_t columnOf(const Verdict& verdict) {
  switch (verdict.outcome) {
    case Verdict::Outcome::Exited:
      return verdict.hand_backs == 0 ? 0 : 1;
    case Verdict::Outcome::HandedBack:
      return 2;
    case Verdict::Outcome::Violation:
      break;
  }
  return 3;
}

std::string row(const char* name, const Counts& counts) {
  return fmt::format("{:<20}{:>9}{:>9}{:>18}{:>13}{:>11}\n", name,
                     counts[0] + counts[1] + counts[2] + counts[3], counts[0], counts[1], counts[2],
                     counts[3]);
}

const char* nameOf(const Verdict& verdict) {
  constexpr std::array<const char*, 4> kNames = {"exited", "exited after hand-back", "handed back",
                                                 "VIOLATION"};
  return kNames[columnOf(verdict)];
}

std::string timesOf(const Span& span) {
  return fmt::format("from_s = {}\n", span.from_s) +
         (std::isinf(span.to_s) ? "" : fmt::format("to_s = {}\n", span.to_s));
}

std::string lineToToml(const LineFault& fault) {
  constexpr std::array<const char*, 4> kWays = {"to_sbc", "from_sbc", "to_flight", "from_flight"};
  std::string out =
      fmt::format("[[faults.line]]\nline = \"{}\"\n", kWays[static_cast<size_t>(fault.way)]) +
      timesOf(fault.when);
  const auto put = [&](const char* key, double value, double usual) {
    out += value == usual ? "" : fmt::format("{} = {}\n", key, value);
  };
  out += fault.cut ? "cut = true\n" : "";
  put("loss", fault.loss, 0);
  put("flips", fault.flips, 0);
  put("bursts", fault.bursts, 0);
  put("burst_bytes", fault.burst_bytes, LineFault().burst_bytes);
  put("delay_s", fault.delay_s, 0);
  put("doubled", fault.doubled, 0);
  put("heard_at_baud", fault.heard_at_baud, 0);
  return out;
}

/// What is wrong with a sensor, as a scenario file says it.
std::string wrongToToml(const SensorFault& fault) {
  using Kind = SensorFault::Kind;
  switch (fault.kind) {
    case Kind::Frozen:
      return "frozen = true";
    case Kind::Missing:
      return "missing = true";
    case Kind::Drift:
      return fmt::format("drift_per_s = {}", fault.value);
    case Kind::Scale:
      return fmt::format("scale = {}", fault.value);
    case Kind::Jumps:
      return fmt::format("jumps = {}\njumps_share = {}", fault.value, fault.share);
    case Kind::Value:
      break;
  }
  return std::isnan(fault.value) ? "value = nan" : fmt::format("value = {}", fault.value);
}

std::string sensorToToml(const SensorFault& fault) {
  return fmt::format("[[faults.sensor]]\nsensor = \"{}\"\n", fault.name) + timesOf(fault.when) +
         wrongToToml(fault) + "\n";
}

}  // namespace

std::string campaignTable(const CampaignPlan& plan, const CampaignResult& result) {
  std::array<Counts, simulator::kFaultKinds> kinds{};
  Counts all{};
  for (uint64_t i = 0; i < result.verdicts.size(); ++i) {
    const size_t column = columnOf(result.verdicts[i]);
    ++kinds[static_cast<size_t>(flightOf(plan, i).kind)][column];
    ++all[column];
  }
  std::string out = fmt::format("{:<20}{:>9}{:>9}{:>18}{:>13}{:>11}\n", "fault", "flights",
                                "exited", "after hand-back", "handed back", "VIOLATION");
  for (size_t kind = 0; kind < kinds.size(); ++kind) {
    out += row(simulator::nameOf(static_cast<FaultKind>(kind)), kinds[kind]);
  }
  return out + row("all", all);
}

std::string violationLines(const CampaignPlan& plan, const CampaignResult& result) {
  constexpr int kMost = 20;
  std::string out;
  int told = 0;
  for (uint64_t i = 0; i < result.verdicts.size() && told < kMost; ++i) {
    const Verdict& verdict = result.verdicts[i];
    if (verdict.outcome != Verdict::Outcome::Violation) {
      continue;
    }
    ++told;
    const CampaignFlight flight = flightOf(plan, i);
    out +=
        fmt::format("flight {} ({}, {}): at {:.0f} s {}\n", i, plan.missions[flight.mission].file,
                    simulator::nameOf(flight.kind), verdict.violation_s, verdict.violation);
  }
  return out.empty() ? ""
                     : out + "Look at one with the same options and --only NUMBER -o FOLDER.\n";
}

std::string campaignCsv(const CampaignPlan& plan, const CampaignResult& result) {
  std::string out =
      "flight,mission,fault,seed,outcome,hand-backs,instructions,end (s),violation (s),violation\n";
  for (uint64_t i = 0; i < result.verdicts.size(); ++i) {
    const Verdict& verdict = result.verdicts[i];
    const CampaignFlight flight = flightOf(plan, i);
    const bool violated = verdict.outcome == Verdict::Outcome::Violation;
    out += fmt::format(
        "{},{},{},{},{},{},{},{},{},{}\n", i, csvQuoted(plan.missions[flight.mission].file),
        simulator::nameOf(flight.kind), flight.seed, nameOf(verdict), verdict.hand_backs,
        verdict.instructions, verdict.end_s, violated ? fmt::to_string(verdict.violation_s) : "",
        csvQuoted(verdict.violation));
  }
  return out;
}

std::string faultsToToml(const simulator::Faults& faults) {
  std::string out;
  for (const LineFault& fault : faults.lines) {
    out += lineToToml(fault);
  }
  for (const SensorFault& fault : faults.sensors) {
    out += sensorToToml(fault);
  }
  const auto spans = [&](const char* name, const std::vector<Span>& list) {
    for (const Span& span : list) {
      out += fmt::format("[[faults.{}]]\n", name) + timesOf(span);
    }
  };
  spans("power", faults.power);
  spans("port", faults.port);
  spans("stuck", faults.stuck);
  for (const Span& span : faults.science) {
    out += fmt::format("[[faults.science]]\nat_s = {}\ntakes_s = {}\n", span.from_s,
                       span.to_s - span.from_s);
  }
  for (const auto& jump : faults.clock) {
    out += fmt::format("[[faults.clock]]\nat_s = {}\nby_s = {}\n", jump.at_s, jump.by_s);
  }
  for (const double at_s : faults.aborts) {
    out += fmt::format("[[faults.abort]]\nat_s = {}\n", at_s);
  }
  return out;
}

}  // namespace glider::driver
