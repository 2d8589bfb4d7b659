// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/campaign/judge.h"

#include <functional>
#include <memory>
#include <utility>

namespace glider::campaign {

/// Checks a flight as the vehicle's family does, until the campaign is stopped.
class StoppableJudge final : public simulator::FlightObserver {
 public:
  /// `stop` may be empty, and outlives this.
  StoppableJudge(std::unique_ptr<simulator::Judge> judge, const std::function<bool()>& stop)
      : judge_(std::move(judge)), stop_(stop) {}
  void said(std::span<const uint8_t> bytes, double now_s) override { judge_->said(bytes, now_s); }
  bool cycle(const simulator::CycleView& view) override {
    return judge_->cycle(view) && !(stop_ && stop_());
  }
  [[nodiscard]] simulator::Verdict verdict() const { return judge_->verdict(); }

 private:
  std::unique_ptr<simulator::Judge> judge_;
  const std::function<bool()>& stop_;
};

}  // namespace glider::campaign
