// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/surfacing.h"

#include "ir/core/walk.h"
#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/profile_surfacing.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/abstract/surfacing_places.h"
#include "ir/prove/abstract/timer_guards.h"
#include "ir/prove/abstract/timers.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/context/vehicle_rules.h"
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
/// Of a mission with more timers, only the first are tried.
constexpr size_t kMostTimers = 8;
/// Of a mission with more configurations, only its states are followed.
constexpr size_t kMostConfigurations = 300;
/// One that is raised more often goes to what its timer allows at once.
constexpr unsigned kSlow = 100;

/// A sum rounded up.
double sumOf(double a, double b) {
  return a + b == a && b == 0 ? a : std::nextafter(a + b, kInfinity);
}

/// A list of cases that a timer's case may be in, and the number of a case.
struct CaseAt {
  bool always = false;
  size_t number = 0;
};

/// How the time since the last tick at the surface changes on the way to another place.
struct Way {
  size_t to = 0;
  bool surfaced = false;          ///< it becomes 0
  bool surfaced_before = false;   ///< it is no longer than `added`
  double added = 0;               ///< otherwise this is added
  std::optional<CaseAt> by = {};  ///< the case that leads there; none: as `return` went on
  bool sets_timer = false;        ///< that case's `do` may
  bool climbs_on = false;         ///< a climb to the surface that is in force goes on
};

/// A state that has become current, or a state that returns: see Places.
struct StatePlace {
  bool followed = false;
  Submerged since;              ///< as it becomes current
  double stays = 0;             ///< what is added by its last tick under water
  double by = kGreatestNumber;  ///< mission time of its last tick
  unsigned raised = 0;
  std::vector<Way> ways;
};

class SurfacingSearch {
 public:
  SurfacingSearch(const ProofContext& proof_context, const EndBound& end, double limit,
                  SurfacingPlaces where)
      : proof_context_(proof_context),
        m_(proof_context.mission),
        end_(end),
        limit_(limit),
        values_(anyValues(m_)),
        always_{neverPrevented(m_), false},
        depths_(deepestByState(proof_context)),
        count_(m_.states.size()),
        where_(std::move(where)),
        places_(where_.size()),
        profiles_(count_) {
    for (const Case& c : m_.always) {
      always_leads_down_ =
          always_leads_down_ || (c.transition == Transition::Stay && tells(c.action));
    }
    for (uint32_t i = 0; i < count_; ++i) {
      climbs_.push_back(climbs(m_.states[i]) ? climbFrom(depths_[i]) : kInfinity);
    }
  }

  /// Before run(): profiles that come to the surface by themselves bound the time too.
  void findProfiles() {
    const TimerGuards guards(proof_context_, values_, end_.by.value_or(kInfinity));
    for (uint32_t i = 0; i < count_; ++i) {
      profiles_[i] = profileSurfacing(proof_context_, guards, {i}, climbFrom(depths_[i]));
    }
  }
  /// Before run(): the cases of the timer bound the time too.
  void use(Timer timer) { timer_ = std::move(timer); }
  /// Before run().
  void follow(SurfacingPlaces where) {
    where_ = std::move(where);
    places_.assign(where_.size(), {});
  }

  /// The longest time under water, s; none: not found, or beyond the limit.
  std::optional<double> run() {
    raise(where_.start(), {0, 0, 0});
    while (!open_.empty()) {
      const size_t at = open_.front();
      open_.pop_front();
      StatePlace& place = places_[at];
      if (!place.followed) {
        place.followed = true;
        followFrom(at);
      }
      longest_ = std::max(longest_, lastOf(at));
      if (longest_ > limit_ || work_ > kMostWork || place.raised > kMostRaised ||
          (where_.areExact() && where_.size() > kMostConfigurations)) {
        return std::nullopt;
      }
      for (const Way& way : place.ways) {
        raise(way.to, after(at, way));
      }
    }
    return longest_;
  }

  [[nodiscard]] std::vector<double> climbs() const { return climbs_; }

