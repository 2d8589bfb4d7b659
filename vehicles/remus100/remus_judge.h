// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/recon/line_reader.h"
#include "simulator/campaign/floating_judge.h"

#include <cstdint>
#include <span>

namespace glider::remus100 {

/// Checks a flight by the goals that the SBC sends, and by its requests to end the override. Goals
/// must come in threes: heading, speed and depth. With such a request come goals of the surface,
/// and after it no goal under water.
class RemusJudge final : public simulator::FloatingJudge {
 public:
  explicit RemusJudge(const simulator::FloatingPromise& promise) : FloatingJudge(promise, "goal") {}

  void said(std::span<const uint8_t> bytes, double now_s) override;

 private:
  void hear(const hooks::recon::Line& line, double now_s);

  hooks::recon::LineReader lines_;
  bool heading_ = false, speed_ = false;  ///< came since the newest depth
  bool surface_ = false;  ///< the newest goals are the surface, and newer than the newest request
  bool let_go_ = false;   ///< the program has asked for the end of the override
};

}  // namespace glider::remus100
