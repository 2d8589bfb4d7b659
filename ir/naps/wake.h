// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <cstdint>
#include <vector>

/// When the SBC may sleep: what can make a tick do something else than the tick before.
namespace glider::ir {

enum class WakeKind : uint8_t {
  Nothing,  ///< nothing can
  Awake,    ///< what comes next cannot be foreseen: no sleep
  All,      ///< any of `parts`
  Branch,   ///< parts[0] if `test` is true now (or false, with `of_false`), else parts[1]
  Until,    ///< `left` and `right`, numbers that approach each other by 1 a second, meet
  Crossed,  ///< `sensor` passes the number `right`, or, while it is unknown, becomes known
  Known,    ///< `sensor`, if it is unknown, becomes known
  Lost,     ///< `sensor`, if it is known, becomes unknown
  Repeats,  ///< nothing, if case `number` of `list` fired in this tick; no sleep otherwise
  Keeps     ///< nothing, if `variable` has the value of `right` (no expression: is true); no sleep
            ///< otherwise
};

/// A tree that is evaluated after a tick. What it is about is that the next ticks leave everything
/// as this one did, except for clocks and for what windows collect.
struct Wake {
  /// WakeKind::Repeats: no case of the list fired.
  static constexpr uint32_t kNoCase = UINT32_MAX;

  WakeKind kind = WakeKind::Nothing;
  bool of_false = false;
  ListKind list = ListKind::Always;
  uint32_t number = kNoCase;
  ExprId test;
  ExprId left;
  ExprId right;
  SensorId sensor;
  VariableId variable;
  std::vector<Wake> parts;
  support::SourceRange range;  ///< of Awake: what cannot be foreseen
};

/// Of the ticks of a state that is current. Sound for every mission: what it does not understand is
/// Awake.
Wake wakeOf(const Mission& mission, StateId state);

/// The part of kind Awake that leaves no way to sleep while all sensors are known; where a test
/// leads to one either way, that of the way on which it does not hold. Null if there is a way.
const Wake* whatKeepsAwake(const Mission& mission, const Wake& wake);

/// Whether there is such a way.
bool maySleep(const Mission& mission, const Wake& wake);

}  // namespace glider::ir
