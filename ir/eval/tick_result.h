// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// The interpreter's report of a tick.
namespace glider::ir {

/// Why a behaviour runs.
enum class Phase : uint8_t { Enter, Resume, Tick };

/// Only cases of `always` with a smaller number may fire.
using Limit = uint32_t;
constexpr Limit kNoLimit = UINT32_MAX;

/// A state that waits for a return, with the mission time (s) at which it was entered.
struct Frame {
  StateId state;
  double entered = 0;
  Limit limit = kNoLimit;
  bool operator==(const Frame&) const = default;
};

/// A call of a C function of the current state with its arguments, SI units (positions: degrees);
/// NaN: unknown.
struct ActivityRun {
  ListKind list = ListKind::Profile;  ///< or Route
  BehaviourId behaviour;
  Phase phase = Phase::Tick;
  std::vector<double> arguments;
};

/// A command of the language, as ActivityRun.
struct CommandRun {
  Command command = Command::Surface;
  std::vector<double> arguments;
  bool refused = false;  ///< an argument is unknown: the command changes nothing
};

/// What was commanded, or may have been.
using Action = std::variant<CommandRun, ActivityRun>;

/// The note of a `log`, or of a `set` with an unknown value.
struct Note {
  NoteKind kind = NoteKind::Log;
  std::string text;            ///< or the variable's name
  std::vector<double> values;  ///< of a truth value 0 or 1; NaN: unknown
};

/// A case of one of the four lists.
struct CaseOf {
  ListKind list = ListKind::State;
  uint32_t number = 0;
  bool operator==(const CaseOf&) const = default;
};

/// What a tick did.
struct TickResult {
  StateId state;          ///< current after the tick
  bool finished = false;  ///< an `exit` has fired in this tick or earlier
  Limit limit = kNoLimit;
  bool just_returned = false;  ///< on the next tick the state's own cases are tried before `always`
  std::array<std::optional<uint32_t>, 4>
      fired;  ///< by ListKind: the case that fired, of the state in which it was tried
  std::optional<CaseOf> moved;    ///< whose transition ended the tick
  std::vector<Frame> stack;       ///< outermost first
  std::vector<double> variables;  ///< NaN: unknown; of a truth value 0 or 1
  std::vector<Action> actions;    ///< in the order in which they happened
  std::vector<Note> notes;
  uint32_t lost_notes = 0;
  double sampling = 0;  ///< how often instruments read, in force: a word of
                        ///< hooks/protocol/sampling.h

  [[nodiscard]] std::optional<uint32_t> firedIn(ListKind list) const {
    return fired.at(static_cast<size_t>(list));
  }
};

}  // namespace glider::ir
