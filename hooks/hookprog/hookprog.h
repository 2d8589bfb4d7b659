// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKPROG_HOOKPROG_H
#define GLIDER_HOOKS_HOOKPROG_HOOKPROG_H

#include "hooks/hookprog/cycle_watch.h"
#include "hooks/protocol/values.h"
#include "hooks/seat/seat.h"
#include "hooks/transport/byte_stream.h"

/// The proglet `hookprog` on the science computer: proxy of the SBC (115200 baud) for the vehicle's
/// sensors. Portable: no heap, no libc. It writes nothing until the flight controller reports a
/// hookbeh.
GLIDER_HOOKS_BEGIN

/// The data memory of the science computer: its own sensors, and those of the flight controller as
/// far as they have come over the vehicle's own line.
typedef struct HookScienceMemory {
  void* self;
  /// The newest value of sensor `id`; NaN if never set. Sets `fresh` if it was updated since the
  /// last call for this sensor.
  double (*get)(void* self, uint16_t id, bool* fresh);
  /// Sets a sensor of the science computer, which the vehicle takes to the flight controller: with
  /// six decimals, in its own time, and in any order.
  void (*set)(void* self, uint16_t id, double value);
} HookScienceMemory;

enum {
  /// Complete flight cycles in a row without x_hook_state after which the vehicle's mission has no
  /// hookbeh: hookbeh reports in each cycle, but lines lose frames.
  kHookprogMostCyclesWithoutHookbeh = 6,
  /// The same after mission time and cycle number have gone back, as they do when another mission
  /// starts.
  kHookprogMostCyclesOfAnotherMission = 2,
  /// s. The sensors of a flight cycle arrive in any order: a cycle is complete when its time and
  /// number are there and nothing of it has come for the first time; when something comes all the
  /// time, after the second.
  kHookprogSettledSecs = 1,
  kHookprogMostUnsettledSecs = 3
};

/// The seat of the SBC on a Slocum: it reads and writes sensors of the science computer's memory.
/// Only hookprog.c uses its fields.
typedef struct Hookprog {
  const GliderDictionary* dictionary;
  HookSeat seat;
  const HookScienceMemory* memory;  ///< during hookprogRun

  // The flight controller's data memory, as far as it has been reported.
  double values[GLIDER_MOST_SENSORS];
  bool fresh[GLIDER_MOST_SENSORS];
  bool time_is_new;
  bool cycle_is_new;
  HookSince settled;    ///< since something of the flight controller has come
  HookSince unsettled;  ///< since time and number of a cycle are there
  bool waits;           ///< for the rest of that cycle
  HookprogCycleWatch cycles;
  double cycle_time_s;    ///< mission time of the newest complete cycle
  uint32_t cycle_number;  ///< its number
  // hookbeh's newest answer: number and answer came in the same cycle.
  uint32_t answered_sequence;
  HookAnswer answer;
  bool sampled;  ///< the word of the instruments may not be 0
  uint32_t cycles_without_hookbeh;
  uint32_t most_without_hookbeh;
} Hookprog;

/// At the start of the science computer. `dictionary` outlives it, and has all required roles.
void hookprogInit(Hookprog* hookprog, const GliderDictionary* dictionary,
                  const HookSeatOptions* options);
/// One science cycle (1 s): takes the flight controller's updates, serves the SBC, writes what it
/// instructs. `science_time_s`: s by a clock that goes on while the computer restarts, such as s
/// since 1970 (the heartbeat begins with it, and hookbeh ignores one that is behind); it may be set
/// back. `sbc`: the line to the SBC.
void hookprogRun(Hookprog* hookprog, double science_time_s, const HookScienceMemory* memory,
                 const GliderByteStream* sbc);
/// False while the SBC sleeps: a line that wakes it, as a level, follows this. HookSeat says more.
bool hookprogWantsSbc(const Hookprog* hookprog);
/// Takes the oldest event. False, and an event without a kind, when there is none.
bool hookprogNextEvent(Hookprog* hookprog, HookSeatEvent* event);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using ScienceMemory = HookScienceMemory;

/// ::Hookprog.
class Hookprog {
 public:
  explicit Hookprog(const GliderDictionary& dictionary, const SeatOptions& options = {}) {
    hookprogInit(&hookprog_, &dictionary, &options);
  }
  void run(double science_time_s, const ScienceMemory& memory, const GliderByteStream& sbc) {
    hookprogRun(&hookprog_, science_time_s, &memory, &sbc);
  }
  SeatEvent nextEvent() {
    SeatEvent event;
    (void)hookprogNextEvent(&hookprog_, &event);
    return event;
  }
  [[nodiscard]] bool wantsSbc() const { return hookprogWantsSbc(&hookprog_); }
  /// The mission's last heartbeat, for the trace.
  [[nodiscard]] const SbcView& sbc() const { return hookprog_.seat.view; }

 private:
  ::Hookprog hookprog_;
};

}  // namespace glider::hooks
#endif

#endif
