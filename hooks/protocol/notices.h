// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_NOTICES_H
#define GLIDER_HOOKS_PROTOCOL_NOTICES_H

#include "hooks/protocol/language.h"

/// The numbers in HookTransitionNotice and HookMissionNote, from notices.def.
#ifdef __cplusplus
enum class HookTransition : uint8_t {
#define TRANSITION(name, number, word) name = number,
#include "hooks/protocol/notices.def"
};
enum class HookCaseList : uint8_t {
#define CASE_LIST(name, number, word) name = number,
#include "hooks/protocol/notices.def"
};
enum class HookNoteKind : uint8_t {
#define NOTE_KIND(name, number, meaning) name = number,
#include "hooks/protocol/notices.def"
};

namespace glider::hooks {
using Transition = HookTransition;
using CaseList = HookCaseList;
using NoteKind = HookNoteKind;

/// The texts of the notes that the runtime itself writes.
#define NOTE_TEXT(name, text) inline constexpr const char* kNote##name = text;
#include "hooks/protocol/notices.def"

/// "goto"; null for a number of later versions.
constexpr const char* transitionWord(uint32_t number) {
  switch (number) {
#define TRANSITION(name, of, word) \
  case of:                         \
    return word;
#include "hooks/protocol/notices.def"
    default:
      return nullptr;
  }
}

}  // namespace glider::hooks
#else
typedef uint8_t HookTransition;
typedef uint8_t HookCaseList;
typedef uint8_t HookNoteKind;
enum {
#define TRANSITION(name, number, word) kHookTransition##name = number,
#define CASE_LIST(name, number, word) kHookCaseList##name = number,
#define NOTE_KIND(name, number, meaning) kHookNoteKind##name = number,
#include "hooks/protocol/notices.def"
};
#endif

#endif
