// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/plan/plan.h"
#include "support/diagnostics/diagnostic.h"
#include "support/source_manager.h"

#include <set>
#include <string>
#include <vector>

namespace glider::analysis {

/// The ways to choose that were refused, counted by the reason.
class PlanRefusals {
 public:
  /// `sources`: of the mission's text; it outlives this.
  explicit PlanRefusals(const support::SourceManager& sources) : sources_(sources) {}

  /// Of two ways with one reason, the first is the example, or from now on the last: ways then come
  /// the better ones first, so that it is the nearest to what will be chosen.
  void takeLast(bool last) { last_ = last; }

  /// The way `number`, in words "bottom = 60 m, hours = 44 h", is refused for an error.
  void add(size_t number, const std::string& words,
           const std::vector<support::Diagnostic>& diagnostics);
  /// For another reason: "`require …` stays undecided"; `detail` says more of this way, or nothing.
  void add(size_t number, const std::string& words, const std::string& reason,
           const std::string& detail);

  [[nodiscard]] bool contains(size_t number) const { return numbers_.contains(number); }
  [[nodiscard]] size_t count() const { return numbers_.size(); }
  /// The most frequent first.
  [[nodiscard]] std::vector<report::PlanRefusal> sorted() const;

 private:
  const support::SourceManager& sources_;
  bool last_ = false;
  std::set<size_t> numbers_;
  std::vector<report::PlanRefusal> reasons_;
};

}  // namespace glider::analysis
