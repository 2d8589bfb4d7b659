// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/certify/values.h"

namespace glider::ir::certify {

Value merged(SmtText& out, const Term& condition, const Value& a, const Value& b) {
  if (const auto* x = std::get_if<Number>(&a)) {
    const auto& y = std::get<Number>(b);
    return Number{out.real(choice(condition, x->value, y.value)),
                  out.boolean(choice(condition, x->known, y.known))};
  }
  const auto& x = std::get<Truths>(a);
  const auto& y = std::get<Truths>(b);
  return Truths{out.boolean(choice(condition, x.is_true, y.is_true)),
                out.boolean(choice(condition, x.is_false, y.is_false))};
}

Store merged(SmtText& out, const Term& condition, const Store& a, const Store& b) {
  const auto real = [&](const Term& x, const Term& y) { return out.real(choice(condition, x, y)); };
  const auto boolean = [&](const Term& x, const Term& y) {
    return out.boolean(choice(condition, x, y));
  };
  Store store = a;
  for (size_t i = 0; i < store.variables.size(); ++i) {
    store.variables[i] = merged(out, condition, a.variables[i], b.variables[i]);
  }
  for (size_t i = 0; i < store.temporals.size(); ++i) {
    store.temporals[i] = merged(out, condition, a.temporals[i], b.temporals[i]);
    store.memory[i] = {boolean(a.memory[i].was, b.memory[i].was),
                       real(a.memory[i].since, b.memory[i].since)};
  }
  const Vehicle& x = a.vehicle;
  const Vehicle& y = b.vehicle;
  store.vehicle = {real(x.depth, y.depth), real(x.deepest, y.deepest),
                   boolean(x.climbing, y.climbing), real(x.since, y.since), real(x.top, y.top)};
  return store;
}

}  // namespace glider::ir::certify
