// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/evidence/formula.h"

#include "ir/certify/names.h"
#include "ir/prove/encoding/terms.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace glider::ir::prove {
namespace {

/// Intervals have the greatest double where they have no bound.
bool isBound(double value) {
  return std::fabs(value) < std::numeric_limits<double>::max();
}

}  // namespace

std::string realText(double value) {
  // To make one takes milliseconds, and evidence has thousands of numbers.
  thread_local z3::context context;
  return realOf(context, value).to_string();
}

void FormulaParts::atMost(std::string_view name, double most) {
  if (isBound(most)) {
    parts_.push_back(fmt::format("(<= {} {})", name, realText(most)));
  }
}

void FormulaParts::atLeast(std::string_view name, double least) {
  if (isBound(least)) {
    parts_.push_back(fmt::format("(>= {} {})", name, realText(least)));
  }
}

void FormulaParts::knownWithin(const Variable& variable, const Interval& range) {
  const std::string known = certify::variableName(variable, " known");
  if (range.empty) {
    parts_.push_back(fmt::format("(not {})", known));
    return;
  }
  FormulaParts within;
  within.atLeast(certify::variableName(variable, ""), range.lowest);
  within.atMost(certify::variableName(variable, ""), range.highest);
  if (!within.parts_.empty()) {
    parts_.push_back(fmt::format("(=> {} {})", known, within.all()));
  }
}

void FormulaParts::isKnown(const Variable& variable) {
  const auto name = [&](const char* what) { return certify::variableName(variable, what); };
  parts_.push_back(variable.type.kind == TypeKind::Bool
                       ? fmt::format("(or {} {})", name(" true"), name(" false"))
                       : name(" known"));
}

void FormulaParts::holding(const Variable& variable, const PossibleValues& values) {
  if (!values.truths.is_unknown) {
    isKnown(variable);
  }
  if (variable.type.kind != TypeKind::Bool) {
    knownWithin(variable, {values.lowest, values.highest, values.never});
    return;
  }
  if (!values.truths.is_true) {
    parts_.push_back(fmt::format("(not {})", certify::variableName(variable, " true")));
  }
  if (!values.truths.is_false) {
    parts_.push_back(fmt::format("(not {})", certify::variableName(variable, " false")));
  }
}

void FormulaParts::add(std::string part) {
  if (part != "true") {
    parts_.push_back(std::move(part));
  }
}

std::string anyOf(const std::vector<std::string>& parts) {
  return parts.empty()       ? "false"
         : parts.size() == 1 ? parts.front()
                             : fmt::format("(or {})", fmt::join(parts, " "));
}

std::string FormulaParts::all() const {
  return parts_.empty()       ? "true"
         : parts_.size() == 1 ? parts_.front()
                              : fmt::format("(and {})", fmt::join(parts_, " "));
}

}  // namespace glider::ir::prove
