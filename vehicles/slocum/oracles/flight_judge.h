// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/frame.h"
#include "hooks/protocol/instruction.h"
#include "hooks/protocol/sensor_list.h"
#include "simulator/campaign/judge.h"
#include "vehicles/slocum/oracles/ascent_judge.h"
#include "vehicles/slocum/oracles/battery_judge.h"
#include "vehicles/slocum/oracles/bottom_judge.h"
#include "vehicles/slocum/oracles/command_judge.h"
#include "vehicles/slocum/oracles/depth_judge.h"
#include "vehicles/slocum/oracles/guard_judge.h"
#include "vehicles/slocum/oracles/handshake_judge.h"
#include "vehicles/slocum/oracles/judge_setup.h"
#include "vehicles/slocum/oracles/needless_judge.h"
#include "vehicles/slocum/oracles/position_judge.h"
#include "vehicles/slocum/oracles/pump_judge.h"
#include "vehicles/slocum/oracles/stated_times.h"
#include "vehicles/slocum/oracles/surface_judge.h"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace glider::slocum::oracles {

/// Checks a flight by what the SBC sends, what hookbeh does and the true position of the vehicle,
/// all observed where no fault has an effect. Each instruction that is obeyed was sent exactly so;
/// none is obeyed twice; none that was sent is skipped; control ends when promised; the commands
/// are those of the instruction in force; limits of depth, clearance, position, pump and batteries
/// hold; the flight ends at the surface. The promises for its faults are in fault_kinds.def, the
/// checks in judges.def.
class FlightJudge final : public Judge {
 public:
  explicit FlightJudge(JudgeSetup setup);

  void said(std::span<const uint8_t> bytes, double now_s) override;
  bool cycle(const CycleView& view) override;
  [[nodiscard]] Verdict verdict() const override;

 private:
  using Words = hooks::InstructionWords;
  using Number = std::pair<double, double>;  ///< session, sequence

  void hear(const hooks::SensorList& write, double now_s);
  void hearDone(const hooks::Frame& frame, double now_s);
  void followRestart(const CycleView& view);
  void judgeAnswer(const CycleView& view);
  void judgeObeyed(const CycleView& view);
  void judgeSession(const CycleView& view, Number number, const Words& words);
  void judgeTimes(const CycleView& view);
  void judgeGarbled(const CycleView& view);
  [[nodiscard]] bool isOverForGood(const CycleView& view);
  void judgeAll(const CycleView& view);
  void noteHover(const CycleView& view);
  void violate(JudgeId judge, double now_s, std::string what);
  [[nodiscard]] std::string violationAtEnd() const;

  JudgeSetup setup_;
  DepthJudge depth_;
  CommandJudge commands_;
  GuardJudge guards_;
  NeedlessJudge needless_;
  BottomJudge bottom_;
  AscentJudge ascent_;
  BatteryJudge battery_;
  PumpJudge pump_;
  PositionJudge position_;
  SurfaceJudge surface_;
  HandshakeJudge handshake_;
  double last_end_s_;  ///< of the faults that end
  bool for_ever_;      ///< one ends control and does not end itself
  StatedTimes stated_;
  Verdict verdict_;

  hooks::FrameDecoder decoder_;
  std::map<Number, Words> said_;
  std::set<Number> obeyed_;
  Number newest_{0, 0};
  double newest_said_s_ = 0;
  bool newest_answered_ = true;
  double progress_s_ = 0;  ///< when the mission was last seen to make progress
  double mission_time_s_ = -1;
  uint32_t session_ = 0;

  hooks::HookState hook_ = hooks::HookState::Absent;
  Number decided_{0, 0};  ///< the newest instruction that hookbeh has answered
  double session_in_control_ = 0;
  double lost_session_ = 0;        ///< the newest that lost control
  Number answered_{0, 0};          ///< the newest instruction that hookbeh has answered for good
  double mission_s_ = 0;           ///< of the previous cycle
  uint32_t lost_while_whole_ = 0;  ///< releases before the first sensor was wrong
  bool exited_ = false, ended_ = false, at_surface_ = false;
  double garbled_since_s_ = -1;  ///< since when the instruction in the array cannot be read
  double up_since_s_ = -1;       ///< at the surface without the SBC
  double hovers_since_s_ = -1;
};

}  // namespace glider::slocum::oracles
