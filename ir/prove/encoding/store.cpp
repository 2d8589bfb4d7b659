// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/store.h"

namespace glider::ir::prove {
namespace {

z3::expr either(const z3::expr& condition, const z3::expr& yes, const z3::expr& no) {
  return z3::eq(yes, no) ? yes : z3::ite(condition, yes, no);
}

}  // namespace

void Store::show(SymbolicState& moment) const {
  for (const auto& [index, term] : numbers) {
    moment.set(VariableId{index}, term);
  }
  for (const auto& [index, term] : truths) {
    moment.set(VariableId{index}, term);
  }
  moment.forget();
}

Store choose(const z3::expr& condition, const Store& yes, const Store& no) {
  Store result = no;
  for (auto& [index, term] : result.numbers) {
    const NumberTerm& other = yes.numbers.at(index);
    term = {either(condition, other.value, term.value), either(condition, other.known, term.known),
            0};
  }
  for (auto& [index, term] : result.truths) {
    const TruthTerm& other = yes.truths.at(index);
    term = {either(condition, other.is_true, term.is_true),
            either(condition, other.is_false, term.is_false)};
  }
  if (result.vehicle) {
    Vehicle& vehicle = *result.vehicle;
    const Vehicle& other = *yes.vehicle;
    vehicle = {either(condition, other.depth, vehicle.depth),
               either(condition, other.deepest, vehicle.deepest),
               either(condition, other.climbing, vehicle.climbing),
               either(condition, other.since, vehicle.since),
               either(condition, other.top, vehicle.top)};
  }
  return result;
}

}  // namespace glider::ir::prove
