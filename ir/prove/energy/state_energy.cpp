// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/energy/state_energy.h"

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/energy/greatest_walk.h"
#include "ir/prove/energy/profile_legs.h"
#include "ir/worlds/naps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

/// A surfacing is a stay at the surface of so long, s.
constexpr double kSurfacing_s = 60;

/// A vehicle less deep may be at the surface, m.
constexpr double kAtSurface_m = 0.5;

/// A pump that works for such a share of the time hardly rests.
constexpr double kRestless = 0.5;

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

/// A leg that has begun by a turn.
struct BegunLeg {
  size_t leg = 0;
  const LegTurn* turn = nullptr;  ///< null: the state becomes current with it
  DepthSpan where;
  EnergyUse stroke;       ///< of pump and pitch battery, with which it begins
  bool reversed = false;  ///< from a dive to a climb, or the reverse
  bool from_surface = false;
  bool broached = false;  ///< the turn may have led to the surface
};

double noiseOf(const ProofContext& seen) {
  return seen.depth ? seen.platformSensor(*seen.depth)->noise : 0;
}

/// The hull's own limit, where the commands have none.
double withinHull(const platforms::Platform& platform, double depth_m) {
  const platforms::Envelope& envelope = platform.envelope;
  return std::min(depth_m, envelope.greatest_depth_m + envelope.inflection_overshoot_m);
}

/// Out and in again.
EnergyUse pumped(const GreatestPower& power, double cc, double depth_m) {
  EnergyUse use;
  use.pump_out_j = power.pumpOut(cc, depth_m);
  use.pump_in_j = power.pumpIn(cc);
  return use;
}

class StateGraph {
 public:
  StateGraph(const LegContext& context, const GreatestPower& power, StateId state, double deepest_m)
      : m_(context.seen.mission),
        noise_m_(noiseOf(context.seen)),
        platform_(context.seen.platform),
        model_(*platform_.power.bounds),
        power_(power),
        deepest_m_(withinHull(platform_, deepest_m)),
        stroke_cc_(2 * platform_.envelope.pump_cc),
        stroke_s_(stroke_cc_ / platform_.motion->pump_rate_cc_s),
        late_s_(platform_.world.command_delay_s),
        late_there_s_(late_s_ - (m_.nap_s ? kNapLag_s : 0)),
        legs_(legsOf(context, state)),
        fastest_m_s_(fastest()) {}

  StateEnergy run() {
    StateEnergy found;
    found.fastest_m_s = fastest_m_s_;
    std::vector<BegunLeg> first;
    for (const size_t leg : legs_.first) {
      first.push_back(begin(leg, {}, {}, true));
    }
    phases_.push_back(phaseOf(first, nullptr));
    for (const LegTurn& turn : legs_.turns) {
      if (!turn.waits.empty()) {
        phases_.push_back(phaseOf({begin(turn)}, &turn));
      }
    }
    found.lines = phases_.size() == 1 ? phases_.front().lines : overPhases();
    // In any case its pump does no more than to work all the time.
    found.lines.push_back(restlessLine(power_, platform_, deepest_m_));
    const EnergyUse rest = found.lines.back().rate;
    std::ranges::stable_sort(found.lines, {},
                             [&](const EnergyLine& line) { return power_.joules(line.rate); });
    const EnergyUse rate = found.lines.front().rate;
    found.restless =
        rate.pump_out_j + rate.pump_in_j > kRestless * (rest.pump_out_j + rest.pump_in_j);
    return found;
  }

 private:
  /// On average over a leg.
  [[nodiscard]] double fastest() const {
    const double most = platform_.envelope.vertical_rate_m_s;
    const double steepest = legs_.steepest_rad + model_.pitch_off_deg * kRadiansPerDegree;
    return legs_.steepest_rad > 0 ? std::min(most, model_.glide_m_s * std::sin(steepest)) : most;
  }

  /// From where the state becomes current, or from a turn that waited for a time, to the next such
  /// turn.
  struct Phase {
    const LegTurn* begins = nullptr;  ///< null: the state becomes current
    EnergyLines lines;
    std::set<size_t> legs;  ///< those that it may have
  };

