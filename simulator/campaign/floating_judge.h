// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/campaign/judge.h"

#include <deque>
#include <optional>
#include <string>

namespace glider::simulator {

/// What a vehicle keeps that floats up when its SBC is silent, with any program and any faults of
/// the SBC and its line.
struct FloatingPromise {
  double greatest_depth_m = 0;  ///< that it can be given
  double overshoot_m = 0;       ///< past a depth
  double lets_go_s = 0;         ///< from the last command until the propeller stops
  double turn_s = 0;            ///< from then until it floats up
  double rises_m_s = 0;         ///< at least so fast
};

/// Checks a flight of such a vehicle by its true depth and by what the SBC sends, seen at its own
/// end of the line: its depth against the deepest command, and that it rises when commands get
/// shallower or stop. A command may be lost: from its last one to a depth on the vehicle may fly to
/// it for `lets_go_s`. A family of vehicles adds how its commands are read: said().
class FloatingJudge : public Judge {
 public:
  bool cycle(const CycleView& view) override;
  [[nodiscard]] Verdict verdict() const override;

 protected:
  /// `command`: what a command is called.
  FloatingJudge(const FloatingPromise& promise, std::string command)
      : promise_(promise), command_(std::move(command)) {}

  /// A command to a depth; `whole`: nothing of what it needs is missing.
  void takeCommand(double depth_m, bool whole, double now_s);
  /// The SBC ends its control, or (`ends` false) does not.
  void takeEnd(bool ends, double now_s);

  /// The flight breaks what `judge` checks: `what`. Only the first time counts.
  void violate(JudgeId judge, double now_s, std::string what);

 private:
  /// A command, and when it was given.
  struct Told {
    double at_s;
    double depth_m;
  };
  std::optional<double> deepestInForce(double now_s);
  void checkAscent(const CycleView& view);

  FloatingPromise promise_;
  std::string command_;
  Verdict verdict_;
  double deepest_told_m_ = 0;
  double told_s_ = -1;     ///< the newest command; negative: none
  std::deque<Told> told_;  ///< those that may be in force and are deeper than all newer ones
  bool silent_ = false;    ///< none is in force any more
  double due_s_ = -1;      ///< when it was last no deeper than it may be; negative: no cycle yet
  double due_m_ = 0;       ///< how deep it was then
  double floats_s_ = -1;   ///< since when it is at the surface; negative: it is not
  bool ended_ = false;     ///< the SBC has ended its control
};

}  // namespace glider::simulator
