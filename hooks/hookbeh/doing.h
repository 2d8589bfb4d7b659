// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_DOING_H
#define GLIDER_HOOKS_HOOKBEH_DOING_H

#include "hooks/protocol/language.h"

/// What hookbeh does in a cycle, from doings.def. HookGuard is `x_hook_guard`: why hookbeh climbs
/// against any instruction of the SBC. HookDoing is the active sub-behaviour, or the guard for
/// which it climbs. In C both are numbers of one byte, with values as kHookGuardTooDeep.
#ifdef __cplusplus
enum class HookGuard : uint8_t {
  None = 0,
#define GUARD(name, number, words) name = number,
#include "hooks/hookbeh/doings.def"
};
enum class HookDoing : uint8_t {
#define DOING(name, words) name,
#include "hooks/hookbeh/doings.def"
#define GUARD(name, number, words) name,
#include "hooks/hookbeh/doings.def"
};
#else
typedef uint8_t HookGuard;
enum {
  kHookGuardNone = 0,
#define GUARD(name, number, words) kHookGuard##name = number,
#include "hooks/hookbeh/doings.def"
};
typedef uint8_t HookDoing;
enum {
#define DOING(name, words) kHookDoing##name,
#include "hooks/hookbeh/doings.def"
#define GUARD(name, number, words) kHookDoing##name,
#include "hooks/hookbeh/doings.def"
};
#endif

GLIDER_HOOKS_BEGIN

/// "dive_to", "climb: too deep"; "" for Nothing. For logs.
const char* hookWordsForDoing(HookDoing doing);
/// The climb for a guard; Nothing for None.
HookDoing hookClimbFor(HookGuard guard);
/// Whether it climbs for a guard.
bool hookIsGuard(HookDoing doing);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using ::HookGuard;
using Doing = ::HookDoing;
inline const char* wordsFor(Doing doing) {
  return hookWordsForDoing(doing);
}
}  // namespace glider::hooks
#endif

#endif
