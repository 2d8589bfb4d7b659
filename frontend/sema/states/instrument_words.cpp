// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/states/instrument_words.h"

#include "support/listed.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace glider::frontend {
namespace {

/// `all off`: each instrument with what is said of it.
std::string eachOf(const platforms::Platform& platform, const std::string& how) {
  std::string text;
  for (const platforms::Instrument& one : platform.instruments) {
    text +=
        fmt::format("{}{}{}{}", text.empty() ? "" : ", ", one.name, how.empty() ? "" : " ", how);
  }
  return text;
}

/// Whether `word` is a part of a name such as `sci_flbbcd_chlor_units`.
bool isPartOf(const std::string& name, const std::string& word) {
  return ("_" + name + "_").contains("_" + word + "_");
}

/// The only instrument for which that is so; null: none, or several.
const platforms::Instrument* named(const platforms::Platform& platform, const std::string& word) {
  constexpr std::array<std::string_view, 6> kOfAll = {"sci", "water", "units", "on", "c", "m"};
  const platforms::Instrument* found = nullptr;
  for (const platforms::Instrument& one : platform.instruments) {
    const bool part = std::ranges::any_of(
        one.sensors, [&](const std::string& sensor) { return isPartOf(sensor, word); });
    if (one.vehicle_name == word || (part && std::ranges::find(kOfAll, word) == kOfAll.end())) {
      if (found != nullptr) {
        return nullptr;
      }
      found = &one;
    }
  }
  return found;
}

}  // namespace

std::string instrumentsOf(const platforms::Platform& platform) {
  std::vector<std::string> all;
  for (const platforms::Instrument& one : platform.instruments) {
    all.push_back(fmt::format("`{}`", one.name));
  }
  return support::listed(all);
}

Suggestion insteadOfInstrument(const std::string& word, const std::string& how,
                               const platforms::Platform& platform) {
  constexpr std::array<std::string_view, 6> kAll = {"all",      "everything", "instruments",
                                                    "everyone", "each",       "science"};
  const std::string lower = inLowerCase(word);
  const bool none = lower == "none" || lower == "nothing";
  if (none || std::ranges::find(kAll, lower) != kAll.end() || lower.contains(' ')) {
    return {fmt::format("name each of them: `{}`", eachOf(platform, none ? "off" : how)), ""};
  }
  if (const platforms::Instrument* one = named(platform, lower)) {
    return {fmt::format("write `{}`", one->name), one->name};
  }
  std::vector<std::string_view> names;
  std::ranges::transform(platform.instruments, std::back_inserter(names),
                         &platforms::Instrument::name);
  return didYouMean(word, names, "missions can switch " + instrumentsOf(platform));
}

}  // namespace glider::frontend
