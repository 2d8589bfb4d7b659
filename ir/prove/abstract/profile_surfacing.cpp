// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/profile_surfacing.h"

#include "ir/core/walk.h"
#include "ir/prove/context/commands.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace glider::ir::prove {
namespace {

constexpr double kNeverSurfaces = std::numeric_limits<double>::infinity();
/// A mode that is raised more often is in a loop without a surfacing.
constexpr unsigned kMostRaises = 100;

double roundedSum(double a, double b) {
  return b == 0 ? a : std::nextafter(a + b, kNeverSurfaces);
}

/// A way from a mode to one of those that a case's `do` leads to.
struct ModeWay {
  Mode to;
  size_t by = 0;  ///< the case
};

/// The modes of a profile, and the ways between them.
class ModeWays {
 public:
  ModeWays(const ProofContext& proof_context, const Activity& profile)
      : known_(proof_context.known),
        profile_(profile),
        modes_(proof_context.mission, profile, &proof_context.known) {}

  /// False if there are too many, or one of their truth values may be unknown, or is set by `done`.
  bool explore() {
    const bool plain = std::ranges::all_of(modes_.own(), [&](VariableId id) {
      return known_.variables[id.index] && id != profile_.done;
    });
    if (!plain || modes_.own().size() > ProfileModes::kMostTruths) {
      return false;
    }
    std::vector<Mode> open;
    const auto arrive = [&](const std::set<Mode>& modes) {
      for (const Mode& mode : modes) {
        if (ways_.try_emplace(mode).second) {
          open.push_back(mode);
        }
      }
    };
    arrive(modes_.begin());
    while (!open.empty()) {
      const Mode mode = open.back();
      open.pop_back();
      arrive(modes_.run(profile_.entry, {Mode{mode.truths, std::nullopt}}));  // resumed
      for (size_t i = 0; i < profile_.cases.size(); ++i) {
        const Truth guard = modes_.judge(profile_.cases[i].guard, mode);
        if (guard == Truth::False) {
          continue;
        }
        const std::set<Mode> after = modes_.run(profile_.cases[i].action, {mode});
        for (const Mode& to : after) {
          ways_[mode].push_back({to, i});
        }
        arrive(after);
        if (guard == Truth::True) {
          break;  // it hides the rest
        }
      }
    }
    return true;
  }

  [[nodiscard]] const ProfileModes& modes() const { return modes_; }
  [[nodiscard]] const std::map<Mode, std::vector<ModeWay>>& all() const { return ways_; }

 private:
  const GreatestFixpoint& known_;
  const Activity& profile_;
  ProfileModes modes_;
  std::map<Mode, std::vector<ModeWay>> ways_;
};

bool climbs(const Mode& mode) {
  return mode.command == Command::Surface;
}

/// Whether a climb to the surface goes on through these statements: another command about depth
/// would end it, and the next `surface()` begin a new one (V3, V4).
bool goesOn(const Mission& mission, BlockId action) {
  bool only_surface = true;
  forEachStatement(mission, action, [&](const Statement& s) {
    only_surface = only_surface && (!isVertical(s) || s.command == Command::Surface);
  });
  return only_surface;
}

/// The longest way through the modes, by one timer.
class ModeSearch {
 public:
  ModeSearch(const ProofContext& proof_context, const TimerGuards& guards, const Activity& profile,
             const ModeWays& ways, VariableId since, const std::vector<VariableId>& waits,
             double climb_s)
      : m_(proof_context.mission),
        gap_(proof_context.tick_gap_s),
        guards_(guards),
        profile_(profile),
        ways_(ways),
        since_(since),
        waits_(waits),
        climb_s_(climb_s) {}

  /// The longest time; infinite if there is none.
  double run() {
    for (const auto& [mode, ways] : ways_.all()) {
      raise({mode, true}, {0, 0});
    }
    double longest = 0;
    while (!open_.empty()) {
      const Place at = open_.back();
      open_.pop_back();
      const double last = lastOf(at);
      longest = std::max(longest, last);
      if (longest == kNeverSurfaces || found_[at].raised > kMostRaises) {
        return kNeverSurfaces;
      }
      for (const ModeWay& way : ways_.all().at(at.mode)) {
        follow(at, way);
      }
    }
    return longest;
  }

