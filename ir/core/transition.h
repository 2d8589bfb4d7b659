// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <string_view>

/// What a case does, in which list it stands, and what a note is about: the numbers that the
/// mission reports to the vehicle.
namespace glider::ir {

enum class Transition : uint8_t {
#define TRANSITION(name, number, word) name = number,
#include "hooks/protocol/notices.def"
};

/// Whether the state stays current; otherwise it, or the mission, ends.
constexpr bool staysIn(Transition transition) {
  return transition == Transition::Stay || transition == Transition::Done;
}

/// The four lists of cases that a tick tries. All but Always belong to a state.
enum class ListKind : uint8_t {
#define CASE_LIST(name, number, word) name = number,
#include "hooks/protocol/notices.def"
};

enum class NoteKind : uint8_t {
#define NOTE_KIND(name, number, meaning) name = number,
#include "hooks/protocol/notices.def"
};

/// The words of the language for transitions, by their numbers.
inline constexpr auto kTransitionWords = std::to_array<std::string_view>({
#define TRANSITION(name, number, word) word,
#include "hooks/protocol/notices.def"
});
static_assert(kTransitionWords.size() == static_cast<size_t>(Transition::Done) + 1,
              "no number is left out");

/// "goto"
constexpr std::string_view wordOf(Transition transition) {
  return kTransitionWords.at(static_cast<size_t>(transition));
}

/// "always"
constexpr std::string_view wordOf(ListKind list) {
  switch (list) {
#define CASE_LIST(name, number, word) \
  case ListKind::name:                \
    return word;
#include "hooks/protocol/notices.def"
  }
  return "";
}

}  // namespace glider::ir
