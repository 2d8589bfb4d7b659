// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_NAP_TIMES_H
#define GLIDER_HOOKS_PROTOCOL_NAP_TIMES_H

#include "hooks/protocol/language.h"

/// How much later an SBC acts that has slept. hookprog wakes it on the tick on which the mission
/// may decide something; these two together bound how long that decision waits.
GLIDER_HOOKS_BEGIN

enum {
  kHookMostWakeSecs = 10,  ///< from the call until its program runs: a board that needs longer is
                           ///< refused (`wake_s` of its file)
  kHookReplaySecs = 5,     ///< then, until it has read all Ticks that hookprog has kept
  /// By so much hookbeh's nap_secs is longer than the longest nap: the SBC wakes, and the vehicle's
  /// line may lose the few heartbeats of the SBC itself that come between two naps.
  kHookAroundNapSecs = 40
};

GLIDER_HOOKS_END

#endif
