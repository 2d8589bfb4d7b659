// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/plan/refusals.h"

#include "support/check.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace glider::analysis {

void PlanRefusals::add(size_t number, const std::string& words,
                       const std::vector<support::Diagnostic>& diagnostics) {
  const auto error =
      std::ranges::find(diagnostics, support::Severity::Error, &support::Diagnostic::severity);
  CHECK(error != diagnostics.end(), "a mission with an error has a diagnostic of it");
  const support::LineColumn at = sources_.place(error->range.file, error->range.begin);
  if (error->id == support::diagnostics::choiceOutside) {
    return add(number, words, fmt::format("not allowed by line {}", at.line), "");
  }
  add(number, words, fmt::format("an error in line {} [{}]", at.line, support::code(error->id)),
      error->message);
}

void PlanRefusals::add(size_t number, const std::string& words, const std::string& reason,
                       const std::string& detail) {
  numbers_.insert(number);
  const auto known = std::ranges::find(reasons_, reason, &report::PlanRefusal::reason);
  const std::string example = detail.empty() ? words : words + ": " + detail;
  if (known == reasons_.end()) {
    reasons_.push_back({reason, 1, example});
    return;
  }
  ++known->ways;
  known->example = last_ ? example : known->example;
}

std::vector<report::PlanRefusal> PlanRefusals::sorted() const {
  std::vector<report::PlanRefusal> all = reasons_;
  std::ranges::stable_sort(all, std::ranges::greater(), &report::PlanRefusal::ways);
  return all;
}

}  // namespace glider::analysis
