// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The passes `assumptions` (GL3121) and `contradictions` (GL3123): conditions that no readings
// satisfy together. In: the assumptions or the requirements about a single moment. Out: an error,
// and no verdict rests on such assumptions (requirements.cpp). Each question is about any moment
// (AnyMoment), which may be more than flights reach: what it finds is certain, and some
// contradictions are missed. Conditions with a monitor are left out, because readings that never
// change satisfy each of them. They come first, because everything could be proved from assumptions
// that contradict each other.

#include "ir/core/mission_writer.h"
#include "ir/core/walk.h"
#include "ir/prove/encoding/any_moment.h"
#include "ir/prove/passes.h"
#include "ir/verify/intervals.h"
#include "ir/verify/value_text.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace glider::ir::prove {
namespace {

using support::DiagnosticId;

/// False, and reported, if no reading of the vehicle is in an assumed range.
bool rangesOverlap(const Proof& proof, const Mission& mission) {
  bool right = true;
  for (const Assumption& a : mission.assumptions) {
    if (a.kind != AssumptionKind::Range) {
      continue;
    }
    const Sensor& narrowed = mission[a.sensor];
    if (narrowed.lowest > narrowed.highest) {
      const Sensor& vehicle = proof.proof_context.mission[a.sensor];
      proof.diagnostics.report(
          support::diagnostics::assumptionsContradict, a.range,
          fmt::format("no known reading of `{}`, which lies in {} to {}, is in all the ranges that "
                      "are assumed",
                      vehicle.name, withUnit(vehicle.lowest * vehicle.to_si, vehicle.type),
                      withUnit(vehicle.highest * vehicle.to_si, vehicle.type)));
      right = false;
    }
  }
  return right;
}

/// A condition, and where it is written.
struct StatedCondition {
  ExprId condition;
  support::SourceRange range;
};

/// Adds expressions about several conditions to a mission.
class Conjunction {
 public:
  Conjunction(Mission& mission, const std::vector<StatedCondition>& all)
      : m_(mission), write_(mission), all_(all) {}

  /// That not all are true. Where the mission assumes or requires that something is known, or is
  /// not: that one is false, as without a reading few conditions are.
  ExprId contradiction() {
    ExprId together = all_.front().condition;
    for (const StatedCondition& one : all_) {
      together = write_.both(together, one.condition);
    }
    const ExprId broken = write_.negation(together);
    return asksWhatIsKnown() ? write_.both(isKnown(broken), broken) : broken;
  }

  [[nodiscard]] bool asksWhatIsKnown() const {
    const auto asks = [&](ExprId id) {
      return anyIn(m_, id, [](const Expr& e) { return e.op == Op::Known; });
    };
    return std::ranges::any_of(all_, asks, &StatedCondition::condition) ||
           std::ranges::any_of(m_.assumptions, [&](const Assumption& assumption) {
             return assumption.watch.condition.valid() && asks(assumption.watch.condition);
           });
  }

 private:
  /// Only numbers are asked whether they are known.
  ExprId isKnown(ExprId truth) {
    const ExprId any = write_.number(0, plainNumber());
    const ExprId chosen = write_.operation(Op::Select, plainNumber(), {truth, any, any});
    return write_.operation(Op::Known, boolean(), {chosen});
  }

  const Mission& m_;
  MissionWriter write_;
  const std::vector<StatedCondition>& all_;
};

/// When conditions must be true together.
struct ComparedMoment {
  StateBounds bounds;
  std::string words;  ///< before "no readings"
};

ComparedMoment atAnyTime() {
  return {{0, kGreatestNumber, kGreatestNumber, kGreatestNumber, kGreatestNumber}, ""};
}

/// Every flight has this moment.
ComparedMoment atTheStart(const platforms::Platform& platform) {
  const double deepest = platform.world.start_depth_m;
  return {
      {0, 0, 0, 0, deepest},
      fmt::format("at the start, at mission time 0 s and a depth of at most {:g} m, ", deepest)};
}

/// Reports if no readings satisfy all conditions then; false if so. `compared` may have fewer
/// readings than the one that is checked.
bool compare(Proof& proof, const Mission& compared, const std::vector<StatedCondition>& all,
             const ComparedMoment& when, DiagnosticId id) {
  if (all.empty()) {
    return true;
  }
  Mission mission = compared;
  Conjunction together(mission, all);
  const ExprId contradiction = together.contradiction();
  const ProofContext proof_context(mission, proof.proof_context.platform);
  const std::vector<StateBounds> bounds(mission.states.size(), when.bounds);
  if (!AnyMoment(proof_context, bounds)
           .neverFalse(contradiction, proof.options.effort, proof.checks)) {
    return true;
  }
  auto error = proof.diagnostics.report(id, all.back().range,
                                        fmt::format("{}no {}readings satisfy {}", when.words,
                                                    together.asksWhatIsKnown() ? "" : "known ",
                                                    all.size() == 1 ? "this one" : "them all"));
  for (size_t i = 0; i + 1 < all.size(); ++i) {
    error.note(all[i].range, "together with this");
  }
  return false;
}

/// Reports an area of the start whose corners are on a line: no place is inside.
void checkStart(const Proof& proof, const Assumption& assumption) {
  if (assumption.kind != AssumptionKind::StartInside) {
    return;
  }
  const std::vector<Position>& corners = assumption.area.corners;
  const Position& first = corners.front();
  /// Twice the area between the first corner and these, in square degrees.
  const auto between = [&](const Position& a, const Position& b) {
    const auto east = [&](const Position& of) {
      return std::remainder(of.longitude - first.longitude, 360);
    };
    return (a.latitude - first.latitude) * east(b) - (b.latitude - first.latitude) * east(a);
  };
  constexpr double kRounding = 1e-12;  // square degrees: a square of 10 cm
  const bool on_a_line = std::ranges::all_of(corners, [&](const Position& a) {
    return std::ranges::all_of(
        corners, [&](const Position& b) { return std::fabs(between(a, b)) <= kRounding; });
  });
  if (on_a_line) {
    proof.diagnostics.report(support::diagnostics::assumptionsContradict, assumption.range,
                             "no place is inside this area, whose corners are on a line");
  }
}

/// It is about a single moment: those with a monitor are satisfied by readings that never change.
bool isMomentary(const Requirement& requirement) {
  return requirement.condition.valid() && !requirement.monitor.step.valid();
}

}  // namespace

void passes::assumptions(Proof& proof) {
  const Mission& written = proof.proof_context.mission;
  const auto& [mission, platform] = proof.worlds.assumed;
  std::vector<StatedCondition> assumed;
  for (const Assumption& a : written.assumptions) {
    checkStart(proof, a);
    if (isMomentary(a.watch)) {
      assumed.push_back({a.watch.condition, a.range});
    }
  }
  if (!rangesOverlap(proof, mission)) {
    return;
  }
  for (const ComparedMoment& when : {atAnyTime(), atTheStart(platform)}) {
    if (!compare(proof, mission, assumed, when, support::diagnostics::assumptionsContradict)) {
      return;
    }
  }
}

void passes::contradictions(Proof& proof) {
  std::vector<StatedCondition> required;
  for (const Requirement& r : proof.proof_context.mission.requirements) {
    if (isMomentary(r)) {
      required.push_back({r.condition, r.range});
    }
  }
  if (required.size() > 1) {
    compare(proof, proof.proof_context.mission, required, atAnyTime(),
            support::diagnostics::requirementsContradict);
  }
}

}  // namespace glider::ir::prove
