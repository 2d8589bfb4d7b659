// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/truth.h"
#include "ir/verify/inherited.h"

#include <optional>
#include <set>
#include <vector>

namespace glider::ir::prove {

/// What a profile remembers: its own truth values, and its latest command about depth.
struct Mode {
  std::vector<Truth> truths;       ///< of ProfileModes::own
  std::optional<Command> command;  ///< none: that of another state
  auto operator<=>(const Mode&) const = default;
};

/// How the statements of a profile lead from one of its modes to others. A comparison may have
/// either result.
class ProfileModes {
 public:
  /// Of a profile with more truth values, the modes are not worth following.
  static constexpr size_t kMostTruths = 5;

  /// `known`: what is never unknown; null: everything is taken to be known. All outlive this.
  ProfileModes(const Mission& mission, const Activity& profile, const GreatestFixpoint* known);

  /// The truth values that the profile sets itself.
  [[nodiscard]] const std::vector<VariableId>& own() const { return own_; }
  /// The modes in which it may begin, its entry included.
  [[nodiscard]] std::set<Mode> begin() const;
  /// All modes in which a block may leave the profile if it starts in one of these.
  [[nodiscard]] std::set<Mode> run(BlockId block, std::set<Mode> modes) const;
  /// Unknown: either value is possible.
  [[nodiscard]] Truth judge(ExprId id, const Mode& mode) const;

 private:
  [[nodiscard]] bool maybeUnknown(ExprId id) const;
  [[nodiscard]] std::set<Mode> run(const Statement& statement, Mode mode) const;
  static std::set<Mode> with(Mode mode, size_t number, Truth value);

  const Mission& m_;
  const Activity& profile_;
  const GreatestFixpoint* known_;
  std::vector<VariableId> own_;
};

}  // namespace glider::ir::prove