  /// After a bound was found.
  [[nodiscard]] Submersions submersions() const {
    Submersions all{{}, timer_ ? timer_->since : VariableId{}, {}};
    for (uint32_t i = 0; i < count_; ++i) {
      all.states.push_back({{}, {}, climbs_[i], timedIn(i), profiles_[i]});
    }
    for (size_t at = 0; at < where_.size(); ++at) {
      if (where_.isState(at)) {
        Submersion& one = where_.areExact() ? configurationAt(at, all) : all.states[stateAt(at)];
        (where_.isAgain(at) ? one.resumed : one.entered) = submergedAt(at);
      }
    }
    return all;
  }

  /// The timers that may bound the time.
  [[nodiscard]] std::vector<Timer> timers() const {
    return timersOf(proof_context_, values_, end_.by.value_or(kInfinity), [&](ExprId guard) {
      const Interval ever{0, kGreatestNumber, false};
      return AbstractEvaluator(proof_context_, values_, {ever, ever, ever}, underWater())
          .truth(guard)
          .is_true;
    });
  }

 private:
  [[nodiscard]] uint32_t stateAt(size_t at) const { return where_.stateOf(at); }
  [[nodiscard]] bool isState(size_t at) const { return where_.isState(at); }

  /// The timer's case in `always`, where it is not kept from firing.
  [[nodiscard]] TimerCase timerOfAlways(size_t at) const {
    if (!where_.areExact() || !std::isfinite(timer_->always.longest)) {
      return timer_->ofAlways(stateAt(at));  // or none is in `always`
    }
    return where_.mayInterrupt(at, timer_->always.number) ? timer_->always : TimerCase{};
  }

  /// See Submersion: of a state, wherever it is current.
  [[nodiscard]] double timedIn(uint32_t state) const {
    return timer_ && !timer_->set_under_water[state] ? timer_->longest(state) : kInfinity;
  }

  /// That of the configuration at a place, which is as its state's if it is new.
  [[nodiscard]] Submersion& configurationAt(size_t at, Submersions& all) const {
    const uint32_t state = stateAt(at);
    const auto [found, is_new] =
        all.configurations.emplace(configurationOf(where_.controlAt(at)), all.states[state]);
    if (is_new && timer_ && !timer_->set_under_water[state]) {
      found->second.timed = std::min(timer_->own[state].longest, timerOfAlways(at).longest);
    }
    return found->second;
  }

  void raise(size_t to, const Submerged& since) {
    places_.resize(std::max(places_.size(), where_.size()));
    StatePlace& place = places_[to];
    const bool first = place.since.longest < 0;
    if (first || since.longest > place.since.longest || since.ahead > place.since.ahead ||
        since.begun > place.since.begun) {
      place.since = {std::max(since.longest, place.since.longest),
                     std::max(since.ahead, place.since.ahead),
                     first ? since.begun : std::max(since.begun, place.since.begun)};
      ++place.raised;
      open_.push_back(to);
    }
  }

  /// Under water on the last tick before another place.
  [[nodiscard]] double lastOf(size_t at) const {
    const StatePlace& place = places_[at];
    double last = std::min(sumOf(place.since.longest, place.stays), place.by);
    if (isState(at)) {
      last = std::min({last, latestByTimer(at, std::nullopt), endOfClimb(at)});
    }
    return last;
  }

  /// The latest time under water while a state only climbs.
  [[nodiscard]] double endOfClimb(size_t at) const {
    return sumOf(places_[at].since.begun, climbs_[stateAt(at)]);
  }

  /// What is known at the end of a way.
  [[nodiscard]] Submerged after(size_t at, const Way& way) const {
    const StatePlace& place = places_[at];
    const double from = way.surfaced_before ? 0 : place.since.longest;
    double longest = way.surfaced ? 0 : std::min(sumOf(from, way.added), place.by);
    if (isState(at)) {
      const double timed = latestByTimer(at, way.by);
      // In a loop that adds little each time, what the timer allows is soon all that counts.
      const bool slow = place.raised > kSlow && timed < kInfinity && !way.surfaced;
      longest = slow ? std::min(timed, place.by) : std::min(longest, timed);
      longest = std::min(longest, endOfClimb(at));
    }
    const double ahead = way.surfaced ? 0 : aheadIn(at);
    return {longest, way.sets_timer ? std::max(longest, ahead) : ahead,
            way.climbs_on ? std::min(longest, place.since.begun) : longest};
  }

