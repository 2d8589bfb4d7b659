// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/energy/energy_bound.h"

#include "ir/prove/abstract/earliest_entry.h"
#include "ir/prove/abstract/leaving.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/abstract/watch_times.h"
#include "ir/prove/energy/depth_span.h"
#include "ir/prove/energy/greatest_walk.h"
#include "ir/prove/energy/instruments.h"
#include "ir/prove/energy/places.h"
#include "ir/prove/energy/state_energy.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace glider::ir::prove {
namespace {

constexpr Interval kEver{0, kGreatestNumber, false};
/// Of a mission with more, nothing is said.
constexpr size_t kMostArcs = 20000;
/// No mission is so short that a second is worth more joules.
constexpr double kGreatestPrice = 1000;
/// What states take by following one another is reported if it is so many times what they take
/// alone, and if they do so soon, s.
constexpr double kMuchMore = 1.5;
constexpr double kSoon_s = 60;
/// What rounding may take from a bound.
constexpr double kRoundedUp = 1 + 1e-6;

/// A place has become current.
struct Entered {
  size_t place = 0;
  DepthSpan where;
};

/// A way from a place, the same each time that it becomes current.
struct PlaceWay {
  const StayStep* by = nullptr;
  DepthSpan where;
  double least_s = 0, most_s = 0;
};

class MissionGraph {
 public:
  MissionGraph(const ProofContext& proof_context, const EndBound& end, const GreatestPower& power)
      : seen_(proof_context.withDepthKnown()),
        legs_(seen_),
        instruments_(legs_),
        m_(seen_.mission),
        end_(end),
        power_(power),
        places_(placesOf(proof_context)),
        states_(m_.states.size()),
        ways_(places_.all.size()),
        depths_(deepestByState(proof_context)) {}

  /// False: there are too many ways.
  bool build() {
    arrive({places_.first, {0, seen_.platform.world.start_depth_m}});
    for (size_t at = 0; at < entered_.size(); ++at) {
      for (const PlaceWay& way : waysFrom(entered_[at].place).ways) {
        follow(at, way);
      }
      if (arcs_.size() > kMostArcs) {
        return false;
      }
    }
    // A mission ends, or is looked at, at any time.
    for (size_t at = 0; at < entered_.size(); ++at) {
      arcs_.push_back(
          {vertexOf(at), kEnd, usesOf(stateOf(at), 0, waysFrom(entered_[at].place).longest_s)});
    }
    return true;
  }

  EnergyBound bound() {
    const EnergyGraph graph(entered_.size() + 1, std::move(arcs_),
                            [&](const EnergyUse& use) { return power_.joules(use); });
    EnergyBound found = forLong(graph);
    if (end_.by) {
      untilTheEnd(graph, found);
    } else if (!(found.watts > 0)) {
      // It comes to an end, later than any that is looked for.
      found.joules = found.start_j;
      found.devices = power_.byDevice(graph.greatestWalk(0));
    }
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      if (states_[i]) {
        const EnergyLine& line = states_[i]->lines.front();
        found.states.push_back({{i}, power_.joules(line.rate) * kRoundedUp, states_[i]->restless});
      }
    }
    findRound(graph, found);
    limitByRestless(found);
    found.deepest_m = deepest();
    return found;
  }

 private:
  /// However its states follow one another, it takes no more than a vehicle that never rests.
  void limitByRestless(EnergyBound& found) const {
    EnergyLine line = restlessLine(power_, seen_.platform, deepest());
    instruments_.addMostTo(line);
    const double watts = power_.joules(line.rate), start = power_.joules(line.offset);
    if (watts < found.watts) {
      found.watts = watts * kRoundedUp;
      found.start_j = start * kRoundedUp;
      found.devices = found.joules ? found.devices : power_.byDevice(line.rate);
    }
    if (found.joules && end_.by && watts * *end_.by + start < *found.joules) {
      found.joules = (watts * *end_.by + start) * kRoundedUp;
      found.devices = power_.byDevice(line.rate * *end_.by + line.offset);
    }
  }

  /// Of all states that may become current, within the limits of the hull.
  [[nodiscard]] double deepest() const {
    double deepest = 0;
    for (size_t i = 0; i < entered_.size(); ++i) {
      deepest = std::max(deepest, depths_[stateOf(i)]);
    }
    const platforms::Envelope& envelope = seen_.platform.envelope;
    return std::min(deepest, envelope.greatest_depth_m + envelope.inflection_overshoot_m);
  }

