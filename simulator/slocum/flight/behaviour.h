// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/values.h"
#include "simulator/journal.h"
#include "simulator/seat/masked.h"
#include "simulator/slocum/flight/commands.h"
#include "simulator/slocum/flight/situation.h"

#include <memory>
#include <string>

namespace glider::simulator {

struct BehaviourSource;

/// One behaviour of the mission. waiting → active → complete, or waiting again.
class Behaviour {
 public:
  enum class State : uint8_t { Waiting, Active, Complete };
  enum class Outcome : uint8_t { Continue, Done };

  explicit Behaviour(std::string name) : name_(std::move(name)) {}
  Behaviour(const Behaviour&) = delete;
  Behaviour& operator=(const Behaviour&) = delete;
  virtual ~Behaviour() = default;

  /// One control cycle: may start, fly and end.
  void run(const Situation& situation, Commands& commands);
  /// Called after each cycle: which slots of the command record are not this behaviour's, as
  /// hooks::kMaskedHeading….
  void noteMasked(uint8_t masked) { masked_ = masked; }

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Its name with its place in the mission file, as the vehicle writes it: "surface_2"; its name
  /// alone if it has no place.
  [[nodiscard]] std::string label() const;
  /// `place`: counted from 1.
  void setPlace(int place) { place_ = place; }
  /// Why it started last: its start code and what that means; "" for one without such a code.
  [[nodiscard]] const std::string& whyStarted() const { return why_started_; }
  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] uint8_t masked() const { return masked_; }
  /// True if another behaviour's pitch or pump was flown in the previous cycle.
  [[nodiscard]] bool overridden() const { return masksPitchOrPump(masked_); }
  /// True if it steers pitch and pump: a mission is over when no such behaviours are left except
  /// those that bring the vehicle up.
  [[nodiscard]] virtual bool flies() const { return false; }
  /// True while it is busy with work that must end before the mission may count as over.
  [[nodiscard]] virtual bool atWork() const { return false; }
  /// When the behaviour last had contact with an operator, by the antenna at the surface, s of the
  /// mission; 0, its start: not yet.
  [[nodiscard]] virtual double lastContact() const { return 0; }
  /// An abort that the behaviour calls for in this cycle, and why.
  [[nodiscard]] virtual Abort abort(std::string& /*why*/) const { return Abort::None; }
  /// True when its end ends the whole mission.
  [[nodiscard]] virtual bool endsMission() const { return false; }
  /// Lines for the trace since the last call: sub-behaviours, answers.
  virtual void tell(double /*time_s*/, Journal& /*journal*/) {}

 protected:
  [[nodiscard]] virtual bool starts(const Situation& situation, const Commands& below) const = 0;
  /// Why it starts; called when it does.
  [[nodiscard]] virtual std::string whyStarts(const Commands& /*below*/) const { return ""; }
  virtual void begin(const Situation& /*situation*/) {}
  /// Issues its commands. A behaviour that is done and should not fly in this cycle commands
  /// nothing.
  virtual Outcome fly(const Situation& situation, Commands& commands) = 0;
  /// After Done: true to wait for the next start (end_action 2), false for complete.
  [[nodiscard]] virtual bool resumes() const { return false; }
  virtual void ended(const Situation& /*situation*/) {}

 private:
  std::string name_;
  std::string why_started_;
  int place_ = 0;  ///< 0: none
  State state_ = State::Waiting;
  uint8_t masked_ = 0;
};

/// The behaviour that `source` describes; null for one that has no effect here. What `source`
/// refers to outlives it, except for the block.
std::unique_ptr<Behaviour> makeBehaviour(const BehaviourSource& source);

}  // namespace glider::simulator
