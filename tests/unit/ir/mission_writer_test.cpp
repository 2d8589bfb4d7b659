// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is written to a mission: it must have the types that the operations give and leave all
// numbers as they are.

#include "ir/core/mission_writer.h"

#include "ir/core/monitor_writer.h"
#include "ir/core/validate.h"
#include "ir/text/print.h"
#include "tests/unit/ir/missions.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace glider::ir {
namespace {

const support::SourceRange kRange{0, 7, 9};

Mission example() {
  return missionOf(kHeader +
                   "function f symbol f (x: length): bool lowest -inf highest inf\n"
                   "variable limit: time mission\ntable length (3, 4)\nuse f\n"
                   "initial limit 8:time\n"
                   "temporal became always (lt (sensor depth) 4:length)\n" +
                   stateText("a", "case (temporal 0) exit"));
}

struct Written {
  const char* text;
  std::function<ExprId(MissionWriter&)> write;
};

ExprId compare(MissionWriter& write, Op op, ExprId a, ExprId b) {
  return write.operation(op, boolean(), {a, b});
}

/// Each kind of expression, with the operands written first.
const std::vector<Written>& conditions() {
  using W = MissionWriter;
  const Type length = quantity(support::dimension::length);
  static const std::vector<Written> kAll{
      {"(gt missiontime (age temp))",
       [](W& w) {
         const ExprId now = w.now();
         return compare(w, Op::Greater, now, w.age({1}));
       }},
      {"(lt (var limit) 8:time)",
       [](W& w) {
         const ExprId limit = w.read(VariableId{0});
         return compare(w, Op::Less, limit, w.number(8, quantity(support::dimension::time)));
       }},
      {"(gt (element 0 2) (sensor depth))",
       [](W& w) {
         const ExprId element = w.element({0}, w.number(2, plainNumber()));
         return compare(w, Op::Greater, element, w.read(SensorId{0}));
       }},
      {"(le (mul 2 (sensor depth)) 3:length)",
       [length](W& w) {
         const ExprId two = w.number(2, plainNumber());
         const std::array factors{two, w.read(SensorId{0})};
         const ExprId twice = w.operation(Op::Multiply, factors);
         return compare(w, Op::LessEqual, twice, w.number(3, length));
       }},
      {"(or (call 0 (sensor depth)) false)",
       [](W& w) {
         const std::array arguments{w.read(SensorId{0})};
         const ExprId called = w.call({0}, arguments);
         return w.either(called, w.truth(false));
       }},
      {"(and (not (temporal 0)) true)",
       [](W& w) {
         const ExprId not_yet = w.negation(w.read(TemporalId{0}));
         return w.both(not_yet, w.truth(true));
       }},
  };
  return kAll;
}

TEST(MissionWriter, WhatItWritesIsValid) {
  for (const Written& written : conditions()) {
    Mission m = example();
    const size_t before = m.exprs.size();
    MissionWriter write(m, kRange);
    Case c = m.states[0].cases[0];
    c.guard = written.write(write);
    m.states[0].cases.push_back(c);
    EXPECT_TRUE(validate(m).empty()) << written.text;
    EXPECT_NE(print(m).find(std::string("case ") + written.text + " exit"), std::string::npos)
        << print(m);
    for (size_t i = before; i < m.exprs.size(); ++i) {
      EXPECT_EQ(m.exprs[i].range, kRange) << i;
    }
  }
}

TEST(MissionWriter, RefusesOperandsThatDoNotFit) {
  Mission m = example();
  MissionWriter write(m);
  const std::array unequal{write.read(SensorId{0}), write.read(SensorId{1})};
  EXPECT_DEATH(write.operation(Op::Add, unequal), "does not take");
}

TEST(MissionWriter, WhatIsNewComesLast) {
  Mission m = example();
  const Mission before = m;
  MissionWriter write(m, kRange, "watch");
  const VariableId seen = write.flag("seen", VariableKind::Monitor);
  const BlockId block = write.add(Block{{write.assignment(seen, write.truth(true))}});
  const BlockId all = write.add(Block{{write.branch(write.read(seen), block)}});
  EXPECT_EQ(seen.index, before.variables.size());
  EXPECT_EQ(block.index, before.blocks.size());
  EXPECT_EQ(all.index, before.blocks.size() + 1);
  EXPECT_EQ(m[seen].name, "watch.seen");
  EXPECT_EQ(m[seen].range, kRange);
  EXPECT_EQ(m[m[seen].initial].op, Op::False);
  EXPECT_EQ(m[m[seen].initial].type, boolean());
  const Statement& branch = m[all].statements.at(0);
  EXPECT_EQ(branch.kind, StatementKind::If);
  EXPECT_EQ(branch.then, block);
  EXPECT_EQ(branch.range, kRange);
  EXPECT_EQ(m[block].statements.at(0).variable, seen);
  for (size_t i = 0; i < before.exprs.size(); ++i) {
    EXPECT_EQ(m.exprs[i].op, before.exprs[i].op) << i;
  }
}

TEST(MissionWriter, WithoutAPrefixNamesAreAsGiven) {
  Mission m = example();
  EXPECT_EQ(m[MissionWriter(m).flag("seen", VariableKind::Mission)].name, "seen");
}

TEST(MonitorWriter, VariablesOfOneNameAreTwo) {
  Mission m = example();
  Requirement requirement;
  MonitorWriter write(m, "promise 1", kRange);
  const VariableId first = write.flag("seen");
  const VariableId second = write.flag("seen", true);
  write.violation(write.observed(ObservationKind::Entered, {0}), "`a` was entered");
  write.set(first, false);
  write.when(write.read(second), [&] { write.reset(); });
  write.finish(requirement);
  m.requirements.push_back(requirement);
  EXPECT_EQ(m[first].name, "promise 1.1.seen");
  EXPECT_EQ(m[second].name, "promise 1.2.seen");
  EXPECT_TRUE(validate(m).empty()) << print(m);
  const auto& reset = m[m[requirement.monitor.step].statements.back().then].statements;
  ASSERT_EQ(reset.size(), 2U);
  EXPECT_EQ(m[reset[0].value].op, Op::False);
  EXPECT_EQ(m[reset[1].value].op, Op::True);
}

}  // namespace
}  // namespace glider::ir
