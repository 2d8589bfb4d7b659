// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/surfacing.h"
#include "ir/prove/context/state_bounds.h"

#include <map>
#include <string>
#include <vector>

namespace glider::ir::prove {

/// What is known of every trace without a search, as formulas for certificates: when each call
/// configuration has been left (staysOf), how long its state may have been current and how deep the
/// vehicle may be (stateBounds), the depths that are commanded, and which variables are never
/// unknown. Together it is inductive.
class Known {
 public:
  /// `proof_context` outlives this. `end`: its bound.
  Known(const ProofContext& proof_context, const EndBound& end);

  /// What holds after every tick in this configuration.
  [[nodiscard]] std::string in(const certify::Configuration& at) const;
  /// What holds there of the climb in force, beside that.
  [[nodiscard]] std::string climbIn(const certify::Configuration& at) const;
  /// What holds there of the last tick at the surface, beside that.
  [[nodiscard]] std::string surfacedIn(const certify::Configuration& at) const;

 private:
  [[nodiscard]] std::string ofStays(const certify::Configuration& at) const;
  [[nodiscard]] std::string ofStay(const Stay& stay, bool just_returned) const;
  [[nodiscard]] std::string timerName() const;
  [[nodiscard]] std::string grown(const Submerged& from, bool climbs) const;
  [[nodiscard]] std::string timed(const Submersion& state) const;
  [[nodiscard]] std::string ofTimes(const Stay& stay, bool just_returned) const;

  const ProofContext& proof_context_;
  const Mission& m_;
  std::vector<StateBounds> bounds_;  ///< of every state
  std::vector<Interval> held_;       ///< of every variable
  std::vector<bool> commanded_;      ///< whether a depth depends on the variable
  Submersions submersions_;
  std::vector<double> climbs_;  ///< of every state: climbTimes
  std::vector<Stay> stays_;
  /// The stays in each configuration, by their numbers.
  std::map<certify::Configuration, std::vector<size_t>> here_;
};

}  // namespace glider::ir::prove
