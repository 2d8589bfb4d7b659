// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/scope.h"
#include "ir/prove/encoding/tick.h"

#include <string>
#include <vector>

namespace glider::ir::prove {

/// What a question keeps for itself: its name in certificates (ir/certify/names.h), and its
/// sort.
struct MemoryTerm {
  std::string name;
  z3::sort sort;
};

/// The terms of a configuration as a row, for a predicate over configurations with the same
/// control. The control and the cone of influence determine which terms they are.
class Layout {
 public:
  /// All must outlive this. `scope`: null for the whole mission.
  Layout(const ProofContext& proof_context, const ConeOfInfluence& relevance,
         const std::vector<MemoryTerm>& memory, const Scope* scope = nullptr)
      : proof_context_(proof_context),
        m_(proof_context.mission),
        relevance_(relevance),
        memory_(memory),
        scope_(scope) {}

  /// A configuration of unknowns.
  Configuration make(const Control& control, Unknowns& unknowns) const;
  /// Its terms; those of `make` are unknowns, all different.
  [[nodiscard]] std::vector<z3::expr> row(const Configuration& configuration) const;
  /// The names of these terms in certificates, in the same order.
  [[nodiscard]] std::vector<std::string> names(const Control& control) const;
  /// What the row leaves out because it always holds: variables that are never unknown.
  [[nodiscard]] z3::expr known(const Control& control, z3::context& context) const;

 private:
  /// Whether a control is followed: of others only the time and the monitor are kept.
  [[nodiscard]] bool follows(const Control& control) const {
    return scope_ == nullptr || scope_->holds(control);
  }
  /// Of the vehicle only the depth is kept, and since when a state that only climbs does.
  Vehicle vehicleWithin(const Control& control, Unknowns& unknowns) const;
  /// Whether a variable may have any value with this control, as the scope does not follow it.
  [[nodiscard]] bool isFree(const Control& control, uint32_t variable) const {
    return scope_ != nullptr && !isOfMonitor(m_.variables[variable].kind) &&
           !(follows(control) && scope_->fine);
  }
  /// Whether a variable is kept with this control.
  [[nodiscard]] bool keeps(const Control& control, uint32_t variable) const;
  /// Whether a temporal is watched with this control.
  [[nodiscard]] bool watches(const Control& control, uint32_t temporal) const;

  const ProofContext& proof_context_;
  const Mission& m_;
  const ConeOfInfluence& relevance_;
  const std::vector<MemoryTerm>& memory_;
  const Scope* scope_;
};

}  // namespace glider::ir::prove
