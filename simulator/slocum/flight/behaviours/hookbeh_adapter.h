// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/hookbeh.h"
#include "simulator/slocum/flight/behaviour.h"
#include "vehicles/slocum/mission_files/mission_file.h"

#include <string>
#include <vector>

namespace glider::simulator {

/// The b_args of a mission file's hookbeh.
hooks::HookbehArgs hookbehArgs(const slocum::BehaviourBlock& block);

/// The behaviour hookbeh in this layered control: hooks::Hookbeh between the sensor array and the
/// command record. It runs in every cycle because it has states of its own; it is complete when the
/// SBC has released control.
class HookbehAdapter final : public Behaviour {
 public:
  explicit HookbehAdapter(const BehaviourSource& source);
  [[nodiscard]] bool flies() const override { return true; }
  void tell(double time_s, Journal& journal) override;
  /// Of the newest cycle.
  [[nodiscard]] const hooks::HookbehOutputs& outputs() const { return outputs_; }
  [[nodiscard]] hooks::HookState hookState() const { return state_; }

 protected:
  [[nodiscard]] bool starts(const Situation&, const Commands&) const override { return true; }
  Outcome fly(const Situation& situation, Commands& commands) override;

 private:
  void note(const hooks::HookbehInputs& in, const hooks::HookbehOutputs& out);
  void noteAnswer(const hooks::HookbehInputs& in, const hooks::HookbehOutputs& out);

  hooks::HookbehArgs limits_;  ///< in effect
  hooks::Hookbeh hookbeh_;
  hooks::HookbehOutputs outputs_;
  hooks::HookState state_ = hooks::HookState::Waiting;
  uint8_t masked_now_ = 0;  ///< as last written to the journal
  uint16_t answered_ = 0;
  hooks::HookAnswer answer_ = hooks::HookAnswer::None;
  double garbled_since_s_ = 0;  ///< the words of `garbled_sequence_` do not fit together
  uint16_t garbled_sequence_ = 0;
  hooks::Doing doing_ = hooks::Doing::Nothing;
  std::vector<News> news_;
};

}  // namespace glider::simulator
