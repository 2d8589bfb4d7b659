// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviours/started.h"

#include <string>

namespace glider::simulator {

/// mission_ender: ends the mission when it starts.
class MissionEnder final : public StartedBehaviour {
 public:
  explicit MissionEnder(const BehaviourSource& source) : StartedBehaviour(source, false) {}
  [[nodiscard]] bool endsMission() const override { return state() == State::Complete; }

 protected:
  Outcome fly(const Situation& /*situation*/, Commands& /*commands*/) override {
    return Outcome::Done;
  }
};

/// oob_abort: the abort of a vehicle whose software no longer answers, for tests of the vehicle.
class OutOfBandAbort final : public StartedBehaviour {
 public:
  explicit OutOfBandAbort(const BehaviourSource& source) : StartedBehaviour(source, false) {}
  [[nodiscard]] Abort abort(std::string& why) const override {
    if (state() != State::Complete) {
      return Abort::None;
    }
    why = "the behaviour oob_abort calls for it";
    return Abort::OutOfBand;
  }

 protected:
  Outcome fly(const Situation& /*situation*/, Commands& /*commands*/) override {
    return Outcome::Done;
  }
};

}  // namespace glider::simulator
