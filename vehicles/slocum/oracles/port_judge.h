// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/extctl/sentence.h"
#include "simulator/campaign/judge.h"
#include "simulator/scenario/scenario.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>

namespace glider::slocum {
struct MissionFile;
}  // namespace glider::slocum

namespace glider::slocum::oracles {

/// What a vehicle that is steered by its port keeps, with any program and any faults of the SBC and
/// its line. By itself: nothing.
struct PortPromise {
  double deepest_m = std::numeric_limits<double>::infinity();  ///< true depth
  double under_s =
      std::numeric_limits<double>::infinity();  ///< from one surfacing to the next, at most
  double cycle_s = 4;
  double mean_W = 0;         ///< of the flight without a fault
  bool may_abort = true;     ///< its faults abort the vehicle's mission
  bool sees_bottom = false;  ///< the altimeter receives an echo in nearly each cycle
};

/// The mission file of a vehicle that has a list of the sensors on its port; null: it has none.
const MissionFile* portFileIn(const simulator::Scenario& scenario);
/// The greatest depth that the program at that port commands, m; empty: it is not known.
std::optional<double> programDepthIn(const simulator::Scenario& scenario);

/// Checks a flight of such a vehicle by its true position, and by what the SBC writes, seen at its
/// own end of the line: depth, bottom, time under water, aborts.
class PortJudge final : public simulator::Judge {
 public:
  explicit PortJudge(const PortPromise& promise) : promise_(promise) {}

  void said(std::span<const uint8_t> bytes, double now_s) override;
  bool cycle(const simulator::CycleView& view) override;
  [[nodiscard]] simulator::Verdict verdict() const override;

 private:
  void hear(const char* pairs, uint32_t size, double now_s);
  void violate(simulator::JudgeId judge, double now_s, std::string what);

  PortPromise promise_;
  hooks::extctl::SentenceReader sentences_;
  simulator::Verdict verdict_;
  double dive_m_ = -1;    ///< the target that was written last; negative: none
  double up_s_ = 0;       ///< when the vehicle was last at the surface
  double floats_s_ = -1;  ///< since when it has been there; negative: it is not
  bool ended_ = false;    ///< the SBC's mission
};

}  // namespace glider::slocum::oracles
