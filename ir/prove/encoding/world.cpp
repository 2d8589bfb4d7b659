// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/world.h"

#include "ir/prove/context/vehicle_rules.h"

#include <optional>

namespace glider::ir::prove {
namespace {

/// Of Z3's terms.
struct TermAlgebra {
  z3::context& context;

  [[nodiscard]] z3::expr number(double value) const { return realOf(context, value); }
  [[nodiscard]] z3::expr truth(bool value) const { return context.bool_val(value); }
  [[nodiscard]] z3::expr choose(const z3::expr& truth, const z3::expr& a, const z3::expr& b) const {
    return z3::ite(truth, a, b);
  }
};

/// V2 as a condition on the depth.
class LimitTerms {
 public:
  explicit LimitTerms(const z3::expr& depth) : depth_(depth) {}

  void atLeast(const z3::expr& limit) { add(depth_ >= limit); }
  void atMost(const z3::expr& limit) { add(depth_ <= limit); }
  void atMostIf(const z3::expr& truth, const z3::expr& limit) {
    add(z3::implies(truth, depth_ <= limit));
  }
  /// All of them.
  [[nodiscard]] const z3::expr& all() const { return *all_; }

 private:
  void add(const z3::expr& holds) { all_ = all_ ? *all_ && holds : holds; }

  z3::expr depth_;
  std::optional<z3::expr> all_;
};

/// V2 as the condition that the climb in force leads to `goal` or above.
class ClimbTerms {
 public:
  explicit ClimbTerms(const z3::expr& goal) : goal_(goal), reached_(goal.ctx().bool_val(false)) {}

  void atLeast(const z3::expr& /*limit*/) {}
  void atMost(const z3::expr& /*limit*/) {}
  void atMostIf(const z3::expr& truth, const z3::expr& limit) {
    reached_ = reached_ || (truth && limit <= goal_);
  }
  [[nodiscard]] const z3::expr& reached() const { return reached_; }

 private:
  z3::expr goal_;
  z3::expr reached_;
};

}  // namespace

Vehicle obey(const Vehicle& before, Command command, const std::vector<NumberTerm>& arguments,
             const z3::expr& now, const z3::expr& allowed, const platforms::Platform& platform,
             Unknowns& unknowns) {
  const TermAlgebra algebra{unknowns.context()};
  const auto target = [&] { return arguments.at(0).value; };
  Store yes;
  yes.vehicle = VehicleRules(algebra, platform).obey(before, command, target, now);
  if (!yes.vehicle) {
    return before;
  }
  Store no;
  no.vehicle = before;
  return *choose(allowed, yes, no).vehicle;
}

Vehicle obeyAnything(const Vehicle& before, Unknowns& unknowns) {
  Vehicle after = before;
  after.deepest = unknowns.real("deepest");
  after.climbing = unknowns.truth("climbing");
  after.since = unknowns.real("since");
  after.top = unknowns.real("top");
  unknowns.require(after.deepest >= before.depth);
  return after;
}

z3::expr moves(const Vehicle& before, const z3::expr& from, const z3::expr& to,
               const z3::expr& depth, const platforms::Platform& platform) {
  const TermAlgebra algebra{from.ctx()};
  LimitTerms limits(depth);
  VehicleRules(algebra, platform).move(before, from, to, limits);
  return limits.all();
}

z3::expr hasClimbedTo(const Vehicle& before, const z3::expr& to, const z3::expr& limit,
                      const platforms::Platform& platform) {
  const TermAlgebra algebra{to.ctx()};
  ClimbTerms climb(limit);
  VehicleRules(algebra, platform).move(before, to, to, climb);
  return climb.reached();
}

z3::expr begins(const Vehicle& vehicle, const platforms::Platform& platform) {
  const TermAlgebra algebra{vehicle.depth.ctx()};
  return vehicle.depth >= 0 && vehicle.depth <= algebra.number(platform.world.start_depth_m) &&
         vehicle.deepest == VehicleRules(algebra, platform).deepestAtStart(vehicle.depth) &&
         !vehicle.climbing && vehicle.since == 0 && vehicle.top == 0;
}

}  // namespace glider::ir::prove
