// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/profile_surfacing.h"

#include "ir/core/walk.h"
#include "ir/prove/abstract/mode_ways.h"
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
    if (state_.profile.cases.empty() || !std::isfinite(climb_s_) || othersInterfere(m_, id_)) {
      return best;
    }
    const std::vector<VariableId> timers = timersOfProfile(m_, guards_, id_);
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
  /// Whether every case that begins a climb sets it.
  [[nodiscard]] bool isSetByEachClimb(VariableId id) const {
    const auto keeps = [&](const Mode& from, const ModeWay& way) {
      const BlockId action = state_.profile.cases[way.by].action;
      const bool begins = climbs(way.to) && !(climbs(from) && goesOn(m_, action));
      return !begins || setsForSure(m_, action, id);
    };
    return std::ranges::all_of(ways_.all(), [&](const auto& entry) {
      return std::ranges::all_of(entry.second,
                                 [&](const ModeWay& way) { return keeps(entry.first, way); });
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
