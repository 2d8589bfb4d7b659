// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace glider::frontend {

std::string inLowerCase(std::string_view word);

/// The number of letters to add, drop, change or swap with their neighbour to get from `a` to `b`.
size_t editDistance(std::string_view a, std::string_view b);

/// The candidate that the writer of `word` most likely meant; empty if none is near. For equal
/// distances it is the first.
std::string_view closest(std::string_view word, const std::vector<std::string_view>& candidates);

/// The candidate whose words `word` also has: `temp` for `temperature` and `water_temp`, `hover_at`
/// for `hover`; the longest one, and empty if there is none.
std::string_view related(std::string_view word, const std::vector<std::string_view>& candidates);

/// What to suggest for an unknown word.
struct Suggestion {
  std::string hint;
  std::string fix;  ///< the word that was certainly meant; empty: none
};

/// "did you mean `temp`?" for the candidate nearest to `word`, or `otherwise` if none is near. If
/// only capitals differ, from one candidate that has none, that one is certain.
Suggestion didYouMean(std::string_view word, const std::vector<std::string_view>& candidates,
                      std::string otherwise);

/// Whether the comma of `28,800`, with these digits before and after it, may group thousands.
bool mayBeThousands(std::string_view before, std::string_view after);

/// Numbers in words, from 0 on.
inline constexpr std::array<std::string_view, 13> kNumberWords = {
    "zero",  "one",   "two",  "three", "four",   "five",  "six",
    "seven", "eight", "nine", "ten",   "eleven", "twelve"};

/// The unit that a word such as "metres", "hours" or "C" means; empty if none.
std::string_view unitForWord(std::string_view word);

}  // namespace glider::frontend
