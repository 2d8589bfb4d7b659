// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/stack_state.h"

#include <algorithm>

namespace glider::codegen {
namespace {

/// The deeper of two; unknown if one is.
std::optional<int64_t> deeper(std::optional<int64_t> a, std::optional<int64_t> b) {
  return a && b ? std::optional(std::max(*a, *b)) : std::nullopt;
}

}  // namespace

StackState StackState::under(const StackEffect& effect) const {
  StackState met = *this;
  if (condition_.conditional() && effect.sameCondition(condition_)) {
    met.depths_[machine_->pointer] = conditional_;
    met.condition_ = {};
  } else {
    met.settle();
  }
  return met;
}

StackState StackState::passing(const StackEffect& effect) const {
  StackState met = *this;
  if (effect.sameCondition(condition_)) {
    met.condition_ = {};
  }
  met.settle();
  return met;
}

void StackState::settle() {
  if (condition_.conditional()) {
    depths_[machine_->pointer] = deeper(depth(), conditional_);
    condition_ = {};
  }
}

void StackState::change(const StackEffect& effect) {
  std::optional<int64_t> moved;
  if (effect.from != StackEffect::kNone && depths_[effect.from]) {
    moved = *depths_[effect.from] + effect.bytes;
  }
  for (uint8_t i = 0; i < machine_->count; ++i) {
    if ((effect.writes >> i & 1U) != 0 && i != machine_->pointer) {
      depths_[i].reset();
    }
  }
  if (!effect.known) {
    depths_[machine_->pointer].reset();
  } else if (effect.to != StackEffect::kNone) {
    depths_[effect.to] = moved;
  }
}

void StackState::apply(const StackEffect& effect) {
  if (!effect.conditional()) {
    settle();
    change(effect);
    return;
  }
  StackState taken = under(effect);
  taken.change(effect);
  if (!effect.sameCondition(condition_)) {
    settle();
  }
  for (uint8_t i = 0; i < machine_->count; ++i) {
    if (i != machine_->pointer) {
      depths_[i] = deeper(depths_[i], taken.depths_[i]);
    }
  }
  conditional_ = taken.depth();
  condition_ = effect;
}

void StackState::call(uint32_t released) {
  settle();
  for (uint8_t i = 0; i < machine_->count; ++i) {
    if ((machine_->lost >> i & 1U) != 0) {
      depths_[i].reset();
    }
  }
  auto& depth = depths_[machine_->pointer];
  depth = depth ? std::optional(*depth - released) : std::nullopt;
}

bool StackState::join(const StackState& other) {
  StackState both = *this, theirs = other;
  bool news = false;
  // Only consecutive instructions share a condition.
  if (condition_.conditional() != theirs.condition_.conditional() ||
      !condition_.sameCondition(theirs.condition_)) {
    both.settle();
    theirs.settle();
  } else if (condition_.conditional()) {
    both.conditional_ = deeper(conditional_, theirs.conditional_);
    news = both.conditional_ != conditional_;
  }
  news = news || both.condition_.conditional() != condition_.conditional();
  for (uint8_t i = 0; i < machine_->count; ++i) {
    both.depths_[i] = deeper(both.depths_[i], theirs.depths_[i]);
    news = news || both.depths_[i] != depths_[i];
  }
  *this = both;
  return news;
}

}  // namespace glider::codegen
