// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_proofs/requirements.h"

#include "ir/core/validate.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/abstract/surfacing.h"
#include "ir/prove/context/requirement_monitor.h"
#include "ir/text/print.h"
#include "ir/text/read.h"
#include "ir/verify/verify.h"
#include "support/check.h"
#include "tests/random_proofs/areas.h"
#include "tests/random_proofs/assumptions.h"
#include "tests/random_proofs/patterns.h"
#include "tests/random_proofs/varied.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace glider::random_proofs {
namespace {

using ir::Requirement;
using ir::RequirementKind;

Bounds boundsOf(const ir::Mission& mission, const platforms::Platform& platform, uint64_t seed) {
  const ir::prove::ProofContext context(mission, platform);
  Bounds bounds;
  bounds.scouted = scout(context, seed);
  ir::prove::Ending ending(context);
  bounds.ends_by = ending.bound().by;
  const double deepest = std::ranges::max(ir::prove::deepestByState(context));
  bounds.deepest = std::isfinite(deepest) ? std::optional(deepest) : std::nullopt;
  bounds.submersion =
      ir::prove::longestSubmersion(context, ending.bound(), ir::prove::kLongestMission);
  bounds.tick_gap_s = context.tick_gap_s;
  const std::vector<double> climbs = ir::prove::climbTimes(context);
  for (uint32_t i = 0; i < climbs.size(); ++i) {
    if (std::isfinite(climbs[i])) {
      bounds.climbs.emplace(i, climbs[i]);
    }
  }
  bounds.track = trackOf(context, ending);
  return bounds;
}

/// The same mission as read from its text: each expression has its own place there, which
/// diagnostics name.
ir::Mission written(const ir::Mission& mission) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  auto read = ir::read(sources, sources.add("random", ir::print(mission)), diagnostics);
  CHECK(read.has_value(), "a mission with requirements cannot be read");
  return *std::move(read);
}

/// Adds candidates to a mission, each from a seed of its own: the same in any company.
class Maker {
 public:
  /// `bounds` outlives this.
  Maker(ir::Mission mission, const Bounds& bounds, uint64_t seed)
      : random_(seed),
        seed_(seed),
        bounds_(bounds),
        made_{std::move(mission), {}},
        conditions_(made_.mission, bounds_, random_) {
    support::DiagnosticEngine unheard;
    stack_ = ir::verify(made_.mission, unheard).stack_depth;
  }

  [[nodiscard]] static uint32_t candidates() {
    return kFirstPattern + static_cast<uint32_t>(patterns().size());
  }

  void add(uint32_t candidate) {
    random_ = random_missions::Random(seed_ * 2 * candidates() + candidate);
    switch (candidate) {
      case 0:
      case 1:
        return exitWithin();
      case 2:
        return reach();
      case 3:
        return neverAfter();
      case 4:
        return stack();
      case 5:
        return surfaces();
      case 6:
        return area();
      case 7:
        return neverAgain();
      default:
        return candidate < kFirstPattern ? always() : pattern(candidate - kFirstPattern);
    }
  }

  Required finished() {
    random_ = random_missions::Random(seed_ * 2 * candidates() + candidates());
    if (random_.chance(0.4)) {
      addAssumptions(made_.mission, conditions_, random_);
    }
    for (const ir::Defect& defect : ir::validate(made_.mission)) {
      fmt::print(stderr, "{}\n", defect.message);
    }
    CHECK(ir::validate(made_.mission).empty(), "a mission with requirements is not valid");
    made_.mission = written(made_.mission);
    return std::move(made_);
  }

  [[nodiscard]] const ir::Mission& mission() const { return made_.mission; }

 private:
  void add(Requirement requirement, std::string kind) {
    made_.mission.requirements.push_back(std::move(requirement));
    made_.kinds.push_back(std::move(kind));
  }

  static Requirement begun(RequirementKind kind) {
    Requirement r;
    r.kind = kind;
    return r;
  }

  void exitWithin() {
    Requirement r = begun(RequirementKind::ExitWithin);
    const bool bounded = bounds_.ends_by && random_.chance(0.6);
    r.seconds =
        std::max(1.0, conditions_.near(bounded ? *bounds_.ends_by : bounds_.scouted.latest));
    add(std::move(r), "exit within");
  }

  void always() {
    Requirement r = begun(RequirementKind::Always);
    r.condition = conditions_.any();
    add(std::move(r), "always");
  }

  void stack() {
    Requirement r = begun(RequirementKind::StackAtMost);
    r.depth = stack_ > 0 && random_.chance(0.3) ? stack_ - 1 : stack_;
    add(std::move(r), "stack");
  }

  [[nodiscard]] uint32_t anyState() { return random_.below(made_.mission.states.size()); }

  /// Mostly of a state that was not seen: that no flight enters it can be watched.
  void reach() {
    Requirement r = begun(RequirementKind::Reach);
    r.state = {anyState()};
    for (int i = 0; i < 4 && bounds_.scouted.entered.contains(r.state.index); ++i) {
      r.state = {anyState()};
    }
    add(std::move(r), "reach");
  }

