// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/phrases/phrase.h"

#include <optional>
#include <string>
#include <vector>

/// The parts of a line `choose`, by the words that lead them. In a right line a name never follows
/// a whole value, so a word there leads a part, even if it is also a name.
namespace glider::frontend::phrases {

/// In the order in which they are written.
enum class Part : uint8_t { Type, Value, Range, Step, Condition, Launch };

/// A part of a line `choose`: `by 5 m`.
struct Clause {
  Part part = Part::Type;
  size_t first = 0;   ///< its first token
  size_t value = 0;   ///< the first token after the words that lead it
  size_t end = 0;     ///< past its last token
  bool right = true;  ///< whether those words are the right ones
};

/// Whether an item may begin here: the one before is whole, and the token begins its line.
bool mayBeginItem(const Phrase& phrase);

/// Past the value that begins with token `k`: up to what cannot belong to it. In a range, what may
/// stand between its ends is a part of it.
size_t endOfValue(const Phrase& phrase, size_t k, bool range);

/// The parts of a line `choose` from token `first` on, right after the name.
std::vector<Clause> clausesOf(const Phrase& phrase, size_t first);

/// The tokens of the two ends of a range, and what is between them.
struct Ends {
  size_t low = 0;
  size_t low_end = 0;
  size_t high = 0;
  size_t high_end = 0;
  bool right = true;  ///< `..` is between them, and nothing around them

  /// `60 m .. 180 m`; a unit that is written once is that of both: `60 - 180 m`.
  [[nodiscard]] std::string text(const Phrase& phrase) const;
  /// The unit that only the higher end has; 0: none.
  [[nodiscard]] size_t sharedUnit(const Phrase& phrase) const;
};

/// The ends of the range that is written in tokens `first` to `end`; empty: it is none.
std::optional<Ends> endsOf(const Phrase& phrase, size_t first, size_t end);

}  // namespace glider::frontend::phrases