  void findRound(const EnergyGraph& graph, EnergyBound& found) const {
    double most = 0;
    for (const StateBound& state : found.states) {
      most = std::max(most, state.watts);
    }
    const EnergyUse& cycle = graph.costliestCycle();
    const auto states = static_cast<double>(graph.verticesOfCycle().size());
    if (graph.costliestPower() < kMuchMore * most || cycle.seconds > kSoon_s * states) {
      return;
    }
    for (const size_t vertex : graph.verticesOfCycle()) {
      const StateId state = {stateOf(vertex == 0 ? 0 : vertex - 1)};
      if (std::ranges::find(found.round, state) == found.round.end()) {
        found.round.push_back(state);
      }
    }
    std::ranges::sort(found.round);
    found.round_s = cycle.seconds;
  }

  // Vertices: 0 is the start, where the first state becomes current; the last is the end.
  static constexpr size_t kEnd = 1;
  static size_t vertexOf(size_t entered) { return entered == 0 ? 0 : entered + 1; }

  [[nodiscard]] uint32_t stateOf(size_t entered) const {
    return places_.all[entered_[entered].place].state;
  }

  /// The number of a place that becomes current so; a new one if there is none yet.
  size_t arrive(const Entered& entered) {
    const std::tuple key(entered.place, entered.where.shallowest, entered.where.deepest);
    const auto [known, fresh] = numbers_.emplace(key, entered_.size());
    if (fresh) {
      const uint32_t state = places_.all[entered.place].state;
      if (!states_[state]) {
        states_[state] = energyOf(legs_, power_, {state}, depths_[state]);
        instruments_.addTo(states_[state]->lines, {state});
      }
      entered_.push_back(entered);
    }
    return known->second;
  }

  /// What may follow a place, and how long it may be current, s.
  struct PlaceWays {
    std::vector<PlaceWay> ways;
    double longest_s = 0;
  };

  const PlaceWays& waysFrom(size_t number) {
    std::optional<PlaceWays>& found = ways_[number];
    if (!found) {
      found.emplace();
      const StayPlace& place = places_.all[number];
      const Leaving stay =
          stayOf(seen_, m_.states[place.state], {place.always, place.again}, *place.values);
      for (const StayStep& step : place.steps) {
        const double latest =
            step.list == ListKind::Always ? stay.interrupted : stay.latest[step.number];
        addWay(found->ways, place, step, latest);
      }
      found->longest_s = std::min(stay.by, kLongestMission);
    }
    return *found;
  }

  void addWay(std::vector<PlaceWay>& ways, const StayPlace& place, const StayStep& step,
              double latest) const {
    const double most = std::min(latest, kLongestMission);
    const auto clocks = [&](double s) {
      const Interval stay{0, s, false};
      return ClockRanges{kEver, place.again ? kEver : stay, stay};
    };
    const ExprId guard = step.by->guard;
    const auto mayBeTrue = [&](double s) {
      const IdleTemporals idle = idleBefore(seen_, guard, s, !place.again);
      return AbstractEvaluator(seen_, *place.values, clocks(s), std::nullopt, &idle)
          .truth(guard)
          .is_true;
    };
    if (most < 0 || !mayBeTrue(most)) {
      return;
    }
    if (const auto where = depthsWhere(seen_, *place.values, clocks(most), guard)) {
      const double least = std::max(seen_.platform.envelope.cycle_s, leastWhere(most, mayBeTrue));
      ways.push_back({&step, *where, least, std::max(least, most)});
    }
  }

  void follow(size_t at, const PlaceWay& way) {
    const Entered from = entered_[at];
    const uint32_t state = stateOf(at);
    const double least =
        std::max(way.least_s, gapBetween(from.where, way.where) / states_[state]->fastest_m_s);
    const std::vector<EnergyUse> uses = usesOf(state, least, std::max(least, way.most_s));
    if (way.by->by->transition == Transition::Exit) {
      arcs_.push_back({vertexOf(at), kEnd, uses});
    }
    for (const size_t to : way.by->to) {
      arcs_.push_back({vertexOf(at), vertexOf(arrive({to, way.where})), uses});
    }
  }

  [[nodiscard]] std::vector<EnergyUse> usesOf(uint32_t state, double least, double most) const {
    return usesWithin(states_[state]->lines, power_, least, most);
  }