  void neverAfter() {
    Requirement r = begun(RequirementKind::NeverAfter);
    for (int i = 0; i < 4; ++i) {
      r.state = {anyState()};
      r.after = {anyState()};
      if (!bounds_.scouted.orders.contains({r.state.index, r.after.index})) {
        break;
      }
    }
    add(std::move(r), "never after");
  }

  /// Of two states that were entered: a proof has to see every way between them.
  void neverAgain() {
    Requirement r = begun(RequirementKind::NeverAfter);
    r.state = {random_.pick(entered())};
    r.after = {random_.pick(entered())};
    for (int i = 0; i < 4 && random_.chance(0.7) && !returns(r.after); ++i) {
      r.after = {random_.pick(entered())};
    }
    add(std::move(r), "never after");
  }

  [[nodiscard]] bool returns(ir::StateId state) const {
    return std::ranges::find(made_.mission[state].cases, ir::Transition::Return,
                             &ir::Case::transition) != made_.mission[state].cases.end();
  }

  [[nodiscard]] std::vector<uint32_t> entered() const {
    return {bounds_.scouted.entered.begin(), bounds_.scouted.entered.end()};
  }

  void surfaces() {
    Requirement r = begun(RequirementKind::SurfacesEvery);
    const bool bounded = bounds_.submersion && random_.chance(0.6);
    r.seconds =
        std::max(1.0, conditions_.near(bounded ? *bounds_.submersion : bounds_.scouted.below));
    add(std::move(r), "surfaces every");
  }

  /// Or a condition, if there is no area.
  void area() {
    Requirement r = begun(RequirementKind::Always);
    if (!bounds_.track || random_.chance(0.2)) {
      return always();
    }
    const bool disc = random_.chance(0.4);
    const auto write = disc ? writeDisc : writeArea;
    if (!write(made_.mission, r, *bounds_.track, conditions_, random_)) {
      return always();
    }
    add(std::move(r), disc ? "disc" : "area");
  }

  void pattern(uint32_t number) {
    Requirement r = begun(RequirementKind::Always);
    writePattern(number, made_.mission, r, conditions_, random_);
    add(std::move(r), patterns()[number]);
  }

  static constexpr uint32_t kFirstPattern = 11;

  random_missions::Random random_;
  uint64_t seed_;
  const Bounds& bounds_;
  Required made_;
  Conditions conditions_;
  uint32_t stack_ = 0;
};

/// The requirements that are violated (Reach: satisfied) in the flights that were scouted.
std::set<size_t> brokenOf(const ir::Mission& mission, const platforms::Platform& platform,
                          uint64_t seed) {
  const ir::prove::ProofContext context(mission, platform);
  std::set<size_t> broken;
  std::vector<ir::RequirementMonitor> monitors;
  const auto begin = [&](const containment::Flight&) {
    monitors.clear();
    for (const Requirement& r : mission.requirements) {
      monitors.emplace_back(mission, r, platform.world.surface_depth_m, context.depth);
    }
  };
  scoutingFlights(context, seed, begin, [&](const containment::Flight& flight) {
    const containment::Tick& now = flight.now();
    for (size_t i = 0; i < monitors.size(); ++i) {
      monitors[i].tick(flight.interpreter(), now.time, now.result, now.depth);
      // An area needs a flight whose readings are those of its place.
      if (monitors[i].when() && mission.requirements[i].geofences.empty()) {
        broken.insert(i);
      }
    }
  });
  return broken;
}

template <typename T>
void shuffle(std::vector<T>& all, random_missions::Random& random) {
  for (size_t i = all.size(); i > 1; --i) {
    std::swap(all[i - 1], all[random.below(i)]);
  }
}

/// The candidates to be checked: several that the scouted flights do not break, in any order, as
/// what comes first has more of the effort; then some that they do break, with what is left of it.
std::vector<uint32_t> chosen(const std::set<size_t>& broken, uint32_t candidates, uint64_t seed) {
  constexpr size_t kMostKept = 6;
  constexpr size_t kMostBroken = 4;
  random_missions::Random random(seed);
  std::vector<uint32_t> kept;
  std::vector<uint32_t> others;
  for (uint32_t i = 0; i < candidates; ++i) {
    (broken.contains(i) ? others : kept).push_back(i);
  }
  shuffle(kept, random);
  shuffle(others, random);
  kept.resize(std::min(kept.size(), kMostKept));
  others.resize(std::min(others.size(), kMostBroken));
  kept.insert(kept.end(), others.begin(), others.end());
  return kept;
}

}  // namespace

Required withRequirements(const ir::Mission& without, const platforms::Platform& platform,
                          uint64_t seed) {
  const ir::Mission mission = varied(without, platform, seed);
  const Bounds bounds = boundsOf(mission, platform, seed);
  Maker tried(mission, bounds, seed);
  for (uint32_t i = 0; i < Maker::candidates(); ++i) {
    tried.add(i);
  }
  Maker maker(mission, bounds, seed);
  for (const uint32_t i :
       chosen(brokenOf(tried.mission(), platform, seed), Maker::candidates(), seed)) {
    maker.add(i);
  }
  return maker.finished();
}

}  // namespace glider::random_proofs