  [[nodiscard]] std::vector<ModeBound> bounds() const {
    std::vector<ModeBound> all;
    for (const auto& [place, found] : found_) {
      all.push_back({place.mode, place.from_start, found.since.longest, found.since.ahead,
                     climbs(place.mode) ? 0 : timedIn(place.mode).longest});
    }
    return all;
  }

 private:
  struct Place {
    Mode mode;
    bool from_start = false;
    auto operator<=>(const Place&) const = default;
  };
  struct Reached {
    Submerged since;
    unsigned raised = 0;
  };

  void raise(const Place& to, const Submerged& since) {
    Reached& found = found_[to];
    if (since.longest > found.since.longest || since.ahead > found.since.ahead) {
      found = {
          {std::max(since.longest, found.since.longest), std::max(since.ahead, found.since.ahead)},
          found.raised + 1};
      open_.push_back(to);
    }
  }

  /// Under water on the last tick in this mode.
  [[nodiscard]] double lastOf(const Place& at) const {
    const Submerged& found = found_.at(at).since;
    if (climbs(at.mode)) {
      return roundedSum(found.longest, climb_s_);
    }
    const TimerCase timed = timedIn(at.mode);
    return std::max(roundedSum(roundedSum(timed.longest, found.ahead), gap_),
                    roundedSum(found.longest, gap_));
  }

  void follow(const Place& at, const ModeWay& way) {
    const Submerged& found = found_.at(at).since;
    const bool sets_timer = sets(m_, profile_.cases[way.by].action, since_);
    const double last = lastOf(at);
    if (!climbs(at.mode)) {
      const TimerCase timed = timedIn(at.mode);
      const double here = way.by > timed.number ? roundedSum(timed.longest, found.ahead) : last;
      raise({way.to, false}, {here, sets_timer ? std::max(here, found.ahead) : found.ahead});
    } else if (climbs(way.to) && goesOn(m_, profile_.cases[way.by].action)) {
      raise({way.to, at.from_start},
            {found.longest, sets_timer ? std::max(last, found.ahead) : found.ahead});
    } else if (!at.from_start && waitsForSurface(way.by)) {
      raise({way.to, false}, {0, 0});
    } else {
      raise({way.to, false}, {last, sets_timer ? std::max(last, found.ahead) : found.ahead});
    }
  }

  /// The first case of a mode that is certainly true some time after the timer was set. (A case
  /// before it that stays in the mode is a way of its own, and one that may be taken again and
  /// again.)
  [[nodiscard]] TimerCase timedIn(const Mode& mode) const {
    const auto certain = [&](ExprId id) { return ways_.modes().judge(id, mode) == Truth::True; };
    for (size_t i = 0; i < profile_.cases.size(); ++i) {
      const double longest = guards_.trueAfter(profile_.cases[i].guard, since_, certain);
      if (longest < kNeverSurfaces) {
        return {i, longest};
      }
    }
    return {};
  }

  /// Whether the case is not true before the climb that began when a variable of `waits_` was set
  /// is over.
  [[nodiscard]] bool waitsForSurface(size_t by) const {
    return std::ranges::any_of(waits_, [&](VariableId id) {
      return guards_.onlyAfter(profile_.cases[by].guard, id) >= climb_s_;
    });
  }

  const Mission& m_;
  double gap_;
  const TimerGuards& guards_;
  const Activity& profile_;
  const ModeWays& ways_;
  VariableId since_;
  const std::vector<VariableId>& waits_;
  double climb_s_;
  std::map<Place, Reached> found_;
  std::vector<Place> open_;
};

class ProfileSearch {
 public:
  ProfileSearch(const ProofContext& proof_context, const TimerGuards& guards, StateId state,
                double climb_s)
      : proof_context_(proof_context),
        m_(proof_context.mission),
        guards_(guards),
        id_(state),
        state_(m_[state]),
        climb_s_(climb_s),
        ways_(proof_context, state_.profile) {}