  /// The timer's lead over the last tick at the surface while a place is current.
  [[nodiscard]] double aheadIn(size_t at) const {
    const StatePlace& place = places_[at];
    const bool raised = timer_ && isState(at) && timer_->set_under_water[stateAt(at)];
    return raised ? std::max(place.since.ahead, lastOf(at)) : place.since.ahead;
  }

  /// The longest time under water on the tick on which the case `by` leads away, or on any tick, as
  /// the timer's cases of the state allow: on the tick before, and on this one if they come first,
  /// they were not true.
  [[nodiscard]] double latestByTimer(size_t at, const std::optional<CaseAt>& by) const {
    const size_t state = stateAt(at);
    if (!timer_ || timer_->set_under_water[state]) {
      return kInfinity;
    }
    const Submerged& since = places_[at].since;
    const double gap = proof_context_.tick_gap_s;
    const double at_once = sumOf(since.longest, gap);  // on the first tick
    const auto bound = [&](const TimerCase& of, bool tried, bool may_be_first) {
      const double later = sumOf(of.longest, since.ahead);
      const double latest = tried ? later : sumOf(later, gap);
      return may_be_first || !tried ? std::max(latest, at_once) : latest;
    };
    const TimerCase& own = timer_->own[state];
    const TimerCase always = timerOfAlways(at);
    const bool again = where_.isAgain(at);  // then its own cases come first on the first tick
    return std::min(bound(own, by && !by->always && by->number > own.number, false),
                    bound(always, by && (!by->always || by->number > always.number),
                          again && by && !by->always));
  }

  [[nodiscard]] Submerged submergedAt(size_t at) const {
    const Submerged& since = places_[at].since;
    return {since.longest, since.longest < 0 ? since.ahead : aheadIn(at), since.begun};
  }

  void followFrom(size_t at) {
    if (isState(at)) {
      followState(at);
      return;
    }
    for (const size_t to : where_.goingOn(at)) {
      Way way{to};
      way.climbs_on = goesOn(to);
      places_[at].ways.push_back(way);
    }
  }

