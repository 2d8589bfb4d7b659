// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/requirements/premises.h"
#include "ir/prove/requirements/strategy.h"

#include <optional>
#include <vector>

namespace glider::ir::prove {

/// Decides the requirements of a mission: tries the strategies in order.
class RequirementCheck {
 public:
  /// `context` outlives this.
  explicit RequirementCheck(StrategyContext& context);

  /// First the strategies that need no search, on all requirements, then the searches, then longer
  /// ones about what is still open. What a search has proved may prove others.
  void run();

 private:
  /// A verdict, and how it was reached.
  struct Judged {
    RequirementVerdict verdict;
    const Strategy* by = nullptr;  ///< none: undecided
    bool bare = false;             ///< proved in StrategyContext::bare
    bool waited = false;           ///< not decided at once
  };

  [[nodiscard]] Judged atOnce(uint32_t number);
  [[nodiscard]] bool isAtOnceProvedBare(uint32_t number, Judged& judged);
  [[nodiscard]] std::vector<uint32_t> waiting() const;
  void search(Judged& judged);
  void searchLonger(Judged& judged);
  void flyForHours(Judged& judged);
  bool judgeAgain(Judged& judged);
  bool judgeBySearch(Attempt& attempt, Judged& judged);
  /// By one strategy, if it serves the requirement.
  bool judgeBy(const Strategy& strategy, Attempt& attempt, Judged& judged);
  void learn(const Judged& judged);
  void settle(Judged& judged);
  void addPremises(Judged& judged);
  void addEvidence(Judged& judged);

  [[nodiscard]] const Requirement& requirementOf(const Judged& judged) const;

  StrategyContext& context_;
  std::optional<Premises> premises_;  ///< with StrategyContext::bare
  std::vector<Judged> judged_;        ///< by requirement
};

}  // namespace glider::ir::prove
