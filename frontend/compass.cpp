// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/compass.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

namespace glider::frontend {
namespace {

constexpr std::array<std::string_view, 16> kPoints = {"n",  "nne", "ne", "ene", "e",  "ese",
                                                      "se", "sse", "s",  "ssw", "sw", "wsw",
                                                      "w",  "wnw", "nw", "nnw"};

/// The words as one, in lower case: `South-East` as "southeast".
std::string inOneWord(std::string_view point) {
  std::string word;
  for (const char c : point) {
    if (std::string_view("-_ ").find(c) == std::string_view::npos) {
      word.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
    }
  }
  return word;
}

/// "se" of "southeast"; empty: it has other words.
std::optional<std::string> lettersOf(std::string_view word) {
  constexpr std::array<std::string_view, 4> kWords = {"north", "east", "south", "west"};
  std::string letters;
  while (!word.empty()) {
    const auto* first =
        std::ranges::find_if(kWords, [&](std::string_view one) { return word.starts_with(one); });
    if (first == kWords.end()) {
      return std::nullopt;
    }
    letters.push_back(first->front());
    word.remove_prefix(first->size());
  }
  return letters;
}

}  // namespace

std::string compassAngle(std::string_view point) {
  constexpr size_t kLongest = 24;  // `north-north-east`
  // Each name of a mission is looked at: almost all have another letter, soon.
  constexpr std::string_view kLetters = "nesworthauNESWORTHAU-_ ";
  if (point.size() > kLongest || point.find_first_not_of(kLetters) != std::string_view::npos) {
    return "";
  }
  const std::string word = inOneWord(point);
  const auto* found = std::ranges::find(kPoints, lettersOf(word).value_or(word));
  constexpr double kBetween_deg = 22.5;
  return word.empty() || found == kPoints.end()
             ? ""
             : fmt::format("{:g} deg", kBetween_deg * static_cast<double>(found - kPoints.begin()));
}

}  // namespace glider::frontend
