// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

// Readings of oxygen and of chlorophyll are plain numbers, so that missions may combine them
// freely. A unit that is written, such as `200 uM`, shows that another quantity is meant where it
// meets `chlorophyll`. Where no unit is written, nothing is refused.

namespace glider::frontend {
namespace {

constexpr std::string_view kNoUnit = "1";

std::string sayScale(const Scale& scale) {
  return scale.unit == kNoUnit ? "has no unit" : fmt::format("is in {}", scale.unit);
}

}  // namespace

Scale commonScale(const Scale& a, const Scale& b) {
  if (a.unit.empty() || b.unit.empty()) {
    return a.unit.empty() ? b : a;
  }
  return a.unit == b.unit ? Scale{a.unit, a.written || b.written} : Scale{};
}

bool ExprLowering::scalesDiffer(const Value& left, const support::SourceRange& left_where,
                                const Value& right, const support::SourceRange& right_where,
                                std::string_view op) {
  const Scale& a = left.scale;
  const Scale& b = right.scale;
  if (a.unit.empty() || b.unit.empty() || a.unit == b.unit || !(a.written || b.written)) {
    return false;
  }
  const support::SourceRange& where = b.written ? right_where : left_where;
  scope_.report(support::diagnostics::scalesDiffer, where, scope_.text(left_where), sayScale(a),
                scope_.text(right_where), sayScale(b), op);
  return true;
}

}  // namespace glider::frontend
