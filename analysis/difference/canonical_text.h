// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <map>
#include <string>
#include <vector>

namespace glider::analysis {

/// The parts of a mission as text that is the same for parts that mean the same: without
/// formatting, names of constants, and the numbers that the IR gives to things. Variables have
/// their names.
class CanonicalText {
 public:
  /// `names`: of the states, by number, as both missions that are compared call them. `mission`
  /// outlives this.
  CanonicalText(const ir::Mission& mission, std::vector<std::string> names);

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] std::string expression(ir::ExprId id);
  [[nodiscard]] std::string block(ir::BlockId id);
  [[nodiscard]] std::string oneCase(const ir::Case& c);
  /// With its variables, which are of `kind`.
  [[nodiscard]] std::string activity(const ir::Activity& activity, ir::StateId owner,
                                     ir::VariableKind kind);
  [[nodiscard]] std::string logged(const ir::State& state);
  [[nodiscard]] std::string sampled(const ir::State& state);
  [[nodiscard]] std::string parameters(const ir::State& state) const;
  [[nodiscard]] std::string variable(const ir::Variable& variable);
  /// Its name, with the name of its state as both missions call it.
  [[nodiscard]] std::string nameOf(const ir::Variable& variable) const;
  /// Everything that belongs to the state.
  [[nodiscard]] std::string state(ir::StateId id);

 private:
  [[nodiscard]] std::string node(const ir::Expr& e);
  [[nodiscard]] std::string temporal(const ir::Temporal& temporal);
  [[nodiscard]] std::string sensor(ir::SensorId id) const;
  [[nodiscard]] std::string statement(const ir::Statement& statement);
  [[nodiscard]] std::string list(const std::vector<ir::ExprId>& ids);
  [[nodiscard]] std::string variables(ir::StateId owner, ir::VariableKind kind);
  [[nodiscard]] std::string cases(const std::vector<ir::Case>& cases);

  const ir::Mission& m_;
  std::vector<std::string> names_;
  std::map<uint32_t, std::string> made_;  ///< of expressions
};

}  // namespace glider::analysis
