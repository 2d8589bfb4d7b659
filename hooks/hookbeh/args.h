// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_ARGS_H
#define GLIDER_HOOKS_HOOKBEH_ARGS_H

#include "hooks/protocol/language.h"

/// d_use_bpump and c_use_bpump, with the vehicle's codes. Any other code counts as Absolute.
#ifdef __cplusplus
enum class HookPumpMode : uint8_t {
  Autoballast = 0,  ///< the vehicle trims by itself: hookbeh commands the hull's whole stroke
  Absolute = 2,     ///< d_bpump_value, c_bpump_value
};
#else
typedef uint8_t HookPumpMode;
enum { kHookPumpModeAutoballast = 0, kHookPumpModeAbsolute = 2 };
#endif

GLIDER_HOOKS_BEGIN

/// The b_args, from the mission file: args.def says what each means.
typedef struct HookbehArgs {
#define ARG(name, usual) double name GLIDER_IS(usual);
#define PUMP_MODE(name, usual) HookPumpMode name GLIDER_IS(HookPumpMode::usual);
#include "hooks/hookbeh/args.def"
} HookbehArgs;

/// What they are without a mission file.
void hookbehUsualArgs(HookbehArgs* args);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using ::HookbehArgs;
using PumpMode = ::HookPumpMode;
}  // namespace glider::hooks
#endif

#endif
