// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_SEAT_NAP_H
#define GLIDER_HOOKS_SEAT_NAP_H

#include "hooks/protocol/nap.h"
#include "hooks/seat/reporter.h"
#include "hooks/seat/tick_ring.h"
#include "hooks/seat/watches.h"

/// Why the seat wakes the SBC: nap_ends.def.
#ifdef __cplusplus
enum class HookNapEnd : uint8_t {
#define NAP_END(name, number, why) name = number,
#include "hooks/seat/nap_ends.def"
};
#else
typedef uint8_t HookNapEnd;
enum {
#define NAP_END(name, number, why) kHookNapEnd##name = number,
#include "hooks/seat/nap_ends.def"
};
#endif

GLIDER_HOOKS_BEGIN

/// What becomes of Ticks while the SBC sleeps (protocol/README.md, "Naps"). Awake: nothing.
/// Asleep: they are kept. Waking, for the SBC's `wake_s`: the same. Then those in the ring go
/// first, and while there are any, newer ones are kept behind them. It begins with all bytes zero.
typedef struct HookNaps {
  HookNap nap;   ///< the newest order
  bool ordered;  ///< it was the last frame: the Done behind it begins it
  bool asleep, waking;
  bool beats;          ///< for the SBC, which has not answered since
  bool odd;            ///< the numbers of these beats; it changes from nap to nap
  double newest_s;     ///< vehicle time of the newest Tick that was kept, or of the start
  uint32_t session;    ///< that it does so for
  HookTickHead start;  ///< of the Tick that was answered; awake: the newest that was sent
  HookSince lasts;     ///< since the nap began; waking: since then
  /// Vehicle time of the newest report for each condition that waits for there to be none.
  double heard_s[kHookMostNapConditions];
  HookTickRing ring;
} HookNaps;

/// No link any more: nothing is kept, and the SBC is awake.
void hookNapsReset(HookNaps* naps);
/// The Done behind the order has come, of `session`, which is in control.
void hookNapsBegin(HookNaps* naps, uint32_t session, double now_s);
/// Whether an order of the SBC is within `most_s`, s, which the vehicle allows; NaN: unknown.
bool hookNapsAllow(const HookNap* nap, double most_s);
/// Whether the next Tick is kept.
bool hookNapsKeep(const HookNaps* naps);
/// Whether the nap ends by the Tick that `reporter` has just reported, with `head`.
HookNapEnd hookNapsEndBy(HookNaps* naps, const HookTickHead* head, const HookReporter* reporter,
                         double most_s);
/// Whether it has lasted too long by the clock of this computer, for any time of the vehicle.
bool hookNapsAreOver(HookNaps* naps, double now_s);
/// From now on the SBC wakes.
void hookNapsWake(HookNaps* naps, double now_s);
/// Whether kept Ticks may be sent: there are any, and the SBC has had its time to wake.
bool hookNapsMaySend(HookNaps* naps, double now_s);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using NapEnd = HookNapEnd;

/// "its nap is over"; null for a number of later versions.
constexpr const char* napEndText(uint32_t number) {
  switch (number) {
#define NAP_END(name, of, why) \
  case of:                     \
    return why;
#include "hooks/seat/nap_ends.def"
    default:
      return nullptr;
  }
}

}  // namespace glider::hooks
#endif

#endif
