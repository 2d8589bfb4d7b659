// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is proved about random missions, and what they are warned of, holds in random flights of
// them, with faults of sensors, outages, and restarts of the flight controller.
// scripts/soak/random_proofs flies more of the same.

#include "ir/prove/falsification/random_flight.h"
#include "ir/text/print.h"
#include "ir/verify/verify.h"
#include "ir/worlds/worlds.h"
#include "support/diagnostics/ids/verification.h"
#include "tests/containment/hard_mission.h"
#include "tests/random_missions/random_mission.h"
#include "tests/random_proofs/flight_check.h"
#include "tests/random_proofs/requirements.h"
#include "tests/random_proofs/restarts.h"
#include "tests/random_proofs/tally.h"
#include "tests/unit/ir/slocum.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <iterator>

namespace glider::random_proofs {
namespace {

using containment::Flight;
using containment::FlightStyle;

constexpr uint64_t kFlights = 5;
constexpr size_t kTicks = 200;

uint64_t numberFrom(const char* name, uint64_t standard) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : standard;
}

/// A little effort: what is left undecided is of no use here.
ir::prove::Options effort() {
  ir::prove::Options how;
  how.effort = 100000;
  how.run_effort = 150000;
  how.total_effort = 600000;
  how.random_ticks = 2000;
  return how;
}

/// Random missions that are hard to prove right, and some with every construct there is.
ir::Mission missionOf(uint64_t seed) {
  constexpr uint64_t kShare = 6;
  return seed % kShare == 0 ? random_missions::randomMission(seed) : containment::hardMission(seed);
}

/// Some vehicles obey late, as by their port.
platforms::Platform vehicleOf(uint64_t seed) {
  platforms::Platform vehicle = ir::slocum();
  if (seed % 3 == 0) {
    vehicle.world.command_delay_s = 60;
    vehicle.world.climb_hold_m = 10;
  }
  return vehicle;
}

/// One mission, what is said of it, and flights of it.
class Trial {
 public:
  Trial(uint64_t seed, Tally& tally)
      : seed_(seed),
        tally_(tally),
        vehicle_(vehicleOf(seed)),
        required_(withRequirements(missionOf(seed), vehicle_, seed)),
        worlds_(required_.mission, vehicle_),
        wide_(worlds_.widest.mission, worlds_.widest.platform),
        narrow_(worlds_.written.mission, worlds_.assumed.platform) {}

  void run() {
    check();
    Met met;
    for (uint64_t i = 0; i < kFlights && !testing::Test::HasFailure(); ++i) {
      fly(i, met);
    }
    if (!testing::Test::HasFailure()) {
      flyWithRestarts(met);
    }
    for (const auto& area : areas_) {
      flyIn(area);
    }
    ++tally_.missions;
    for (const size_t i : met.verdicts) {
      ++tally_.requirements[required_.kinds[watched_.verdicts[i].requirement]].met;
    }
    for (size_t i = 0; i < watched_.claims.size(); ++i) {
      Tally::Findings& row = tally_.findings[support::code(watched_.claims[i].id)];
      ++row.watched;
      row.met += met.claims.contains(i) ? 1U : 0U;
    }
  }

 private:
  void check() {
    const ir::Mission& m = required_.mission;
    support::DiagnosticEngine verified;
    support::DiagnosticEngine proved;
    const ir::MissionFacts facts = ir::verify(m, verified);
    const auto findings = ir::prove::prove(worlds_, facts, effort(), proved);
    std::set<ir::CasePlace> dead;
    for (const auto& [place, hidden] : findings.never_fire) {
      dead.insert(place);
    }
    watched_.stack_depth = facts.stack_depth;
    watched_.claims = claimsOf(m, verified, {});
    std::ranges::move(claimsOf(m, proved, dead), std::back_inserter(watched_.claims));
    for (const auto& verdict : findings.requirements) {
      tally_.add(required_.kinds[verdict.requirement], verdict);
      const bool reach = m.requirements[verdict.requirement].kind == ir::RequirementKind::Reach;
      const auto watched = reach ? ir::prove::Verdict::Refuted : ir::prove::Verdict::Proved;
      const bool area = !m.requirements[verdict.requirement].geofences.empty();
      if (verdict.verdict == watched) {
        (area ? areas_ : watched_.verdicts).push_back(verdict);
      }
    }
  }