  /// The walks through phases: vertex 0 is the first.
  [[nodiscard]] EnergyLines overPhases() const {
    std::vector<EnergyArc> arcs;
    for (size_t i = 0; i < phases_.size(); ++i) {
      arcs.push_back({i, i, {phases_[i].lines.front().rate}});
      arcs.push_back({i, phases_.size(), usesWithin(phases_[i].lines, power_, 0, kLongestMission)});
      for (size_t k = 1; k < phases_.size(); ++k) {
        if (phases_[i].legs.contains(phases_[k].begins->from)) {
          const double least = leastPhase(phases_[i], *phases_[k].begins);
          arcs.push_back(
              {i, k, usesWithin(phases_[i].lines, power_, least, least + kLongestMission)});
        }
      }
    }
    return linesOf(graphOf(phases_.size() + 1, std::move(arcs)), power_);
  }

  /// The shortest time of a phase that ends with this turn.
  [[nodiscard]] double leastPhase(const Phase& phase, const LegTurn& end) const {
    double least = platform_.envelope.cycle_s;
    for (const TimerWait& wait : end.waits) {
      if (phase.begins != nullptr &&
          std::ranges::find(phase.begins->sets, wait.since) != phase.begins->sets.end()) {
        least = std::max(least, wait.least_s);
      }
    }
    return least;
  }

  [[nodiscard]] EnergyGraph graphOf(size_t vertices, std::vector<EnergyArc> arcs) const {
    return {vertices, std::move(arcs), [this](const EnergyUse& use) { return power_.joules(use); }};
  }

  /// The walks through legs that begin with one of `first` and have no turn that waits for a time.
  /// Vertices: 0 where it begins, 1 where it ends, then the legs that have begun.
  [[nodiscard]] Phase phaseOf(const std::vector<BegunLeg>& first, const LegTurn* begins) const {
    std::vector<BegunLeg> begun = first;
    for (const LegTurn& turn : legs_.turns) {
      if (turn.waits.empty()) {
        begun.push_back(begin(turn));
      }
    }
    const auto vertexOf = [](size_t i) { return i + 2; };
    std::vector<EnergyArc> arcs;
    for (size_t i = 0; i < begun.size(); ++i) {
      if (i < first.size()) {
        arcs.push_back({0, vertexOf(i), {{}}});
      }
      for (size_t k = first.size(); k < begun.size(); ++k) {
        if (begun[k].turn->from == begun[i].leg) {
          arcs.push_back(
              {vertexOf(i), vertexOf(k), usesOf(begun[i], leastTime(begun[i], begun[k]))});
        }
      }
      arcs.push_back({vertexOf(i), 1, usesOf(begun[i], 0)});
      arcs.push_back({vertexOf(i), vertexOf(i), goesOn(begun[i])});
    }
    return {begins, linesOf(graphOf(begun.size() + 2, std::move(arcs)), power_), legsFrom(first)};
  }

  /// The legs that may follow without a turn that waits for a time.
  [[nodiscard]] std::set<size_t> legsFrom(const std::vector<BegunLeg>& first) const {
    std::vector<size_t> open;
    for (const BegunLeg& one : first) {
      open.push_back(one.leg);
    }
    std::set<size_t> found;
    while (!open.empty()) {
      const size_t at = open.back();
      open.pop_back();
      if (found.insert(at).second) {
        for (const LegTurn& turn : legs_.turns) {
          if (turn.from == at && turn.waits.empty()) {
            open.push_back(turn.to);
          }
        }
      }
    }
    return found;
  }

  /// From one turn to the next: the way between the two, and the time in which the pump turns the
  /// vehicle. It goes on for half of that and comes back in the other half, to the depth of the
  /// command.
  [[nodiscard]] double leastTime(const BegunLeg& begun, const BegunLeg& next) const {
    const double gap =
        std::max(gapBetween(begun.where, next.where), gapByLimits(begun.turn, next.turn));
    const double turns = begun.reversed && gap > 0 ? stroke_s_ : 0;
    return std::max(platform_.envelope.cycle_s, turns + gap / fastest_m_s_);
  }

