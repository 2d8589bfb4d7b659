// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/prove/evidence/configurations.h"

#include <optional>
#include <vector>

namespace glider::ir::prove {

/// Of `whenever A then B within T`, and of `when`: two states of which B is on the stack whenever A
/// is. B then counts at once, so that the promise holds in any flight.
struct StandingAnswer {
  StateId cause;
  StateId response;
};

/// Finds them: certain, from the call configurations alone, which are searched once.
class StandingAnswers {
 public:
  /// `mission` outlives this.
  explicit StandingAnswers(const Mission& mission) : m_(mission) {}
  /// None if the requirement is not such a promise.
  std::optional<StandingAnswer> of(const Requirement& requirement);
  /// Whether `response` is on the stack whenever `cause` is. Not if there are too many
  /// configurations to tell.
  bool isOnStackWith(StateId cause, StateId response);

 private:
  const Mission& m_;
  bool searched_ = false;
  std::optional<std::vector<Reached>> configurations_;
};

}  // namespace glider::ir::prove