  void fly(uint64_t number, Met& met) {
    const bool narrowed = number % 2 == 1;
    FlightStyle style;
    style.power_cuts = number != 2;
    style.pressing = number >= 2;
    style.late = number == 1 || number == 4;
    style.silent = number == 4 && needsReadings();
    style.environment = narrowed ? &worlds_.assumed.mission : nullptr;
    const ir::prove::ProofContext& context = narrowed ? narrow_ : wide_;
    Flight flight(context, seed_ * kFlights + number, style);
    FlightCheck looking(context, watched_, style, narrowed, met);
    flight.start();
    ++tally_.flights;
    std::string broken = looking.tick(flight);
    for (size_t i = 0; i < kTicks && !flight.over() && broken.empty(); ++i) {
      flight.advance();
      broken = halves(looking, flight);
      ++tally_.ticks;
    }
    if (!broken.empty()) {
      ADD_FAILURE() << "mission " << seed_ << ", flight " << number << ", at " << flight.now().time
                    << " s: " << broken << "\n"
                    << ir::print(required_.mission);
    }
  }

  /// A deployment in which the SBC and the flight controller restart. A mission that begins again
  /// in it is checked by those who watched the one before, unless it is another flight.
  void flyWithRestarts(Met& met) {
    constexpr size_t kMissions = 3;
    FlightStyle style;
    style.pressing = seed_ % 2 == 0;
    ir::prove::Rng dice(seed_);
    std::optional<FlightCheck> looking;
    looking.emplace(wide_, watched_, style, false, met);
    std::string broken;
    size_t ticks = 0;
    for (size_t mission = 0; mission < kMissions && broken.empty(); ++mission) {
      Flight flight(wide_, ~seed_ * kMissions + mission, style);
      flight.start();
      ++tally_.flights;
      broken = looking->tick(flight);
      std::optional<Restart> restart;
      while (broken.empty() && !flight.over() && ++ticks < 2 * kTicks) {
        restart = drawRestart(dice, required_.mission, false);
        if (restart && restart->then != runtime::Continuation::GoesOn) {
          break;
        }
        restart ? flight.advance(restart->outage_s) : flight.advance();
        tally_.restarts += restart ? 1U : 0U;
        broken = halves(*looking, flight);
        ++tally_.ticks;
      }
      while (flight.over() && !restart) {
        restart = drawRestart(dice, required_.mission, true);
      }
      if (!restart || restart->then != runtime::Continuation::Begins) {
        break;
      }
      ++tally_.begun_again;
      if (restart->another_flight) {
        looking.emplace(wide_, watched_, style, false, met);
      }
    }
    if (!broken.empty()) {
      ADD_FAILURE() << "mission " << seed_ << ", with restarts: " << broken << "\n"
                    << ir::print(required_.mission);
    }
  }

  /// The second half of a tick, seen from both.
  static std::string halves(FlightCheck& looking, Flight& flight) {
    const std::string broken = looking.midway(flight);
    if (!broken.empty()) {
      return broken;
    }
    flight.decide();
    return looking.tick(flight);
  }

  /// A flight whose readings of its position are right, within what the mission assumes.
  void flyIn(const ir::prove::RequirementVerdict& area) {
    ++tally_.requirements[required_.kinds[area.requirement]].met;
    const ir::Requirement& requirement = required_.mission.requirements[area.requirement];
    for (uint64_t i = 0; i < kFlights; ++i) {
      const auto run = ir::prove::flyAtRandom(narrow_, watched_.stack_depth, requirement,
                                              seed_ * kFlights + i, kTicks);
      ++tally_.flights;
      if (run) {
        ADD_FAILURE() << "mission " << seed_ << ", flight " << i << ", at " << run->when
                      << " s: area " << area.requirement << " is proved\n"
                      << ir::print(required_.mission);
      }
    }
  }

  [[nodiscard]] bool needsReadings() const {
    return std::ranges::find(watched_.claims, support::diagnostics::endNeedsReadings, &Claim::id) !=
           watched_.claims.end();
  }

  uint64_t seed_;
  Tally& tally_;
  platforms::Platform vehicle_;
  Required required_;
  ir::Worlds worlds_;
  ir::prove::ProofContext wide_, narrow_;
  Watched watched_;
  std::vector<ir::prove::RequirementVerdict> areas_;  ///< proved
};

/// The mission that is tried, for a failed CHECK of the code under test.
uint64_t trying = 0;

void tellMission(int) {
  fmt::print(stderr, "while mission {} was tried\n", trying);
}

TEST(RandomProofs, HoldInFlightsWithFaultsAndOutages) {
  constexpr uint64_t kFew = 40;
  const uint64_t count = numberFrom("GLIDER_RANDOM_PROOFS", kFew);
  const uint64_t first = numberFrom("GLIDER_RANDOM_PROOFS_SEED", 1);
  Tally tally;
  std::signal(SIGABRT, tellMission);
  for (uint64_t seed = first; seed < first + count && !HasFailure(); ++seed) {
    trying = seed;
    Trial(seed, tally).run();
  }
  fmt::print("{}", tally.text());
  if (count >= kFew) {
    EXPECT_GT(tally.restarts, count / 5) << "restarts after which a mission went on";
    EXPECT_GT(tally.begun_again, count / 20);
  }
}

}  // namespace
}  // namespace glider::random_proofs