  /// How far apart two turns are by limits whose difference is known, m.
  [[nodiscard]] double gapByLimits(const LegTurn* a, const LegTurn* b) const {
    double gap = 0;
    if (a != nullptr && b != nullptr) {
      for (const DepthCondition& one : a->limits) {
        for (const DepthCondition& other : b->limits) {
          const auto apart = one.deeper == other.deeper
                                 ? std::nullopt
                                 : constantDifference(m_, one.limit, other.limit);
          gap = std::max(gap, apart ? (one.deeper ? *apart : -*apart) - noise_m_ : 0);
        }
      }
    }
    return gap;
  }

  [[nodiscard]] BegunLeg begin(const LegTurn& turn) const {
    // One that only goes on may not have left the surface.
    const ProfileLeg& before = legs_.legs[turn.from];
    const bool shallow = turn.where.shallowest < kUnderWater_m;
    BegunLeg begun = begin(turn.to, turn.where, before,
                           mayFloat(before) || (before.drive == Drive::Down && shallow));
    begun.turn = &turn;
    if (glides(before.drive) && glides(legs_.legs[turn.to].drive)) {
      begun.stroke.pitch_battery_s *= shareOfTurn();
    }
    begun.broached =
        before.drive == Drive::Up &&
        before.target.shallowest < platform_.envelope.inflection_overshoot_m + kAtSurface_m;
    return begun;
  }

  static bool glides(Drive drive) { return drive == Drive::Up || drive == Drive::Down; }

  /// How far the pitch battery moves for a turn, of its way between the steepest climb and dive.
  [[nodiscard]] double shareOfTurn() const {
    const double off = model_.pitch_off_deg * kRadiansPerDegree;
    return std::min(1.0, (legs_.steepest_rad + off) / platform_.envelope.steepest_pitch_rad);
  }

  /// Another command moves the pump, also one that drives the same way: a climb that has arrived
  /// holds its depth, `surface` pumps to the end.
  [[nodiscard]] BegunLeg begin(size_t leg, const DepthSpan& where, const ProfileLeg& before,
                               bool from_surface) const {
    BegunLeg begun;
    begun.leg = leg;
    begun.where = where;
    begun.from_surface = from_surface;
    const Drive drive = legs_.legs[leg].drive;
    begun.reversed = glides(drive) && glides(before.drive) && drive != before.drive;
    if (!before.command || legs_.legs[leg].command != before.command) {
      const double out = power_.pumpOut(stroke_cc_, deepest_m_), in = power_.pumpIn(stroke_cc_);
      const bool starts_to_rise = drive == Drive::Up && before.drive == Drive::Down;
      const bool starts_to_sink = drive == Drive::Down && before.drive == Drive::Up;
      const bool outwards = starts_to_rise || (!starts_to_sink && out > in);
      begun.stroke.pump_out_j = outwards ? out : 0;
      begun.stroke.pump_in_j = outwards ? 0 : in;
      begun.stroke.pitch_battery_s = model_.pitch_battery_turn_s;
    }
    begun.stroke = begun.stroke + whileLate();
    return begun;
  }

  /// What its pump and battery may do in addition while a command is late: where a depth is reached
  /// and no command comes, hookbeh begins to hover. Naps add nothing (napAhead_m): wherever the
  /// profile turns at the depth that it goes to, the SBC is awake by then.
  [[nodiscard]] EnergyUse whileLate() const {
    EnergyUse use =
        pumped(power_, platform_.motion->pump_rate_cc_s / 2 * late_there_s_, deepest_m_);
    use.pitch_battery_s = late_there_s_;
    return use;
  }

  /// Until a dive has left the surface, s.
  [[nodiscard]] double startsDive() const { return model_.dive_start_s + late_s_; }

  /// Whether the vehicle may stay at the surface in a leg. A hover comes back to its depth with
  /// strokes of the whole pump, and may go beyond it as far as a turn does.
  [[nodiscard]] bool mayFloat(const ProfileLeg& leg) const {
    const double beyond = leg.drive == Drive::Hover ? platform_.envelope.inflection_overshoot_m : 0;
    return leg.drive == Drive::Anywhere ||
           (leg.drive != Drive::Down && leg.target.shallowest < kUnderWater_m + beyond);
  }

