// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glider::frontend {

/// The number of letters to add, drop, change or swap with their neighbour to get from `a` to `b`.
size_t editDistance(std::string_view a, std::string_view b);

/// The candidate that the writer of `word` most likely meant; empty if none is near. For equal
/// distances it is the first.
std::string_view closest(std::string_view word, const std::vector<std::string_view>& candidates);

/// "did you mean `temp`?" for the candidate nearest to `word`, or `otherwise` if none is near.
std::string didYouMean(std::string_view word, const std::vector<std::string_view>& candidates,
                       std::string otherwise);

/// The unit that a word such as "metres", "hours" or "C" means; empty if none.
std::string_view unitForWord(std::string_view word);

}  // namespace glider::frontend