  /// Per second, for long; a mission whose states do not follow one another in a circle has its
  /// costliest state.
  EnergyBound forLong(const EnergyGraph& graph) const {
    EnergyUse second;
    double watts = graph.costliestPower();
    if (graph.costliestCycle().seconds > 0) {
      second = graph.costliestCycle() * (1 / graph.costliestCycle().seconds);
    }
    for (size_t i = 0; i < entered_.size(); ++i) {
      const EnergyLine& line = states_[stateOf(i)]->lines.front();
      if (lasts(entered_[i].place) && power_.joules(line.rate) > watts) {
        second = line.rate;
        watts = power_.joules(line.rate);
      }
    }
    EnergyBound found;
    found.watts = watts * kRoundedUp;
    const EnergyUse walk = graph.greatestWalk(found.watts);
    found.start_j = (power_.joules(walk) - found.watts * walk.seconds) * kRoundedUp;
    found.devices = power_.byDevice(second);
    return found;
  }

  /// Whether a place may stay current as long as any mission.
  [[nodiscard]] bool lasts(size_t place) const {
    return ways_[place]->longest_s >= kLongestMission;
  }

  /// The least over all prices of a second: a mission of `by` seconds takes no more than its price
  /// and what the greatest walk takes beyond it. That is least where the walk takes as long: a
  /// dearer second makes it shorter.
  void untilTheEnd(const EnergyGraph& graph, EnergyBound& found) const {
    const double by = *end_.by;
    double low = graph.costliestPower() * kRoundedUp, high = low + kGreatestPrice;
    EnergyUse longer = graph.greatestWalk(low), shorter = graph.greatestWalk(high);
    if (longer.seconds <= by) {
      high = low;  // more time is that of the costliest cycle
      shorter = longer;
      longer = longer + graph.costliestCycle();
    }
    constexpr int kRounds = 60;
    for (int i = 0; i < kRounds && low < high; ++i) {
      const double price = low + (high - low) / 2;
      const EnergyUse walk = graph.greatestWalk(price);
      (walk.seconds > by ? low : high) = price;
      (walk.seconds > by ? longer : shorter) = walk;
    }
    found.joules = (by * high + power_.joules(shorter) - high * shorter.seconds) * kRoundedUp;
    const double more = longer.seconds - shorter.seconds;
    const double share = more > 0 ? (by - shorter.seconds) / more : 0;
    found.devices = power_.byDevice(shorter + (longer - shorter) * share);
  }

  ProofContext seen_;
  LegContext legs_;
  InstrumentShares instruments_;
  const Mission& m_;
  const EndBound& end_;
  const GreatestPower& power_;
  StayPlaces places_;
  std::vector<std::optional<StateEnergy>> states_;  ///< those that become current
  std::vector<std::optional<PlaceWays>> ways_;      ///< of each place
  std::vector<double> depths_;
  std::vector<Entered> entered_;
  std::map<std::tuple<size_t, double, double>, size_t> numbers_;  ///< of what is in `entered_`
  std::vector<EnergyArc> arcs_;
};

/// The mission with its parameters as they are written.
Mission asWritten(const Mission& mission) {
  Mission written = mission;
  for (Variable& variable : written.variables) {
    if (variable.kind == VariableKind::Parameter && variable.type.kind == TypeKind::Quantity) {
      variable.lowest = variable.highest = mission[variable.initial].number;
    }
  }
  return written;
}

}  // namespace

std::optional<EnergyBound> energyBoundOf(const Mission& mission,
                                         const platforms::Platform& platform,
                                         const std::optional<platforms::BoardPower>& board,
                                         Parameters parameters) {
  if (!platform.power.bounds || !platform.motion || platform.motion->pump_rate_cc_s <= 0) {
    return std::nullopt;
  }
  const Mission meant = parameters == Parameters::AsWritten ? asWritten(mission) : mission;
  const ProofContext proof_context(meant, platform);
  const EndBound end = boundOf(proof_context, kLongestMission, Goal::Exit);
  const GreatestPower power(meant, platform, board);
  MissionGraph graph(proof_context, end, power);
  if (!graph.build()) {
    return std::nullopt;
  }
  EnergyBound bound = graph.bound();
  if (const double exit = earliestExit(proof_context); std::isfinite(exit)) {
    bound.earliest_s = exit;
    bound.least_j = exit * restingPower(meant, platform, board);
  }
  return bound;
}

}  // namespace glider::ir::prove
