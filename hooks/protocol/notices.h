// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// The numbers in TransitionNotice and MissionNote, from notices.def.
namespace glider::hooks {

enum class Transition : uint8_t {
#define TRANSITION(name, number, word) name = number,
#include "hooks/protocol/notices.def"
};

enum class CaseList : uint8_t {
#define CASE_LIST(name, number, word) name = number,
#include "hooks/protocol/notices.def"
};

enum class NoteKind : uint8_t {
#define NOTE_KIND(name, number, meaning) name = number,
#include "hooks/protocol/notices.def"
};

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
