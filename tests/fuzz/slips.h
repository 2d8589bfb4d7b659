// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace glider::fuzz {

/// A mission with one slip of a pilot.
struct Slipped {
  std::string kind;  ///< "token deleted"
  std::string text;
  size_t begin = 0;  ///< the place of the slip, in `text`
  size_t end = 0;
};

/// A mission's text as words, numbers and signs, without its comments.
class Tokens {
 public:
  explicit Tokens(const std::string& text);
  struct Token {
    size_t begin = 0;
    size_t end = 0;
  };
  [[nodiscard]] const std::vector<Token>& all() const { return all_; }
  [[nodiscard]] std::string_view text(size_t number) const;

 private:
  const std::string& text_;
  std::vector<Token> all_;
};

/// One slip at a place that `random` chooses; none: the chosen kind has no place in this mission.
std::optional<Slipped> slip(const std::string& mission, std::mt19937_64& random);

}  // namespace glider::fuzz
