// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

namespace glider::runtime::recon {

/// Whether the vehicle obeys us, by the mode in its states, and when it may be asked to (README.md,
/// rules N3 to N6). Times are by the vehicle's clock, s.
class Takeover {
 public:
  /// Takes the mode of a state.
  void take(uint8_t mode, double time_s);
  /// The vehicle obeys our commands.
  [[nodiscard]] bool follows() const { return state_ == State::Following; }
  /// It obeys somebody else, or its mission is over, for as long as the program runs.
  [[nodiscard]] bool isTaken() const { return state_ == State::Taken; }
  /// It may be asked for control.
  [[nodiscard]] bool mayBeAsked() const { return state_ == State::Ready || state_ == State::Lost; }

  /// Without a state for so long, our commands may not have arrived either, s.
  static constexpr double kSilenceSecs = 5;

 private:
  enum class State : uint8_t { Away, Ready, Following, Lost, Taken };
  [[nodiscard]] bool hasFlown() const { return state_ != State::Away && state_ != State::Ready; }

  State state_ = State::Away;
  double newest_s_ = __builtin_nan("");
  bool silent_ = false;  ///< states were missing since the vehicle last said that it obeys
};

}  // namespace glider::runtime::recon
