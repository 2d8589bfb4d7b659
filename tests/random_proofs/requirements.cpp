// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_proofs/requirements.h"

#include "ir/core/validate.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/abstract/surfacing.h"
#include "ir/text/print.h"
#include "ir/text/read.h"
#include "ir/verify/verify.h"
#include "support/check.h"
#include "tests/random_proofs/assumptions.h"
#include "tests/random_proofs/patterns.h"

#include <algorithm>
#include <cmath>
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

class Maker {
 public:
  Maker(ir::Mission mission, const platforms::Platform& platform, uint64_t seed)
      : random_(seed),
        bounds_(boundsOf(mission, platform, seed)),
        made_{std::move(mission), {}},
        conditions_(made_.mission, bounds_, random_) {
    support::DiagnosticEngine unheard;
    stack_ = ir::verify(made_.mission, unheard).stack_depth;
  }

  Required run() {
    exitWithin();
    always();
    random_.chance(0.5) ? always() : exitWithin();
    random_.chance(0.5) ? reach() : neverAfter();
    random_.chance(0.5) ? stack() : surfaces();
    pattern();
    if (random_.chance(0.5)) {
      pattern();
    }
    if (random_.chance(0.4)) {
      addAssumptions(made_.mission, conditions_, random_);
    }
    CHECK(ir::validate(made_.mission).empty(), "a mission with requirements is not valid");
    made_.mission = written(made_.mission);
    return std::move(made_);
  }

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

  void surfaces() {
    Requirement r = begun(RequirementKind::SurfacesEvery);
    const bool bounded = bounds_.submersion && random_.chance(0.6);
    r.seconds =
        std::max(1.0, conditions_.near(bounded ? *bounds_.submersion : bounds_.scouted.below));
    add(std::move(r), "surfaces every");
  }

  void pattern() {
    Requirement r = begun(RequirementKind::Always);
    const std::string kind = writePattern(made_.mission, r, conditions_, random_);
    add(std::move(r), kind);
  }

  random_missions::Random random_;
  Bounds bounds_;
  Required made_;
  Conditions conditions_;
  uint32_t stack_ = 0;
};

}  // namespace

Required withRequirements(const ir::Mission& mission, const platforms::Platform& platform,
                          uint64_t seed) {
  return Maker(mission, platform, seed).run();
}

}  // namespace glider::random_proofs
