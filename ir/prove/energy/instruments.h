// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/energy/energy_lines.h"
#include "ir/prove/energy/profile_legs.h"

#include <optional>
#include <vector>

namespace glider::ir::prove {

/// For which share of the time the instruments that missions switch are on at most, by their
/// places.
class InstrumentShares {
 public:
  /// `context` outlives this.
  explicit InstrumentShares(const LegContext& context);

  /// What they take in a state, added to its lines: there is none of it in them. What the state
  /// before has commanded goes on until the vehicle obeys this one, in the first state what the
  /// vehicle's own mission does.
  void addTo(EnergyLines& lines, StateId state) const;
  /// The same in any state, added to a line for the whole mission.
  void addMostTo(EnergyLine& line) const;

 private:
  [[nodiscard]] InstrumentSeconds sharesIn(const State& state) const;
  [[nodiscard]] double otherwise(const platforms::Draw& draw) const;
  [[nodiscard]] bool isKnown(ExprId code) const;
  [[nodiscard]] double greatest(const platforms::Draw& draw, const Sampling& sampling) const;
  [[nodiscard]] std::optional<double> with(const Expr& code, ExprId period,
                                           const platforms::Draw& draw) const;

  const LegContext& context_;
  const Mission& m_;
  double lag_s_;  ///< from a command until the vehicle obeys it
  std::vector<InstrumentSeconds> by_state_;
  InstrumentSeconds most_{};    ///< in any state
  InstrumentSeconds before_{};  ///< before the first command
};

}  // namespace glider::ir::prove