  /// A leg that lasts, from `least` seconds on: at each time from which on another device rests.
  [[nodiscard]] std::vector<EnergyUse> usesOf(const BegunLeg& begun, double least) const {
    std::vector<EnergyUse> uses;
    for (const double s : {least, kSurfacing_s, startsDive()}) {
      if (s >= least) {
        uses.push_back(useOf(begun, s));
      }
    }
    return uses;
  }

  /// What a leg takes in a second after all that happens at its beginning; a leg may last.
  [[nodiscard]] std::vector<EnergyUse> goesOn(const BegunLeg& begun) const {
    const double settled = std::max(kSurfacing_s, startsDive());
    return {useOf(begun, settled + 1) - useOf(begun, settled)};
  }

  /// A stroke that has begun is counted whole: it may go on in the next leg.
  [[nodiscard]] EnergyUse useOf(const BegunLeg& begun, double seconds) const {
    const ProfileLeg& leg = legs_.legs[begun.leg];
    if (leg.drive == Drive::Anywhere) {
      return restlessLine(power_, platform_, deepest_m_).rate * seconds + begun.stroke;
    }
    EnergyUse use = begun.stroke;
    use.seconds = use.powered_s = seconds;
    use.pitch_battery_s += model_.pitch_battery_share * seconds;
    if (mayFloat(leg)) {
      use.surface_s = seconds;
      use.surfacings = std::min(1.0, seconds / kSurfacing_s);  // it may begin in a leg before
    } else if (begun.from_surface) {
      use.surface_s = std::min(seconds, startsDive());
      use.surfacings = std::min(1.0, seconds / kSurfacing_s);  // one that began before
    } else if (begun.broached) {
      use.surface_s = std::min(seconds, 2 * stroke_s_ + late_s_);
    }
    return leg.drive == Drive::Hover || !leg.turns_there
               ? use + pumped(power_, platforms::hoverPump(model_, heldFrom(leg)) * seconds,
                              deepest_m_)
               : use;
  }

  /// The least depth at which it holds in a leg, m: a climb that is commanded above its target
  /// stays where it is.
  [[nodiscard]] double heldFrom(const ProfileLeg& leg) const {
    return leg.drive == Drive::Up
               ? 0
               : leg.target.shallowest - platform_.envelope.inflection_overshoot_m;
  }

  const Mission& m_;
  double noise_m_;  ///< two readings of one depth differ by no more
  const platforms::Platform& platform_;
  const platforms::EnergyModel& model_;
  const GreatestPower& power_;
  double deepest_m_, stroke_cc_, stroke_s_;
  double late_s_;        ///< how much later than usual a command is obeyed
  double late_there_s_;  ///< where a dive or climb arrives, before which the SBC is woken
  ProfileLegs legs_;
  double fastest_m_s_;
  std::vector<Phase> phases_;
};

}  // namespace

EnergyLine restlessLine(const GreatestPower& power, const platforms::Platform& platform,
                        double deepest_m) {
  const double stroke_cc = 2 * platform.envelope.pump_cc;
  const double depth_m = withinHull(platform, deepest_m);
  const auto pumping = [&](double at_m) {
    EnergyUse use = pumped(power, platform.motion->pump_rate_cc_s / 2, at_m);
    use.seconds = use.powered_s = use.pitch_battery_s = 1;
    return use;
  };
  EnergyUse above = pumping(kUnderWater_m);
  above.surface_s = 1;
  above.surfacings = 1 / kSurfacing_s;
  const EnergyUse below = pumping(depth_m);
  EnergyLine line{power.joules(above) > power.joules(below) ? above : below, {}};
  const double out = power.pumpOut(stroke_cc, depth_m), in = power.pumpIn(stroke_cc);
  (out > in ? line.offset.pump_out_j : line.offset.pump_in_j) = std::max(out, in);
  line.offset.surfacings = 1;
  return line;
}

StateEnergy energyOf(const LegContext& context, const GreatestPower& power, StateId state,
                     double deepest_m) {
  return StateGraph(context, power, state, deepest_m).run();
}

}  // namespace glider::ir::prove
