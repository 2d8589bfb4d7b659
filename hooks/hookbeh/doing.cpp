// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/doing.h"

namespace glider::hooks {

const char* wordsFor(Doing doing) {
  switch (doing) {
#define DOING(name, words) \
  case Doing::name:        \
    return words;
#include "hooks/hookbeh/doings.def"
#define GUARD(name, number, words) \
  case Doing::name:                \
    return words;
#include "hooks/hookbeh/doings.def"
  }
  return "";
}

Doing climbFor(HookGuard guard) {
  switch (guard) {
    case HookGuard::None:
      break;
#define GUARD(name, number, words) \
  case HookGuard::name:            \
    return Doing::name;
#include "hooks/hookbeh/doings.def"
  }
  return Doing::Nothing;
}

bool isGuard(Doing doing) {
  switch (doing) {
#define DOING(name, words) \
  case Doing::name:        \
    return false;
#include "hooks/hookbeh/doings.def"
#define GUARD(name, number, words) \
  case Doing::name:                \
    return true;
#include "hooks/hookbeh/doings.def"
  }
  return false;
}

}  // namespace glider::hooks
