// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/glider_abi.h"
#include "runtime/abi/leg.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime {

/// What a window over a leg keeps: memory[0…]. `Part` is what it keeps of one leg, with the
/// functions clear(), take(value, at), finish() at the end of the leg, and worth(kind).
template <typename Part>
struct LegMemory {
  double value;
  double since;  ///< mission time of the start, s
  double phase;  ///< of the newest tick on which it was known; unknown before the first
  double time;   ///< of that tick, s
  double whole;  ///< 1: the present leg has been watched since it began
  double begun;  ///< the number of legs that have begun
  double odd;    ///< 1: parts[1] is of the present leg, and parts[0] of the last; 0: the other way
  Part parts[2];

  Part& present() { return parts[odd != 0.0 ? 1 : 0]; }
  Part& last() { return parts[odd != 0.0 ? 0 : 1]; }
};

template <typename Part>
class LegWindow {
 public:
  LegWindow(double* memory, const GliderLegShape& shape)
      : memory_(*reinterpret_cast<LegMemory<Part>*>(memory)), shape_(shape) {}

  static void start(double* memory, double time) {
    auto& window = *reinterpret_cast<LegMemory<Part>*>(memory);
    window.value = window.phase = unknown();
    window.since = window.time = time;
    window.whole = window.begun = window.odd = 0.0;
    window.present().clear();
    window.last().clear();
  }

  /// A tick: gliderLegAdvance.
  void advance(double time, double phase, double value, double at, bool fresh) {
    if (phase != phase) {
      memory_.value = unknown();
      return;
    }
    const bool starts = time == memory_.since;
    starts ? void(memory_.phase = phase) : follow(time, phase);
    if (!starts && fresh && isLeg(phase) && value == value && at == at) {
      memory_.present().take(value, at);
    }
    memory_.value = starts ? unknown() : worth();
  }

 private:
  void follow(double time, double phase) {
    const bool watched = gliderSettle(time - memory_.time) <= GLIDER_LEG_GAP_S;
    if (!watched) {
      forget();
    }
    if (!isLeg(phase)) {
      memory_.present().finish();
    } else if (phase != memory_.phase) {
      begin(watched);
    }
    memory_.phase = phase;
    memory_.time = time;
  }

  bool isLeg(double phase) const { return phase == shape_.dive || phase == shape_.climb; }

  double worth() const {
    if (shape_.kind == kGliderLegNumber) {
      return memory_.begun;
    }
    const auto kind = static_cast<GliderLegKind>(shape_.kind);
    return (shape_.last != 0 ? memory_.last() : memory_.present()).worth(kind);
  }

  /// Legs may have come and gone that were not watched: no leg is certainly the one before.
  void forget() {
    memory_.whole = 0.0;
    memory_.present().clear();
    memory_.last().clear();
  }

  /// A leg that was under way when the state of the vehicle became known is not counted, nor whole.
  void begin(bool watched) {
    if (memory_.whole == 1.0) {
      memory_.present().finish();
      memory_.odd =
          memory_.odd == 0.0 ? 1.0 : 0.0;  // nothing is copied: a copy is a loop on some boards
    } else {
      memory_.last().clear();
    }
    memory_.present().clear();
    memory_.whole = watched && isKnown(memory_.phase) ? 1.0 : 0.0;
    memory_.begun += isKnown(memory_.phase) ? 1.0 : 0.0;
  }

  LegMemory<Part>& memory_;
  const GliderLegShape& shape_;
};

}  // namespace glider::runtime
