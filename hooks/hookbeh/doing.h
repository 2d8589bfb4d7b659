// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// What hookbeh does in a cycle, from doings.def.
namespace glider::hooks {

/// `x_hook_guard`: why hookbeh climbs against any instruction of the SBC.
enum class HookGuard : uint8_t {
  None = 0,
#define GUARD(name, number, words) name = number,
#include "hooks/hookbeh/doings.def"
};

/// The active sub-behaviour, or the guard for which it climbs.
enum class Doing : uint8_t {
#define DOING(name, words) name,
#include "hooks/hookbeh/doings.def"
#define GUARD(name, number, words) name,
#include "hooks/hookbeh/doings.def"
};

/// "dive_to", "climb: too deep"; "" for Nothing. For logs.
const char* wordsFor(Doing doing);
/// The climb for a guard; Nothing for None.
Doing climbFor(HookGuard guard);
/// Whether it climbs for a guard.
bool isGuard(Doing doing);

}  // namespace glider::hooks
