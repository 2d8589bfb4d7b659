// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/toml_reader.h"

#include <string_view>
#include <utility>
#include <vector>

namespace glider::platforms {

/// Which numbers a key may have.
enum class Least { AboveZero, Zero, None };

/// A number of a table and where it is stored.
template <typename T>
struct NumberKey {
  const char* key;
  double T::* field;
  Least least = Least::AboveZero;
};

/// Reads a table of numbers, all of them required; `others` are keys that it may also have.
template <typename T, size_t kCount>
T readNumbers(TomlReader& reader, const NumberKey<T> (&keys)[kCount],
              std::vector<std::string_view> others = {}) {
  std::vector<std::string_view> known = std::move(others);
  for (const NumberKey<T>& key : keys) {
    known.emplace_back(key.key);
  }
  reader.only(known);
  T numbers;
  for (const NumberKey<T>& key : keys) {
    const double number = numbers.*key.field = reader.number(key.key);
    if (key.least == Least::AboveZero && !(number > 0)) {
      reader.refuse(key.key, "must be above 0");
    }
    if (key.least == Least::Zero && !(number >= 0)) {
      reader.refuse(key.key, "must not be below 0");
    }
  }
  return numbers;
}

}  // namespace glider::platforms
