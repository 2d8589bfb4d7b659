// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/doing.h"

const char* hookWordsForDoing(HookDoing doing) {
  switch (doing) {
#define DOING(name, words) \
  case kHookDoing##name:   \
    return words;
#include "hooks/hookbeh/doings.def"
#define GUARD(name, number, words) \
  case kHookDoing##name:           \
    return words;
#include "hooks/hookbeh/doings.def"
  }
  return "";
}

HookDoing hookClimbFor(HookGuard guard) {
  switch (guard) {
    case kHookGuardNone:
      break;
#define GUARD(name, number, words) \
  case kHookGuard##name:           \
    return kHookDoing##name;
#include "hooks/hookbeh/doings.def"
  }
  return kHookDoingNothing;
}

bool hookIsGuard(HookDoing doing) {
  switch (doing) {
#define DOING(name, words) \
  case kHookDoing##name:   \
    return false;
#include "hooks/hookbeh/doings.def"
#define GUARD(name, number, words) \
  case kHookDoing##name:           \
    return true;
#include "hooks/hookbeh/doings.def"
  }
  return false;
}