  ProfileSurfacing run() {
    ProfileSurfacing best;
    if (state_.profile.cases.empty() || !std::isfinite(climb_s_) || othersInterfere()) {
      return best;
    }
    const std::vector<VariableId> timers = timersOfProfile();
    if (timers.empty() || !ways_.explore()) {
      return best;
    }
    std::vector<VariableId> waits;
    std::ranges::copy_if(timers, std::back_inserter(waits),
                         [&](VariableId id) { return isSetByEachClimb(id); });
    for (const VariableId since : timers) {
      ModeSearch search(proof_context_, guards_, state_.profile, ways_, since, waits, climb_s_);
      const double longest = search.run();
      if (longest < best.longest) {
        best = {longest, since, waits, ways_.modes().own(), climb_s_, search.bounds()};
      }
    }
    return best;
  }

 private:
  [[nodiscard]] bool isOfProfile(VariableId id) const {
    return m_[id].kind == VariableKind::Profile && m_[id].owner == id_;
  }

  /// Whether anything else commands a depth while the state is current, or sets what the profile
  /// remembers.
  [[nodiscard]] bool othersInterfere() const {
    bool found =
        !m_[state_.profile.behaviour].symbol.empty() || !m_[state_.route.behaviour].symbol.empty();
    const auto commands = [&](const Statement& s) { found = found || isVertical(s); };
    const auto remembers = [&](const Statement& s) {
      found = found || (s.kind == StatementKind::Set && isOfProfile(s.variable));
    };
    forEachStatement(m_, state_.route.entry, commands);
    for (const BlockId block : {m_.every_tick, state_.entry, state_.route.entry}) {
      forEachStatement(m_, block, remembers);
    }
    for (const auto* cases : {&m_.always, &state_.cases, &state_.route.cases}) {
      for (const Case& c : *cases) {
        forEachStatement(m_, c.action, remembers);
        if (staysIn(c.transition)) {
          forEachStatement(m_, c.action, commands);
        }
      }
    }
    return found;
  }

  /// Variables of the profile that hold a time of the mission: never unknown, never in the future.
  [[nodiscard]] std::vector<VariableId> timersOfProfile() const {
    std::vector<VariableId> found;
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      const Variable& variable = m_.variables[i];
      if (isOfProfile({i}) && variable.type.kind == TypeKind::Quantity &&
          !std::isfinite(variable.lowest) && !std::isfinite(variable.highest) &&
          beginsAsTime(m_[variable.initial]) && guards_.holdsTimesOnly({i})) {
        found.push_back({i});
      }
    }
    return found;
  }

  static bool beginsAsTime(const Expr& initial) {
    return initial.op == Op::MissionTime || (initial.op == Op::Constant && initial.number <= 0);
  }

  /// Whether every case that begins a climb sets it.
  [[nodiscard]] bool isSetByEachClimb(VariableId id) const {
    const auto keeps = [&](const Mode& from, const ModeWay& way) {
      const BlockId action = state_.profile.cases[way.by].action;
      const bool begins = climbs(way.to) && !(climbs(from) && goesOn(m_, action));
      return !begins || setsForSure(action, id);
    };
    return std::ranges::all_of(ways_.all(), [&](const auto& entry) {
      return std::ranges::all_of(entry.second,
                                 [&](const ModeWay& way) { return keeps(entry.first, way); });
    });
  }

  [[nodiscard]] bool setsForSure(BlockId block, VariableId id) const {
    return block.valid() && std::ranges::any_of(m_[block].statements, [&](const Statement& s) {
             return s.kind == StatementKind::Set && s.variable == id;
           });
  }

  const ProofContext& proof_context_;
  const Mission& m_;
  const TimerGuards& guards_;
  StateId id_;
  const State& state_;
  double climb_s_;
  ModeWays ways_;
};

}  // namespace

ProfileSurfacing profileSurfacing(const ProofContext& proof_context, const TimerGuards& guards,
                                  StateId state, double climb_s) {
  return ProfileSearch(proof_context, guards, state, climb_s).run();
}

}  // namespace glider::ir::prove
