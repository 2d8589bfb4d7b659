// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/requirements/strategy.h"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace glider::ir::prove {

class ContextUnderAssumptions;

/// Names the assumptions that proofs rest on.
class Premises {
 public:
  /// `context` outlives this, and has StrategyContext::bare.
  explicit Premises(StrategyContext& context);

  /// Names those of `proved`, a proof by `by`: of the assumptions on which it may rest, the ones
  /// without which none was found. The evidence then rests only on these.
  void name(RequirementVerdict& proved, const Strategy& by);

 private:
  bool isProvedUnder(const std::vector<uint32_t>& fewer, RequirementVerdict& proved);
  StrategyContext& under(const std::vector<uint32_t>& some);

  StrategyContext& context_;
  Budget budget_;
  std::map<std::vector<uint32_t>, std::shared_ptr<ContextUnderAssumptions>> under_some_;
};

}  // namespace glider::ir::prove
