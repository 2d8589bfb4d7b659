// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/toml_reader.h"

#include "support/diagnostics/ids/vehicle.h"
#include "support/files.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::platforms {

const toml::node* TomlReader::node(std::string_view key) {
  const toml::node* found = table_.get(key);
  if (found == nullptr) {
    fail(&table_, fmt::format("{} has no `{}`", where_, key));
  }
  return found;
}

void TomlReader::fail(const toml::node* at, std::string why) {
  if (!failure_) {
    const auto line = at != nullptr ? at->source().begin.line : 0;
    failure_ =
        support::fail(support::diagnostics::badDataFile, fmt::format("{}:{}", file_, line), why)
            .error();
  }
}

void TomlReader::refuse(std::string_view key, std::string_view why) {
  const toml::node* at = table_.get(key);
  fail(at != nullptr ? at : &table_, fmt::format("`{}` of {} {}", key, where_, why));
}

std::string TomlReader::text(std::string_view key) {
  const toml::node* found = node(key);
  const auto value = found != nullptr ? found->value_exact<std::string>() : std::nullopt;
  if (found != nullptr && !value) {
    refuse(key, "must be a string");
  }
  return value.value_or("");
}

std::string TomlReader::textOr(std::string_view key, std::string fallback) {
  return table_.contains(key) ? text(key) : std::move(fallback);
}

double TomlReader::number(std::string_view key) {
  const toml::node* found = node(key);
  const auto value = found != nullptr ? found->value<double>() : std::nullopt;
  if (found != nullptr && (!value || !found->is_number() || !(*value - *value == 0))) {
    refuse(key, "must be a finite number");
    return 0;
  }
  return value.value_or(0);
}

double TomlReader::numberOr(std::string_view key, double fallback) {
  return table_.contains(key) ? number(key) : fallback;
}

double TomlReader::notNegative(std::string_view key) {
  const double found = number(key);
  if (!(found >= 0)) {
    refuse(key, "must not be below 0");
  }
  return found;
}

double TomlReader::share(std::string_view key) {
  const double found = number(key);
  if (!(found >= 0 && found <= 1)) {
    refuse(key, "must be between 0 and 1, a share of the number");
  }
  return found;
}

std::vector<double> TomlReader::numbers(std::string_view key) {
  const toml::node* found = node(key);
  const toml::array* list = found != nullptr ? found->as_array() : nullptr;
  std::vector<double> numbers;
  for (size_t i = 0; list != nullptr && i < list->size(); ++i) {
    const auto value = list->get(i)->value<double>();
    if (value && list->get(i)->is_number() && *value - *value == 0) {
      numbers.push_back(*value);
    }
  }
  if (found != nullptr && (list == nullptr || numbers.size() != list->size())) {
    refuse(key, "must be a list of finite numbers");
  }
  return numbers;
}

int64_t TomlReader::integer(std::string_view key) {
  const toml::node* found = node(key);
  const auto value = found != nullptr ? found->value_exact<int64_t>() : std::nullopt;
  if (found != nullptr && !value) {
    refuse(key, "must be a whole number");
  }
  return value.value_or(0);
}

bool TomlReader::flagOr(std::string_view key, bool fallback) {
  const toml::node* found = table_.get(key);
  const auto value = found != nullptr ? found->value_exact<bool>() : std::optional(fallback);
  if (!value) {
    refuse(key, "must be true or false");
  }
  return value.value_or(fallback);
}

std::vector<std::string> TomlReader::textsOr(std::string_view key) {
  return table_.contains(key) ? texts(key) : std::vector<std::string>();
}

std::vector<std::string> TomlReader::texts(std::string_view key) {
  const toml::node* found = node(key);
  const toml::array* list = found != nullptr ? found->as_array() : nullptr;
  std::vector<std::string> texts;
  for (size_t i = 0; list != nullptr && i < list->size(); ++i) {
    if (const auto text = list->get(i)->value_exact<std::string>()) {
      texts.push_back(*text);
    }
  }
  if (found != nullptr && (list == nullptr || texts.size() != list->size())) {
    refuse(key, "must be a list of strings");
  }
  return texts;
}

void TomlReader::only(std::span<const std::string_view> known) {
  for (const auto& [key, value] : table_) {
    if (std::ranges::find(known, key.str()) == known.end()) {
      fail(&value, fmt::format("{} has an unknown key `{}`", where_, key.str()));
    }
  }
}

TomlReader tableOf(std::string file, const toml::node_view<const toml::node>& node,
                   std::string title) {
  static const toml::table kNone;
  const toml::table* table = node.as_table();
  return {std::move(file), table != nullptr ? *table : kNone, std::move(title)};
}

bool isName(std::string_view name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && letter(name.front()) && std::ranges::all_of(name, [&](char c) {
    return letter(c) || (c >= '0' && c <= '9') || c == '_';
  });
}

support::Result<toml::table> parseToml(const std::filesystem::path& path) {
  auto text = support::readFile(path);
  if (!text) {
    return std::unexpected(text.error());
  }
  try {
    return toml::parse(*text, path.string());
  } catch (const toml::parse_error& error) {
    return support::fail(support::diagnostics::badDataFile,
                         fmt::format("{}:{}", path.string(), error.source().begin.line),
                         std::string(error.description()));
  }
}

}  // namespace glider::platforms