  [[nodiscard]] bool tells(BlockId block) const {
    bool found = false;
    forEachStatement(m_, block, [&](const Statement& s) { found = found || isVertical(s); });
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
        if (staysIn(c.transition) && tells(c.action)) {
          return false;
        }
      }
    }
    return true;
  }

  [[nodiscard]] double climbFrom(double depth) const {
    const platforms::EnvironmentModel& world = proof_context_.platform.world;
    return longestClimb(world, depth, world.surface_depth_m);
  }

  void followState(size_t at) {
    const bool again = where_.isAgain(at);
    const uint32_t number = stateAt(at);
    const State& state = m_.states[number];
    StatePlace& place = places_[at];
    Interruptions always = always_;
    always.own_first = again;
    const Leaving stay = stayOf(proof_context_, state, always, values_);
    work_ += stay.work;
    const double climb = climbs_[number];
    place.by = end_.by ? end_.left_by[number] : kGreatestNumber;
    place.stays = std::min({stay.by, climb, profiles_[number].longest});
    for (size_t i = 0; i < state.cases.size(); ++i) {
      leave(at, {false, i}, std::min(stay.latest[i], place.by), climb);
    }
    for (size_t i = 0; i < m_.always.size(); ++i) {
      if (where_.mayInterrupt(at, i) && stay.interrupted >= 0) {
        leave(at, {true, i}, std::min(stay.interrupted, place.by), climb);
      }
    }
  }

  /// The way of a case that does not fire later than `latest` after the state became current.
  void leave(size_t at, const CaseAt& by, double latest, double climb) {
    StatePlace& place = places_[at];
    const uint32_t state = stateAt(at);
    const bool again = where_.isAgain(at);
    const Case& c = by.always ? m_.always[by.number] : m_.states[state].cases[by.number];
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
    const bool sets_timer = timer_ && sets(m_, c.action, timer_->since);
    const auto to = where_.ledTo(at, by.always ? ListKind::Always : ListKind::State, by.number);
    if (!to) {
      return;
    }
    // A profile that surfaces by itself has done so if the case is not true before.
    const double by_profile = profiles_[state].longest;
    const bool surfaced_before =
        by_profile < under && !mayBeTrue({0, by_profile, false}, std::nullopt);
    const bool climbs_on = std::isfinite(climb) && !tells(c.action) && goesOn(*to);
    place.ways.push_back(
        {*to, surfaced, surfaced_before, std::min(under, by_profile), by, sets_timer, climbs_on});
  }

  /// Whether a climb to the surface goes on as a place becomes current: nothing else about depth is
  /// commanded (V4). What waits for a return commands nothing.
  [[nodiscard]] bool goesOn(size_t to) const {
    if (!isState(to)) {
      return true;
    }
    const State& state = m_.states[stateAt(to)];
    bool only_surface = true;
    for (const BlockId entry : {state.entry, state.route.entry, state.profile.entry}) {
      forEachStatement(m_, entry, [&](const Statement& s) {
        only_surface = only_surface && (!isVertical(s) || s.command == Command::Surface);
      });
    }
    return only_surface;
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
  std::optional<Timer> timer_;
  Valuation values_;
  Interruptions always_;
  std::vector<double> depths_;
  size_t count_;
  SurfacingPlaces where_;
  std::deque<StatePlace> places_;           ///< a deque: references to them stay valid as it grows
  std::vector<ProfileSurfacing> profiles_;  ///< of each state
  bool always_leads_down_ = false;
  std::vector<double> climbs_;  ///< of each state: from then on every tick is at the surface, s
  std::deque<size_t> open_;
  double longest_ = 0;
  size_t work_ = 0;
};

struct Found {
  double longest = kInfinity;
  Submersions submersions;
};

/// The least bound, without a timer or with one of the mission's; from its states, or from its
/// configurations if that gives less.
Found leastOf(const ProofContext& proof_context, const EndBound& end, double limit) {
  Found least;
  const auto attempt = [&](SurfacingSearch search) {
    const auto longest = search.run();
    if (longest && *longest < least.longest) {
      least = {*longest, search.submersions()};
    }
  };
  const Mission& m = proof_context.mission;
  SurfacingSearch plain(proof_context, end, limit, SurfacingPlaces::ofStates(m));
  plain.findProfiles();
  std::vector<Timer> timers = plain.timers();
  timers.resize(std::min(timers.size(), kMostTimers), Timer{});
  const auto attemptAll = [&] {
    attempt(plain);
    for (const Timer& timer : timers) {
      SurfacingSearch timed = plain;
      timed.use(timer);
      attempt(std::move(timed));
    }
  };
  attemptAll();
  plain.follow(SurfacingPlaces::ofConfigurations(m));
  attemptAll();
  return least;
}

}  // namespace

std::optional<double> longestSubmersion(const ProofContext& proof_context, const EndBound& end,
                                        double limit) {
  const double longest = leastOf(proof_context, end, limit).longest;
  return longest < kInfinity ? std::optional(longest) : std::nullopt;
}

std::vector<double> climbTimes(const ProofContext& proof_context) {
  const EndBound none;
  return SurfacingSearch(proof_context, none, kLongestMission,
                         SurfacingPlaces::ofStates(proof_context.mission))
      .climbs();
}

Submersion Submersions::of(certify::Configuration at) const {
  at.just_returned = false;
  const auto found = configurations.find(at);
  return found == configurations.end() ? states[at.state.index] : found->second;
}

Submersions submersionsOf(const ProofContext& proof_context, const EndBound& end) {
  return leastOf(proof_context, end, kLongestMission).submersions;
}

}  // namespace glider::ir::prove
