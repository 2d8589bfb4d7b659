// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/run.h"
#include "compiler/boards.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/energy/energy_bound.h"
#include "simulator/vehicle/battery.h"
#include "support/grouped.h"
#include "support/listed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace glider::analysis::check {
namespace {

using ir::prove::EnergyBound;
using ir::prove::StateBound;

/// What the batteries hold when they are full, J: those that the mission names, or the vehicle's.
double packOf(const ir::Mission& mission, const platforms::Power& power) {
  constexpr double kJoulesPerKilojoule = 1000;
  return mission.pack ? simulator::energyOfCharge(power, mission.pack->capacity_C)
                      : power.capacity_kj * kJoulesPerKilojoule;
}

/// "SBC 41 %, pump 30 %, others 2 %".
std::string sharesOf(const EnergyBound& bound) {
  double sum = 0, rest = 100;
  for (const auto& [device, joules] : bound.devices) {
    sum += joules;
  }
  constexpr size_t kNamed = 5;
  std::string text;
  for (size_t i = 0; i < std::min(kNamed, bound.devices.size()); ++i) {
    const double percent = std::round(bound.devices[i].joules / sum * 100);
    rest -= percent;
    text += fmt::format("{}{} {:.0f} %", i == 0 ? "" : ", ", bound.devices[i].device, percent);
  }
  return bound.devices.size() > kNamed && rest >= 1 ? fmt::format("{}, others {:.0f} %", text, rest)
                                                    : text;
}

/// "4.9 days", "11 h": no longer than it is.
std::string wholeOf(double seconds) {
  constexpr double kHour_s = 3600, kDay_s = 86400, kTenths = 10;
  return seconds < 2 * kDay_s
             ? fmt::format("{:.0f} h", std::floor(std::max(seconds, 0.0) / kHour_s))
             : fmt::format("{:.1f} days", std::floor(seconds / kDay_s * kTenths) / kTenths);
}

/// " (168 Ah at 12.1 V on average, as the voltage falls from 14.4 V to 10 V; the reserve is a part
/// of it)": why the pack that a mission names gives less than its name says. Empty: it names none.
std::string whyOf(const ir::Mission& mission, const platforms::Power& power) {
  constexpr double kCoulombsPerAmpereHour = 3600;
  if (!mission.pack) {
    return "";
  }
  return fmt::format(
      " ({:.6g} Ah at {:.3g} V on average, as the voltage falls from {:.3g} V to "
      "{:.3g} V{})",
      mission.pack->capacity_C / kCoulombsPerAmpereHour,
      packOf(mission, power) / mission.pack->capacity_C, power.full_V, power.empty_V,
      mission.pack->reserve > 0 ? "; the reserve is a part of it" : "");
}

std::string boundLine(const EnergyBound& bound, double pack_j, const std::string& why) {
  const std::string pack =
      support::grouped(static_cast<uint64_t>(std::lround(pack_j / simulator::kJoulesPerWattHour)));
  if (!bound.joules) {
    return fmt::format(
        "by the vehicle's power table the mission takes at most {} W on average "
        "in a long flight, so a pack that gives {} Wh{} lasts at least {}: {}",
        support::atMost(bound.watts), pack, why, wholeOf((pack_j - bound.start_j) / bound.watts),
        sharesOf(bound));
  }
  const double share = *bound.joules / pack_j * 100;
  const std::string percent =
      share < 10 ? fmt::format("{:.2g}", share) : fmt::format("{:.0f}", std::floor(share));
  const std::string of_pack =
      share < 100 ? fmt::format("{} % of the {} Wh that the pack gives{}", percent, pack, why)
                  : fmt::format("more than the {} Wh that the pack gives{}", pack, why);
  return fmt::format(
      "by the vehicle's power table the mission takes at most {} Wh until it ends, {}: "
      "{}",
      support::atMost(*bound.joules / simulator::kJoulesPerWattHour), of_pack, sharesOf(bound));
}

/// What it takes at least; empty: nothing is known that is worth a line.
std::string leastLine(const EnergyBound& bound, const std::string& board) {
  constexpr double kWorthMinutes_s = 600;
  if (!bound.earliest_s || *bound.earliest_s < kWorthMinutes_s) {
    return "";
  }
  return fmt::format(
      "and at least {} Wh{} if it comes to an `exit` without a power cut, {} after the start or "
      "later",
      support::atLeast(bound.least_j / simulator::kJoulesPerWattHour),
      board.empty() ? "" : " with the board " + board, ir::prove::durationOf(*bound.earliest_s));
}

/// The seas that the bound is for.
std::string seaLine(const EnergyBound& bound) {
  return fmt::format(
      "all this for water at least {:.0f} m deep, where no guard ends a dive early, "
      "that moves up or down by at most {} m/s, "
      "and for a swell of at most {} m of amplitude and {} s",
      std::ceil(bound.deepest_m + platforms::kBelowDives_m), platforms::kWaterMoves_m_s,
      platforms::kSwell_m, platforms::kSwell_s);
}

/// "at most 9.6 W in `home`, 7.9 W in `out`", the greatest first; empty: there is one state.
std::string statesLine(std::vector<StateBound> states, const ir::Mission& mission) {
  if (states.size() < 2) {
    return "";
  }
  std::ranges::stable_sort(states, std::ranges::greater(), &StateBound::watts);
  constexpr size_t kNamed = 6;
  std::string text;
  for (size_t i = 0; i < std::min(kNamed, states.size()); ++i) {
    text += fmt::format("{}{} W in `{}`", i == 0 ? "" : ", ", support::atMost(states[i].watts),
                        mission[states[i].state].name);
  }
  return fmt::format("during a long stay, on average at most {}{}", text,
                     states.size() > kNamed ? ", less in the others" : "");
}

/// The states whose pump is counted in full.
std::string turnsLine(const std::vector<StateBound>& states, const ir::Mission& mission) {
  std::vector<std::string> names;
  for (const StateBound& one : states) {
    if (one.restless) {
      names.push_back(fmt::format("`{}`", mission[one.state].name));
    }
  }
  return names.empty()
             ? ""
             : fmt::format(
                   "the pump may hardly rest in {}: turns that follow one another closely, or "
                   "a hover in a swell",
                   fmt::join(names, ", "));
}

/// The states that take the most by following one another.
std::string roundLine(const EnergyBound& bound, const ir::Mission& mission) {
  std::vector<std::string> names;
  for (const ir::StateId state : bound.round) {
    names.push_back(fmt::format("`{}`", mission[state].name));
  }
  if (names.empty()) {
    return "";
  }
  const std::string every = ir::prove::durationOf(bound.round_s);
  return names.size() == 1
             ? fmt::format(
                   "it takes so much if {} is entered again and again, every {}: a minimum "
                   "time in it lowers the bound",
                   names.front(), every)
             : fmt::format(
                   "it takes so much if {} follow one another again and again, one round "
                   "every {}: a minimum time in one of them lowers the bound",
                   support::listed(names), every);
}

}  // namespace

/// The most that a flight takes from the batteries, where the vehicle's file says enough for it.
support::Result<void> energy(Run& run) {
  const auto board = compiler::usualBoardPower(run.platform());
  if (!board) {
    return std::unexpected(board.error());
  }
  const ir::AssumedWorld& world = run.worlds().assumed;  // the widest if nothing is assumed
  const auto bound = ir::prove::energyBoundOf(world.mission, world.platform, *board,
                                              ir::prove::Parameters::AsWritten);
  if (!bound) {
    return {};
  }
  run.remark((run.mission().assumptions.empty() ? "" : "under the mission's assumptions, ") +
             boundLine(*bound, packOf(run.mission(), run.platform().power),
                       whyOf(run.mission(), run.platform().power)) +
             (run.mission().shares.empty() ? "" : "; its acoustic modem is not counted"));
  for (std::string line :
       {leastLine(*bound, run.platform().power.board), seaLine(*bound),
        statesLine(bound->states, run.mission()), turnsLine(bound->states, run.mission()),
        roundLine(*bound, run.mission())}) {
    if (!line.empty()) {
      run.remark(std::move(line));
    }
  }
  return {};
}

}  // namespace glider::analysis::check
