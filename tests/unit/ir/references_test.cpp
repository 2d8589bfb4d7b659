// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Each place where a mission names something is visited once: a pass that renumbers must not miss
// one.

#include "ir/core/references.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace glider::ir {
namespace {

/// Gives numbers to the places of a mission, and notes those that are visited, in any order.
class Numbers {
 public:
  template <typename Id>
  void give(Id& id) {
    id.index = given_++;
  }
  template <typename... Ids>
  void giveAll(Ids&... ids) {
    (give(ids), ...);
  }
  template <typename Tag>
  void operator()(Id<Tag>& id) {
    visited.push_back(id.index);
  }
  [[nodiscard]] std::vector<uint32_t> given() const {
    std::vector<uint32_t> all(given_);
    std::iota(all.begin(), all.end(), 0U);
    return all;
  }

  std::vector<uint32_t> visited;

 private:
  uint32_t given_ = 0;
};

Case numberedCase(Numbers& numbers) {
  Case c;
  c.arguments.resize(1);
  numbers.giveAll(c.guard, c.action, c.target, c.arguments[0]);
  return c;
}

Activity numberedActivity(Numbers& numbers) {
  Activity activity;
  activity.arguments.resize(1);
  activity.cases = {numberedCase(numbers)};
  numbers.giveAll(activity.behaviour, activity.arguments[0], activity.entry, activity.done);
  return activity;
}

GuardTable numberedTable(Numbers& numbers) {
  GuardTable table;
  table.columns.resize(1);
  numbers.give(table.columns[0].sensor);
  return table;
}

State numberedState(Numbers& numbers) {
  State state;
  state.profile = numberedActivity(numbers);
  state.route = numberedActivity(numbers);
  state.parameters.resize(1);
  state.log.resize(1);
  state.cases = {numberedCase(numbers)};
  state.table = numberedTable(numbers);
  numbers.giveAll(state.parameters[0], state.log[0].value, state.entry);
  return state;
}

Requirement numberedRequirement(Numbers& numbers) {
  Requirement r;
  r.monitor.observations.resize(1);
  r.monitor.violations.resize(1);
  numbers.giveAll(r.condition, r.monitor.step, r.monitor.observations[0].variable,
                  r.monitor.observations[0].state, r.monitor.violations[0].condition, r.state,
                  r.after);
  return r;
}

void numberBody(Mission& m, Numbers& numbers) {
  m.behaviours.resize(1);
  m.behaviours[0].reads.resize(1);
  m.conditions.resize(1);
  m.requirements = {numberedRequirement(numbers)};
  m.assumptions.resize(1);
  m.assumptions[0].watch = numberedRequirement(numbers);
  m.always = {numberedCase(numbers)};
  m.always_table = numberedTable(numbers);
  m.states = {numberedState(numbers)};
  m.compass.emplace();
  Share& share = m.shares.emplace_back();
  share.named.resize(1);
  numbers.giveAll(share.sensor, share.variable, share.peer, share.named[0].sensor, m.utc);
  numbers.giveAll(m.behaviours[0].reads[0], m.conditions[0], m.assumptions[0].sensor, m.every_tick,
                  m.compass->variation);
}

void numberLists(Mission& m, Numbers& numbers) {
  Expr& e = m.exprs.emplace_back();
  for (ExprId& operand : e.operands) {
    numbers.give(operand);
  }
  numbers.giveAll(e.sensor, e.variable, e.temporal, e.table, e.use);
  Statement& s = m.blocks.emplace_back().statements.emplace_back();
  s.values.resize(1);
  numbers.giveAll(s.variable, s.value, s.then, s.otherwise, s.values[0]);
  Temporal& t = m.temporals.emplace_back();
  numbers.giveAll(t.state, t.operand, t.duration, t.along);
  Variable& v = m.variables.emplace_back();
  numbers.giveAll(v.owner, v.initial);
  numbers.give(m.uses.emplace_back().function);
}

TEST(References, AreVisitedOnceEach) {
  Mission m;
  Numbers numbers;
  numberBody(m, numbers);
  numberLists(m, numbers);
  References(numbers).of(m);
  std::ranges::sort(numbers.visited);
  EXPECT_EQ(numbers.visited, numbers.given());
}

TEST(References, OfTheBodyAreThoseOutsideTheLists) {
  Mission m;
  Numbers numbers;
  numberBody(m, numbers);
  const std::vector<uint32_t> body = numbers.given();
  numberLists(m, numbers);
  References(numbers).ofBody(m);
  std::ranges::sort(numbers.visited);
  EXPECT_EQ(numbers.visited, body);
}

TEST(References, LeaveOutWhatIsInvalidAndWhatTheVisitorDoesNotTake) {
  Mission m;
  m.exprs.resize(2);
  m.exprs[1].operands[0] = {0};
  m.exprs[1].sensor = {3};
  std::vector<uint32_t> sensors;
  const auto visit = [&](SensorId& id) { sensors.push_back(id.index); };
  References(visit).of(m);
  EXPECT_EQ(sensors, std::vector<uint32_t>{3});
}

}  // namespace
}  // namespace glider::ir
