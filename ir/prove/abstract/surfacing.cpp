// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/surfacing.h"

#include "ir/core/walk.h"
#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/context/commands.h"
#include "ir/verify/intervals.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// The upper bound of expressions evaluated.
constexpr size_t kMostWork = 4000000;
/// A place that is raised more often is in a loop without a surfacing, or nearly so.
constexpr unsigned kMostRaised = 200;

/// A sum rounded up.
double sumOf(double a, double b) {
  return a + b == a && b == 0 ? a : std::nextafter(a + b, kInfinity);
}

bool isVerticalCommand(const Statement& statement) {
  return statement.kind == StatementKind::Command && isVertical(statement.command);
}

/// How the time since the last tick at the surface changes on the way to another place.
struct Way {
  size_t to = 0;
  bool surfaced = false;  ///< it becomes 0
  double added = 0;       ///< otherwise this is added
};

/// A state that has become current, or a state that returns: see Places.
struct StatePlace {
  bool followed = false;
  double longest = -1;          ///< since the last tick at the surface; negative: not reached
  double stays = 0;             ///< what is added by its last tick under water
  double by = kGreatestNumber;  ///< mission time of its last tick
  unsigned raised = 0;
  std::vector<Way> ways;
};

class SurfacingSearch {
 public:
  SurfacingSearch(const ProofContext& proof_context, const EndBound& end, double limit)
      : proof_context_(proof_context),
        m_(proof_context.mission),
        end_(end),
        limit_(limit),
        values_(anyValues(m_)),
        always_{neverPrevented(m_), false},
        depths_(deepestByState(proof_context)),
        count_(m_.states.size()),
        places_(3 * count_ + 1),
        callers_(count_) {
    for (uint32_t i = 0; i < count_; ++i) {
      for (const Case& c : m_.states[i].cases) {
        if (c.transition == Transition::Call) {
          callers_[c.target.index].push_back(i);
        }
      }
    }
    for (const Case& c : m_.always) {
      always_leads_down_ =
          always_leads_down_ || (c.transition == Transition::Stay && tells(c.action));
    }
  }

  std::optional<double> run() {
    raise(entered(0), 0);
    while (!open_.empty()) {
      const size_t at = open_.front();
      open_.pop_front();
      StatePlace& place = places_[at];
      if (!place.followed) {
        place.followed = true;
        follow(at);
      }
      const double last = std::min(sumOf(place.longest, place.stays), place.by);
      longest_ = std::max(longest_, last);
      if (longest_ > limit_ || work_ > kMostWork || place.raised > kMostRaised) {
        return std::nullopt;
      }
      for (const Way& way : place.ways) {
        raise(way.to, way.surfaced ? 0 : std::min(sumOf(place.longest, way.added), place.by));
      }
    }
    return longest_;
  }

  [[nodiscard]] std::vector<double> climbs() const {
    std::vector<double> all;
    for (uint32_t i = 0; i < count_; ++i) {
      all.push_back(climbOf(i));
    }
    return all;
  }

  /// After a bound was found.
  [[nodiscard]] std::vector<Submersion> submersions() const {
    std::vector<Submersion> all;
    for (uint32_t i = 0; i < count_; ++i) {
      all.push_back({places_[entered(i)].longest, places_[resumed(i)].longest, climbOf(i)});
    }
    return all;
  }

 private:
  // The places: each state as entered, each state as resumed, what each state returns to, and what
  // a state that `always` calls returns to.
  [[nodiscard]] static size_t entered(size_t state) { return state; }
  [[nodiscard]] size_t resumed(size_t state) const { return count_ + state; }
  [[nodiscard]] size_t returning(size_t state) const { return 2 * count_ + state; }
  [[nodiscard]] size_t returningAnywhere() const { return 3 * count_; }

  void raise(size_t to, double longest) {
    StatePlace& place = places_[to];
    if (longest > place.longest) {
      place.longest = longest;
      ++place.raised;
      open_.push_back(to);
    }
  }

  void follow(size_t at) {
    if (at == returningAnywhere()) {
      for (size_t i = 0; i < count_; ++i) {
        places_[at].ways.push_back({resumed(i), false, 0});
      }
    } else if (at >= returning(0)) {
      for (const uint32_t caller : callers_[at - returning(0)]) {
        places_[at].ways.push_back({resumed(caller), false, 0});
      }
    } else {
      followState(at);
    }
  }

  [[nodiscard]] bool tells(BlockId block) const {
    bool found = false;
    forEachStatement(m_, block, [&](const Statement& s) { found = found || isVerticalCommand(s); });
    return found;
  }

  /// Whether the state commands the surface whenever it becomes current, and nothing else that is
  /// about depth until it is left.
  [[nodiscard]] bool climbs(const State& state) const {
    if (always_leads_down_ || !commandsSurface(m_, state)) {
      return false;
    }
    for (const auto* cases : {&state.cases, &state.profile.cases, &state.route.cases}) {
      for (const Case& c : *cases) {
        const bool stays = c.transition == Transition::Stay || c.transition == Transition::Done;
        if (stays && tells(c.action)) {
          return false;
        }
      }
    }
    return true;
  }

