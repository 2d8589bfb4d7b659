// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_VALUES_H
#define GLIDER_HOOKS_PROTOCOL_VALUES_H

#include "hooks/protocol/language.h"

/// The values that cross the hook, as they are in the vehicle's sensor array: values.def. In C
/// HookState is a number of one byte, with its values as kHookStateAbsent and so on.
#ifdef __cplusplus
enum class HookState : uint8_t {
#define HOOK_STATE(name, number) name = number,
#include "hooks/protocol/values.def"
};
enum class HookAnswer : uint8_t {
#define HOOK_ANSWER(name, number) name = number,
#include "hooks/protocol/values.def"
};
enum class HookControl : uint8_t {
#define HOOK_CONTROL(name, number) name = number,
#include "hooks/protocol/values.def"
};
enum class HookVertical : uint8_t {
#define HOOK_VERTICAL(name, number) name = number,
#include "hooks/protocol/values.def"
};
enum class HookLateral : uint8_t {
#define HOOK_LATERAL(name, number) name = number,
#include "hooks/protocol/values.def"
};
#else
typedef uint8_t HookState;
typedef uint8_t HookAnswer;
typedef uint8_t HookControl;
typedef uint8_t HookVertical;
typedef uint8_t HookLateral;
enum {
#define HOOK_STATE(name, number) kHookState##name = number,
#define HOOK_ANSWER(name, number) kHookAnswer##name = number,
#define HOOK_CONTROL(name, number) kHookControl##name = number,
#define HOOK_VERTICAL(name, number) kHookVertical##name = number,
#define HOOK_LATERAL(name, number) kHookLateral##name = number,
#include "hooks/protocol/values.def"
};
#endif

GLIDER_HOOKS_BEGIN

/// `x_hook_masked`, a sum: which of hookbeh's commands a behaviour above it replaced in the
/// previous cycle.
enum { kHookMaskedHeading = 1, kHookMaskedPitch = 2, kHookMaskedPump = 4 };

/// Whether a number on the line is a valid one of these values.
bool hookIsState(uint8_t value);
bool hookIsAnswer(uint8_t value);

/// The number after `sequence`: counts to 65535, then 1 again.
uint16_t hookNextSequence(uint16_t sequence);
/// True when `sequence` was given after `other`, wrapping at 65535: at most half the number range
/// (32767) ahead. 0 means none yet: every number is newer.
bool hookIsNewerSequence(uint16_t sequence, uint16_t other);

enum { kHookMostSession = 16777215 };  ///< exact in a float32 sensor

/// The session after `session`: counts to kHookMostSession, then 1 again.
uint32_t hookNextSession(uint32_t session);
/// True when `session` was opened after `other`, wrapping at kHookMostSession: less than half the
/// number range ahead. 0 means none yet: every session is newer.
bool hookIsNewerSession(uint32_t session, uint32_t other);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using ::HookAnswer;
using ::HookControl;
using ::HookLateral;
using ::HookState;
using ::HookVertical;
// Of the types that these have on the line.
inline constexpr uint32_t kMostSession = kHookMostSession;
inline constexpr uint8_t kMaskedHeading = kHookMaskedHeading, kMaskedPitch = kHookMaskedPitch,
                         kMaskedPump = kHookMaskedPump;
}  // namespace glider::hooks
#endif

#endif
