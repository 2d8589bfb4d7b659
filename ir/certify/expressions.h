// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/certify/facts.h"
#include "ir/certify/values.h"
#include "ir/core/mission.h"
#include "ir/core/ops.h"
#include "platforms/load/platform.h"

#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

namespace glider::ir::certify {

/// What all rules of a script have in common.
struct Setting {
  const Mission& mission;
  const platforms::Platform& platform;
  const Requirement& requirement;
  const Facts& facts;
};

/// A sensor in a tick.
struct Reading {
  Number value;
  Term age;
};

/// The expressions of one tick (README N, C; steps 1 and 2). The tick's readings, results of C
/// functions and roundings are constants of the script: equal operations on equal terms have equal
/// results.
class Expressions {
 public:
  /// A tick at mission time `time`, with the vehicle at `depth`.
  Expressions(const Setting& setting, SmtText& out, Term time, Term depth)
      : setting_(setting), out_(out), time_(std::move(time)), depth_(std::move(depth)) {}

  Value evaluate(ExprId id, const Store& store);
  Number number(ExprId id, const Store& store);
  Truths truth(ExprId id, const Store& store);
  /// The condition of a requirement: `depth` is the vehicle's true depth.
  Truths promise(ExprId id, const Store& store);
  /// Whether `depth` is the vehicle's true depth, as in a requirement, or a reading.
  void readTrueDepth(bool is) { true_depth_ = is; }
  /// Any number that the range allows, known only if `known` is true.
  Number anyNumber(const Range& range, const Term& known);
  [[nodiscard]] const Term& time() const { return time_; }
  [[nodiscard]] const std::map<uint32_t, Reading>& readings() const { return readings_; }

 private:
  using Values = std::map<uint32_t, Value>;
  Value valueOf(uint32_t id, const Values& values, const Store& store);
  Value leaf(const Expr& e, const Store& store);
  const Reading& readingOf(SensorId id);
  [[nodiscard]] bool isDepth(SensorId id) const;
  Value call(const Expr& e);
  Number clock(ClockOp op, const Store& store);
  Number unary(uint32_t id, const Number& a);
  [[nodiscard]] bool isOnClockGrid(uint32_t id, size_t operand) const;
  Number binary(uint32_t id, const Number& a, const Number& b);
  Number product(uint32_t id, const Number& a, const Number& b);
  Number quotient(uint32_t id, const Number& a, const Number& b);
  Number clamp(const Number& x, const Number& l, const Number& h);
  Number select(const Truths& c, const Number& a, const Number& b);
  Number element(uint32_t id, const Number& n);
  Truths comparison(ComparisonOp op, const Number& a, const Number& b);
  Truths logic(LogicOp op, const Truths& a, const Truths& b);
  void requireRange(const Number& number, const Range& range);
  Number rounded(uint32_t id, const Term& exact, const Term& known);
  Number approximated(uint32_t id, const std::vector<Number>& operands, const Term& known);
  void round(const Term& result, const Term& exact, bool whole);
  [[nodiscard]] const Term& exactOf(const Term& result) const;
  Term roundedFrom(const Term& exact, Term result);
  void keepOrder(const Term& a, const Term& b);
  Term smaller(const Term& a, const Term& b);
  Term greater(const Term& a, const Term& b);

  const Setting& setting_;
  SmtText& out_;
  Term time_;
  Term depth_;
  bool true_depth_ = false;
  std::map<uint32_t, Reading> readings_;
  std::map<uint32_t, Value> calls_;
  std::unordered_map<std::string, Number> results_;  ///< of roundings, by operation and operands
  std::unordered_map<Term, Term> exact_;             ///< of results: what was rounded once
  std::set<std::pair<Term, Term>> ordered_;          ///< by keepOrder
};

}  // namespace glider::ir::certify
