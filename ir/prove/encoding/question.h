// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/budget.h"
#include "ir/prove/encoding/symbolic_state.h"

#include <optional>
#include <string>
#include <vector>

namespace glider::ir::prove {

enum class Answer : uint8_t { Yes, No, Unknown };

/// A question to Z3: can all conditions hold together? Its resource limit is Z3's own count of
/// steps, so the answer does not depend on the machine.
class Question {
 public:
  Question(z3::context& context, unsigned effort);
  /// The same out of a budget, which outlives this: a question that it does not cover has no
  /// answer.
  Question(z3::context& context, Budget& budget, unsigned effort);

  void add(const z3::expr& holds) {
    solver_.add(holds);
    ++conditions_;
  }
  /// Adds all known facts, so that a No can say which of them were needed.
  void add(const Unknowns& unknowns);
  /// Adds a condition under a name that the caller chooses.
  void add(const z3::expr& holds, uint32_t name);

  Answer ask();
  /// After Yes.
  z3::model model() const { return solver_.get_model(); }
  /// After No: the names of the conditions that were needed for it, and the facts.
  [[nodiscard]] const std::vector<uint32_t>& neededNames() const { return needed_names_; }
  [[nodiscard]] const std::vector<Fact>& neededFacts() const { return needed_facts_; }

 private:
  void assume(const z3::expr& holds);

  z3::check_result check();

  z3::context& context_;
  Budget* budget_ = nullptr;  ///< none: not limited together with others
  uint64_t conditions_ = 0;
  z3::solver solver_;
  z3::expr_vector assumptions_;
  std::vector<std::optional<Fact>> facts_;  ///< of each assumption
  std::vector<std::optional<uint32_t>> names_;
  std::vector<uint32_t> needed_names_;
  std::vector<Fact> needed_facts_;
};

/// Z3's own count of the steps that it has made in its context so far.
uint64_t stepsIn(const z3::stats& statistics);

/// The values in a model of the readings, clocks and variables that `moment` has asked for: "depth
/// = 12 m, temp unknown, missiontime = 500 s".
std::string describe(const z3::model& model, SymbolicState& moment);

}  // namespace glider::ir::prove
