// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the prover says about commands, depths and waypoints, against random flights.

#include "ir/eval/arithmetic.h"
#include "ir/prove/abstract/depth_bound.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/shallowest_command.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/abstract/surfacing.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/context/requirement_monitor.h"
#include "ir/prove/geometry/steering.h"
#include "tests/containment/rule.h"

#include <algorithm>
#include <cmath>

namespace glider::containment {
namespace {

using namespace ir;
using namespace ir::prove;

class Deepest : public Rule {
 public:
  explicit Deepest(const ProofContext& context) : deepest_(deepestByState(context)) {}
  void tick(const Flight& flight) override {
    const double bound = deepest_[flight.now().result.state.index];
    steps += std::isfinite(bound) ? 1U : 0U;
    EXPECT_LE(flight.now().depth, bound);
  }

 private:
  std::vector<double> deepest_;
};

TEST(Containment, DeepestByState) {
  holds<Deepest>();
}

/// Conditions that the commands alone keep, at the true depth.
class HeldByCommands : public Rule {
 public:
  explicit HeldByCommands(const ProofContext& context) : context_(context) {
    const double deepest = std::ranges::max(deepestByState(context));
    for (uint32_t i = 0; i < context.mission.exprs.size(); ++i) {
      const Expr& e = context.mission.exprs[i];
      const auto isDepth = [&](ExprId id) {
        return id.valid() && context.mission[id].op == Op::Sensor &&
               context.mission[id].sensor == context.depth;
      };
      const auto isConstant = [&](ExprId id) { return context.mission[id].op == Op::Constant; };
      if (isComparison(e.op) &&
          ((isDepth(e.operands[0]) && isConstant(e.operands[1])) ||
           (isDepth(e.operands[1]) && isConstant(e.operands[0]))) &&
          heldByCommands({i}, context, deepest)) {
        conditions_.push_back({i});
      }
    }
  }
  void tick(const Flight& flight) override {
    for (const ExprId id : conditions_) {
      ++steps;
      const Expr& e = context_.mission[id];
      const auto side = [&](ExprId of) {
        const Expr& x = context_.mission[of];
        return x.op == Op::Constant ? x.number : flight.now().depth;
      };
      EXPECT_NE(compare(e.op, side(e.operands[0]), side(e.operands[1])), Truth::False);
    }
  }

 private:
  const ProofContext& context_;
  std::vector<ExprId> conditions_;
};

TEST(Containment, HeldByCommands) {
  holds<HeldByCommands>();
}

/// Calls `check` with each command that took effect.
template <typename Check>
void forEachCommand(const Flight& flight, Check check) {
  for (const Action& action : flight.now().result.actions) {
    if (const auto* command = std::get_if<CommandRun>(&action); command && !command->refused) {
      check(*command);
    }
  }
}

class Shallowest : public Rule {
 public:
  explicit Shallowest(const ProofContext& context) : context_(context), shallowest_(context) {}
  void start(const Flight& flight) override { check(flight); }
  /// The commands of a tick that moves belong to two states, and say nothing about either.
  void tick(const Flight& flight) override {
    if (!flight.now().result.moved) {
      check(flight);
    }
  }

 private:
  void check(const Flight& flight) {
    const auto bound = shallowest_.of(flight.now().result.state);
    const bool known = context_.depth && isKnown(flight.interpreter().readingOf(*context_.depth));
    if (!bound || !known) {
      return;
    }
    forEachCommand(flight, [&](const CommandRun& command) {
      if (isVertical(command.command)) {
        ++steps;
        ASSERT_NE(command.command, Command::Surface);
        const platforms::Platform& vehicle = context_.platform;
        const double rise =
            command.command == Command::Hover ? 1 : vehicle.envelope.inflection_overshoot_m;
        EXPECT_GE(command.arguments.at(0) - rise - vehicle.world.depth_error_m, bound->reading_m);
      }
    });
  }

