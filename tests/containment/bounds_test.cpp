// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the prover says about times and call stacks, against those of random flights.

#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/earliest_entry.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/entered_after.h"
#include "ir/prove/abstract/leaving.h"
#include "tests/containment/rule.h"

#include <cmath>

namespace glider::containment {
namespace {

using namespace ir;
using namespace ir::prove;

/// The end of the mission, and when each state has been left for the last time.
class EndBounds : public Rule {
 public:
  EndBounds(const ProofContext& context, EndBound bound) : m_(context.mission), bound_(bound) {}
  void tick(const Flight& flight) override {
    const Tick& now = flight.now();
    ++steps;
    EXPECT_LE(now.time, *bound_.by) << "not ended";
    if (!flight.over()) {
      EXPECT_LE(now.time, bound_.left_by[now.result.state.index]) << "not left";
    }
  }

 private:
  const Mission& m_;
  EndBound bound_;
};

TEST(Containment, EndBound) {
  holdsFor([](const ProofContext& context) -> std::unique_ptr<Rule> {
    const EndBound bound = boundOf(context, kLongestMission, Goal::Exit);
    return bound.by ? std::make_unique<EndBounds>(context, bound) : nullptr;
  });
}

TEST(Containment, EndBoundWithoutOutages) {
  holdsFor(
      [](const ProofContext& context) -> std::unique_ptr<Rule> {
        const EndBound bound = boundOf(context.withoutPowerCuts(), kLongestMission, Goal::Exit);
        return bound.by ? std::make_unique<EndBounds>(context, bound) : nullptr;
      },
      {.power_cuts = false});
}

bool lies(const Variable& v, double value, const PossibleValues& held) {
  if (v.type.kind == TypeKind::Bool) {
    return value != value ? held.truths.is_unknown
           : value == 1   ? held.truths.is_true
                          : held.truths.is_false;
  }
  return value != value || (!held.never && held.lowest <= value && value <= held.highest);
}

/// Every stay in a state is one of those that the bound rests on: the call stack, the values of the
/// variables, when it began and until when it lasts.
class Stays : public Rule {
 public:
  explicit Stays(const ProofContext& context) : m_(context.mission), stays_(staysOf(context)) {}

  void start(const Flight& flight) override {
    arrived_ = 0;
    control_ = controlOf(flight.now().result);
    tick(flight);
  }
  void tick(const Flight& flight) override {
    if (flight.over() || stays_.empty()) {
      return;
    }
    if (flight.arrived()) {
      arrived_ = flight.now().time;
      control_ = controlOf(flight.now().result);
    }
    ++steps;
    EXPECT_TRUE(std::ranges::any_of(stays_, [&](const Stay& stay) { return is(stay, flight); }))
        << "no such stay since " << arrived_;
  }

 private:
  [[nodiscard]] bool is(const Stay& stay, const Flight& flight) const {
    if (stay.control != control_) {
      return false;
    }
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      const Variable& v = m_.variables[i];
      if ((!v.owner.valid() || control_.holds(v.owner)) &&
          !lies(v, flight.now().result.variables[i], stay.values[i])) {
        return false;
      }
    }
    return std::ranges::any_of(stay.parts, [&](const LeavingPart& part) {
      return part.arriving.earliest <= arrived_ && arrived_ <= part.arriving.latest &&
             flight.now().time <= part.by;
    });
  }

  const Mission& m_;
  std::vector<Stay> stays_;
  double arrived_ = 0;
  Control control_;
};

TEST(Containment, Stays) {
  holds<Stays>();
}

/// When the cases of a state fire at the latest, from the moment at which it became current.
class Leavings : public Rule {
 public:
  explicit Leavings(const ProofContext& context)
      : context_(context), m_(context.mission), values_(anyValues(m_)) {}

