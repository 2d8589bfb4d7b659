// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/extctl/depth_state.h"

#include "hooks/protocol/numbers.h"

namespace glider::runtime::extctl {

void DepthState::report(double state) {
  state_ = hookIsFinite(depth_m_) ? state : __builtin_nan("");
  extreme_m_ = reached_m_ = depth_m_;
  reached_s_ = now_s_;
}

void DepthState::look(double depth_m, double now_s) {
  const bool back = now_s < now_s_;
  depth_m_ = depth_m;
  now_s_ = now_s;
  if (state_ == state_ && (back || !hookIsFinite(depth_m) || contradicts())) {
    state_ = __builtin_nan("");
  }
}

bool DepthState::contradicts() {
  if (state_ == kSurface) {
    return depth_m_ >= kDeepestSurface;
  }
  if (state_ != kDiving && state_ != kClimbing) {
    return true;
  }
  const double way = state_ == kDiving ? 1 : -1;
  extreme_m_ = way * hookAtLeast(way * depth_m_, way * extreme_m_);
  if (way * (depth_m_ - reached_m_) >= kProgress) {
    reached_m_ = depth_m_;
    reached_s_ = now_s_;
  }
  return way * (extreme_m_ - depth_m_) >= kBack || !(now_s_ - reached_s_ <= kProgressSecs);
}

}  // namespace glider::runtime::extctl