  const ProofContext& context_;
  ShallowestCommands shallowest_;
};

TEST(Containment, ShallowestCommands) {
  holds<Shallowest>();
}

/// The time since the vehicle was seen at the surface.
class TimeUnderWater : public Rule {
 public:
  explicit TimeUnderWater(const ProofContext& context)
      : surface_m_(context.platform.world.surface_depth_m) {
    const EndBound end = boundOf(context, kLongestMission, Goal::Exit);
    longest_ = longestSubmersion(context, end, kLongestMission);
    submersions_ = submersionsOf(context, end);
  }
  void start(const Flight&) override { surfaced_ = 0; }
  void tick(const Flight& flight) override {
    const Tick& now = flight.now();
    if (now.depth <= surface_m_) {
      surfaced_ = now.time;
    }
    if (longest_) {
      ++steps;
      EXPECT_LE(now.time - surfaced_, *longest_);
    }
    if (submersions_.states.empty() || flight.over()) {
      return;
    }
    const Submersion& of = submersions_.states[now.result.state.index];
    if (flight.arrived()) {
      EXPECT_LE(now.time - surfaced_, (now.result.just_returned ? of.resumed : of.entered).longest);
    } else if (now.time - now.resumed >= of.climb) {
      EXPECT_LE(now.depth, surface_m_) << "should have climbed";
    }
  }

 private:
  double surface_m_;
  std::optional<double> longest_;
  Submersions submersions_;
  double surfaced_ = 0;
};

TEST(Containment, LongestSubmersion) {
  holds<TimeUnderWater>();
}

/// The last command about depth of a state that always commands the surface when it becomes
/// current.
class Surfacing : public Rule {
 public:
  explicit Surfacing(const ProofContext& context) : m_(context.mission) {}
  void start(const Flight& flight) override { check(flight); }
  void tick(const Flight& flight) override {
    if (flight.arrived()) {
      check(flight);
    }
  }

 private:
  void check(const Flight& flight) {
    if (!commandsSurface(m_, m_[flight.now().result.state])) {
      return;
    }
    ++steps;
    std::optional<Command> last;
    forEachCommand(flight, [&](const CommandRun& command) {
      last = isVertical(command.command) ? command.command : last;
    });
    EXPECT_EQ(last, Command::Surface);
  }

  const Mission& m_;
};

TEST(Containment, CommandsSurface) {
  holds<Surfacing>();
}

/// Twice the area to the left of the way from `a` over `b` to `c`.
double turn(const Position& a, const Position& b, const Position& c) {
  return (b.longitude - a.longitude) * (c.latitude - a.latitude) -
         (b.latitude - a.latitude) * (c.longitude - a.longitude);
}

/// The corners of the convex hull, in order.
std::vector<Position> hullOf(std::vector<Position> places) {
  std::ranges::sort(places, {},
                    [](const Position& p) { return std::pair(p.longitude, p.latitude); });
  std::vector<Position> hull;
  for (int side = 0; side < 2; ++side) {
    const size_t begin = hull.size();
    for (const Position& place : places) {
      while (hull.size() >= begin + 2 && turn(hull[hull.size() - 2], hull.back(), place) <= 0) {
        hull.pop_back();
      }
      hull.push_back(place);
    }
    if (!hull.empty()) {
      hull.pop_back();
    }
    std::ranges::reverse(places);
  }
  return hull;
}

class Steered : public Rule {
 public:
  explicit Steered(const ProofContext& context)
      : steering_(steeringOf(context)), hull_(hullOf(steering_.waypoints)) {}
  void start(const Flight& flight) override {
    bool commanded = false;
    forEachCommand(flight, [&](const CommandRun& c) { commanded |= !isVertical(c.command); });
    EXPECT_TRUE(commanded || steering_.by_heading) << "begins without a waypoint";
    tick(flight);
  }
  void tick(const Flight& flight) override {
    if (steering_.by_heading) {
      return;
    }
    forEachCommand(flight, [&](const CommandRun& command) {
      if (isVertical(command.command)) {
        return;
      }
      ++steps;
      ASSERT_EQ(command.command, Command::SteerTo);
      EXPECT_TRUE(holds({command.arguments.at(0), command.arguments.at(1)}));
    });
  }

 private:
  [[nodiscard]] bool holds(const Position& place) const {
    constexpr double kNear = 1e-9;
    const bool on =
        std::ranges::any_of(steering_.waypoints, [&](const Position& p) { return p == place; });
    bool inside = hull_.size() > 2;
    for (size_t i = 0; i < hull_.size(); ++i) {
      inside = inside && turn(hull_[i], hull_[(i + 1) % hull_.size()], place) >= -kNear;
    }
    return on || inside;
  }

  Steering steering_;
  std::vector<Position> hull_;
};

TEST(Containment, Steering) {
  holds<Steered>();
}

}  // namespace
}  // namespace glider::containment