  void start(const Flight& flight) override { arrive(flight); }
  void tick(const Flight& flight) override {
    const Tick& now = flight.now();
    const Tick& before = flight.before();
    const State& state = m_[before.result.state];
    ++steps;
    if (!now.result.moved) {
      EXPECT_LE(now.time, of_.by) << "not left";
      EXPECT_LE(now.time - arrived_, stay_.by) << "stays longer";
    } else if (now.result.moved->list == ListKind::State) {
      const uint32_t fired = now.result.moved->number;
      EXPECT_LE(now.time, of_.latest[fired]) << "case " << fired << " of " << state.name;
      EXPECT_LE(now.time - arrived_, stay_.latest[fired]) << "case " << fired << " of the stay";
    } else {
      EXPECT_LE(now.time, of_.interrupted) << "interrupted later";
      EXPECT_LE(now.time - arrived_, stay_.interrupted) << "the stay is interrupted later";
    }
    if (!flight.over() && now.result.moved) {
      arrive(flight);
    }
  }

 private:
  void arrive(const Flight& flight) {
    const Control control = controlOf(flight.now().result);
    always_ = {{}, control.just_returned};
    for (uint32_t i = 0; i < m_.always.size(); ++i) {
      if (control.mayInterrupt(m_, i)) {
        always_.cases.push_back(&m_.always[i]);
      }
    }
    arrived_ = flight.now().time;
    const State& state = m_[control.state];
    // As often known exactly as within an hour.
    const bool exact = flight.now().time > 100;
    const double slack = exact ? 0 : 300;
    of_ = leavingOf(context_, state, always_, values_,
                    {std::max(0.0, arrived_ - slack), arrived_ + slack});
    stay_ = stayAny(state);
  }

  /// In seconds; times of the mission that guards name count from the arrival at the latest.
  [[nodiscard]] Leaving stayAny(const State& state) const {
    return stayOf(context_, state, always_, values_);
  }

  const ProofContext& context_;
  const Mission& m_;
  Valuation values_;
  Interruptions always_;
  Leaving of_, stay_;
  double arrived_ = 0;
};

TEST(Containment, Leaving) {
  holds<Leavings>();
}

/// The clocks, the depth and the times of each state.
class StateBoundsHold : public Rule {
 public:
  explicit StateBoundsHold(const ProofContext& context)
      : bounds_(boundsOfStates(context, boundOf(context, kLongestMission, Goal::Exit))),
        entries_(earliestEntries(context)) {}

  void tick(const Flight& flight) override {
    const Tick& now = flight.now();
    const StateBounds& bounds = bounds_[now.result.state.index];
    ++steps;
    EXPECT_GE(now.time, bounds.earliest);
    EXPECT_GE(now.time, entries_[now.result.state.index]);
    EXPECT_LE(now.time, bounds.latest);
    EXPECT_LE(now.time - now.resumed, bounds.resume_time);
    EXPECT_LE(now.time - now.entered, bounds.state_time);
    EXPECT_LE(now.depth, bounds.depth);
  }

 private:
  std::vector<StateBounds> bounds_;
  std::vector<double> entries_;
};

TEST(Containment, BoundsOfStates) {
  holds<StateBoundsHold>();
}

/// Which states follow which.
class Orders : public Rule {
 public:
  explicit Orders(const ProofContext& context) : m_(context.mission) {
    for (uint32_t after = 0; after < m_.states.size(); ++after) {
      for (uint32_t state = 0; state < m_.states.size(); ++state) {
        may_.push_back(mayEnterAfter(m_, {state}, {after}));
      }
    }
  }
  void start(const Flight& flight) override {
    seen_.assign(m_.states.size(), false);
    seen_[flight.now().result.state.index] = true;
  }
  void tick(const Flight& flight) override {
    const TickResult& now = flight.now().result;
    if (!flight.arrived()) {
      return;
    }
    for (size_t after = 0; after < seen_.size() && !now.just_returned; ++after) {
      ++steps;
      EXPECT_TRUE(!seen_[after] || may_[after * seen_.size() + now.state.index])
          << m_[now.state].name << " after " << m_.states[after].name;
    }
    seen_[now.state.index] = true;
  }

 private:
  const Mission& m_;
  std::vector<bool> may_, seen_;
};

TEST(Containment, EnteredAfter) {
  holds<Orders>();
}

}  // namespace
}  // namespace glider::containment
