// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"

#include <toml++/toml.h>

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glider::platforms {

/// Strict reading of one TOML table: a missing, unknown or wrongly typed key is GL5001 with file
/// and line. The first failure is kept; later reads give default values, so a reader checks once at
/// its end.
class TomlReader {
 public:
  TomlReader(std::string file, const toml::table& table, std::string where)
      : file_(std::move(file)), table_(table), where_(std::move(where)) {}

  std::string text(std::string_view key);
  std::string textOr(std::string_view key, std::string fallback);
  double number(std::string_view key);
  double numberOr(std::string_view key, double fallback);
  /// A number of at least 0.
  double notNegative(std::string_view key);
  /// A number from 0 to 1.
  double share(std::string_view key);
  /// A list of finite numbers, which may be empty.
  std::vector<double> numbers(std::string_view key);
  int64_t integer(std::string_view key);
  bool flagOr(std::string_view key, bool fallback);
  /// A list of texts, which may be empty.
  std::vector<std::string> texts(std::string_view key);
  /// The same; an empty list if the key is not there.
  std::vector<std::string> textsOr(std::string_view key);
  /// Refuses keys that are not in `known`.
  void only(std::span<const std::string_view> known);
  void only(std::initializer_list<std::string_view> known) { only(std::span(known)); }
  /// Records a failure of the caller's own check of `key`.
  void refuse(std::string_view key, std::string_view why);

  [[nodiscard]] const std::optional<support::Failure>& failure() const { return failure_; }

 private:
  const toml::node* node(std::string_view key);
  void fail(const toml::node* at, std::string why);

  std::string file_;
  const toml::table& table_;
  std::string where_;
  std::optional<support::Failure> failure_;
};

/// Reads a table that may be missing, which then has no keys; `title` is for messages: "[power]".
TomlReader tableOf(std::string file, const toml::node_view<const toml::node>& node,
                   std::string title);

/// Whether missions and C can use `name`: letters, digits and `_`, a letter first.
bool isName(std::string_view name);

/// Parses a whole TOML file. GL9001, GL5001.
support::Result<toml::table> parseToml(const std::filesystem::path& path);

}  // namespace glider::platforms
