// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/packet_reader.h"
#include "simulator/campaign/judge.h"

#include <cstdint>
#include <span>
#include <string>

namespace glider::lauv {

/// What a LAUV keeps, with any program and any faults of the SBC and its line.
struct LauvPromise {
  double greatest_depth_m = 0;  ///< that it can be given
  double overshoot_m = 0;       ///< past a depth
  double lets_go_s = 0;         ///< from the last Reference until the propeller stops
  double turn_s = 0;            ///< from then until it floats up
  double rises_m_s = 0;         ///< at least so fast
};

/// Checks a flight by the vehicle's true depth and by what the SBC sends, seen at its own end of
/// the line: its depth against the deepest Reference, References beyond the vehicle's limits, and
/// that it floats up when they stop.
class LauvJudge final : public simulator::Judge {
 public:
  explicit LauvJudge(const LauvPromise& promise) : promise_(promise) {}

  void said(std::span<const uint8_t> bytes, double now_s) override;
  bool cycle(const simulator::CycleView& view) override;
  [[nodiscard]] simulator::Verdict verdict() const override;

 private:
  void hear(const hooks::imc::Packet& packet, double now_s);
  void violate(simulator::JudgeId judge, double now_s, std::string what);
  void checkSilence(const simulator::CycleView& view);

  LauvPromise promise_;
  hooks::imc::PacketReader packets_;
  simulator::Verdict verdict_;
  double deepest_told_m_ = 0;
  double told_s_ = -1;  ///< the newest Reference; negative: none
  double stopped_m_ =
      -1;  ///< the depth when the propeller must have stopped; negative: it need not
  double stopped_s_ = 0;
  double floats_s_ = -1;  ///< since when it is at the surface; negative: it is not
  bool ended_ = false;    ///< the SBC has ended the plan
};

}  // namespace glider::lauv