  /// From this time in the state on every tick is at the surface.
  [[nodiscard]] double climbOf(uint32_t state) const {
    const platforms::EnvironmentModel& world = proof_context_.platform.world;
    if (!climbs(m_.states[state]) || !std::isfinite(depths_[state])) {
      return kInfinity;
    }
    constexpr double kRoundedUp = 1 + 0x1p-40;
    const double way = std::max(0.0, depths_[state] - world.surface_depth_m);
    return (world.turn_s + way / world.slowest_climb_m_s) * kRoundedUp;
  }

  void followState(size_t at) {
    const bool again = at >= resumed(0);
    const auto number = static_cast<uint32_t>(at % count_);
    const State& state = m_.states[number];
    StatePlace& place = places_[at];
    Interruptions always = always_;
    always.own_first = again;
    const Leaving stay = stayOf(proof_context_, state, always, values_);
    work_ += stay.work;
    const double climb = climbOf(number);
    place.by = end_.by ? end_.left_by[number] : kGreatestNumber;
    place.stays = std::min(stay.by, climb);
    for (size_t i = 0; i < state.cases.size(); ++i) {
      leave(place, state.cases[i], number, again, std::min(stay.latest[i], place.by), climb);
    }
    for (const Case& c : m_.always) {
      const bool kept = c.target.valid() && c.target.index == number;
      if (!kept && stay.interrupted >= 0) {
        leave(place, c, number, again, std::min(stay.interrupted, place.by), climb);
      }
    }
  }

  /// The way of a case that does not fire later than `latest` after the state became current.
  void leave(StatePlace& place, const Case& c, uint32_t state, bool again, double latest,
             double climb) {
    if (c.transition == Transition::Stay || c.transition == Transition::Exit) {
      return;
    }
    const Interval until{0, std::min(latest, kGreatestNumber), false};
    const Interval ever{0, kGreatestNumber, false};
    const auto mayBeTrue = [&](const Interval& stay, std::optional<AssumedReading> sight) {
      const AbstractEvaluator then(proof_context_, values_,
                                   {{0, place.by, false}, again ? ever : stay, stay}, sight);
      const bool may = then.truth(c.guard).is_true;
      work_ += then.work() + 1;
      return may;
    };
    if (!mayBeTrue(until, std::nullopt)) {
      return;
    }
    const double under = std::min(latest, climb);
    const bool surfaced = !mayBeTrue({0, std::min(under, kGreatestNumber), false}, underWater());
    if (c.transition == Transition::Return) {
      place.ways.push_back({returning(state), surfaced, under});
      if (isCalledByAlways(state)) {
        place.ways.push_back({returningAnywhere(), surfaced, under});
      }
    } else {
      place.ways.push_back({entered(c.target.index), surfaced, under});
    }
  }

  [[nodiscard]] bool isCalledByAlways(uint32_t state) const {
    return std::ranges::any_of(m_.always, [&](const Case& c) {
      return c.transition == Transition::Call && c.target.index == state;
    });
  }

  /// Where the vehicle is deeper than the surface.
  [[nodiscard]] std::optional<AssumedReading> underWater() const {
    if (!proof_context_.depth) {
      return std::nullopt;
    }
    const platforms::EnvironmentModel& world = proof_context_.platform.world;
    const Interval& all = proof_context_.sensors[proof_context_.depth->index];
    const double least = std::nextafter(world.surface_depth_m - world.depth_error_m, -kInfinity);
    const double lowest = std::max(all.lowest, least);
    return AssumedReading{*proof_context_.depth,
                          {lowest, all.highest, all.empty || lowest > all.highest}};
  }

  const ProofContext& proof_context_;
  const Mission& m_;
  const EndBound& end_;
  double limit_;
  Valuation values_;
  Interruptions always_;
  std::vector<double> depths_;
  size_t count_;
  std::vector<StatePlace> places_;
  std::vector<std::vector<uint32_t>> callers_;
  bool always_leads_down_ = false;
  std::deque<size_t> open_;
  double longest_ = 0;
  size_t work_ = 0;
};

}  // namespace

std::optional<double> longestSubmersion(const ProofContext& proof_context, const EndBound& end,
                                        double limit) {
  return SurfacingSearch(proof_context, end, limit).run();
}

std::vector<double> climbTimes(const ProofContext& proof_context) {
  const EndBound none;
  return SurfacingSearch(proof_context, none, kLongestMission).climbs();
}

std::vector<Submersion> submersionsOf(const ProofContext& proof_context, const EndBound& end) {
  SurfacingSearch search(proof_context, end, kLongestMission);
  return search.run() ? search.submersions() : std::vector<Submersion>();
}

}  // namespace glider::ir::prove
