// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_tables/log_units.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace glider::slocum {
namespace {

/// Other spellings of a unit. Flags, codes and counts have no unit that could differ.
constexpr std::pair<std::string_view, std::string_view> kSpellings[] = {
    {"sec", "s"},         {"secs", "s"},      {"seconds", "s"},  {"hour", "h"},
    {"hours", "h"},       {"minutes", "min"}, {"volts", "v"},    {"volt", "v"},
    {"amps", "a"},        {"amp", "a"},       {"c", "degc"},     {"deg_c", "degc"},
    {"celsius", "degc"},  {"watts", "w"},     {"inches", "in"},  {"meters", "m"},
    {"rad/s", "rad/sec"}, {"bool", "nodim"},  {"enum", "nodim"}, {"byte", "nodim"},
    {"int", "nodim"},     {"x", "nodim"},     {"", "nodim"},     {"1", "nodim"},
};

struct Scale {
  std::string_view unit;
  char quantity;
  double size;
};

constexpr Scale kScales[] = {
    {"bar", 'p', 1e5},
    {"dbar", 'p', 1e4},
    {"mbar", 'p', 1e2},
    {"kpa", 'p', 1e3},
    {"pa", 'p', 1},
    {"psi", 'p', 6894.757},
    {"m", 'l', 1},
    {"cm", 'l', 0.01},
    {"km", 'l', 1000},
    {"ft", 'l', 0.3048},
    {"in", 'l', 0.0254},
    {"rad", 'a', 1},
    {"deg", 'a', std::numbers::pi / 180},
    {"s/m", 'c', 1},
    {"ms/cm", 'c', 0.1},
    {"v", 'v', 1},
    {"mv", 'v', 1e-3},
    {"s", 't', 1},
    {"min", 't', 60},
    {"h", 't', 3600},
    {"m/s", 'r', 1},
    {"cm/s", 'r', 0.01},
    {"a", 'i', 1},
    {"ma", 'i', 1e-3},
};

const Scale* scaleOf(std::string_view unit) {
  const std::string plain = plainUnit(unit);
  const auto* found = std::ranges::find(kScales, plain, &Scale::unit);
  return found == std::end(kScales) ? nullptr : found;
}

}  // namespace

std::string plainUnit(std::string_view unit) {
  std::string plain(unit);
  std::ranges::transform(plain, plain.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  });
  for (const auto& [other, one] : kSpellings) {
    if (plain == other) {
      return std::string(one);
    }
  }
  return plain;
}

std::optional<double> factorBetween(std::string_view from, std::string_view to) {
  if (plainUnit(from) == plainUnit(to)) {
    return 1;
  }
  const Scale *a = scaleOf(from), *b = scaleOf(to);
  return a != nullptr && b != nullptr && a->quantity == b->quantity
             ? std::optional(a->size / b->size)
             : std::nullopt;
}

}  // namespace glider::slocum
