// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/usage/quantity.h"

#include "simulator/scenario/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

namespace glider::driver {
namespace {

/// What the value of an option is: "time", its unit alone "seconds", and an example.
struct Kind {
  support::Dimension dimension;
  const char* word;   ///< of --help
  const char* noun;   ///< "time"
  const char* plain;  ///< what a number alone is in
  const char* example;
};
constexpr Kind kTime = {support::dimension::time, "TIME", "time", "seconds", "90min"};
constexpr Kind kDepth = {support::dimension::length, "DEPTH", "depth", "metres", "60m"};

/// "s, min, h or day".
std::string unitNames(support::Dimension dimension) {
  std::string list;
  auto units = support::unitsOf(dimension);
  std::erase_if(units, [](const support::Unit& unit) { return unit.soft; });  // `days` is `day`
  for (size_t i = 0; i < units.size(); ++i) {
    list += i == 0 ? "" : i + 1 == units.size() ? " or " : ", ";
    list += units[i].spelling;
  }
  return list;
}

/// "60 days", "10 min": in the largest unit in which it is a whole number; of depths in metres.
std::string bound(double value, support::Dimension dimension) {
  if (dimension != support::dimension::time) {
    return fmt::format("{:g} m", value);
  }
  std::string text = fmt::format("{:g} s", value);
  double largest = 1;
  for (const support::Unit& unit : support::unitsOf(dimension)) {
    const double count = value / unit.to_si;
    if (count >= 1 && count == std::floor(count) && unit.to_si >= largest &&
        !(unit.spelling == "days" && count == 1)) {
      largest = unit.to_si;
      text = fmt::format("{:g} {}", count, unit.spelling);
    }
  }
  return text;
}

CLI::Option* addOption(CLI::App& command, const std::string& name, const Kind& kind,
                       std::optional<double>& value, double least, double most,
                       const std::string& description) {
  return command
      .add_option_function<std::string>(
          name,
          [&value, kind](const std::string& text) { value = quantityIn(text, kind.dimension); },
          description)
      ->option_text(kind.word)
      ->check(CLI::Validator(
          [least, most, kind](const std::string& text) -> std::string {
            const auto number = quantityIn(text, kind.dimension);
            if (!number) {
              return fmt::format(
                  "`{}` is not a {}: write a number with {}, as in {}; a number alone is in {}",
                  text, kind.noun, unitNames(kind.dimension), kind.example, kind.plain);
            }
            return *number >= least && *number <= most
                       ? ""
                       : fmt::format("`{}` is not from {} to {}", text,
                                     bound(least, kind.dimension), bound(most, kind.dimension));
          },
          "", kind.noun));
}

}  // namespace

namespace {

/// One number with its unit, and the factor of the unit to SI units.
struct Part {
  double value;
  double unit;
};

std::optional<Part> partIn(std::string_view text, support::Dimension dimension) {
  double number = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  if (error != std::errc() || !std::isfinite(number) || number < 0) {
    return std::nullopt;
  }
  const char* unit = end;
  while (unit != last && *unit == ' ') {
    ++unit;
  }
  if (unit == last) {
    return end == last ? std::optional(Part{number, 0}) : std::nullopt;
  }
  const auto found = support::findUnit({unit, last});
  return found && found->dimension == dimension
             ? std::optional(Part{number * found->to_si, found->to_si})
             : std::nullopt;
}

/// `3 h` of `3 h 30 min`: up to the last letter before white space or a digit.
std::string_view firstPartOf(std::string_view text) {
  constexpr std::string_view kLetters = "abcdfghijklmnopqrstuvwxyz";  // `1e3 s` is one part
  const size_t letter = text.find_first_of(kLetters);
  const size_t end = letter == text.npos ? text.npos : text.find_first_of(" 0123456789", letter);
  return text.substr(0, std::min(end, text.size()));
}

}  // namespace

std::optional<double> quantityIn(const std::string& text, support::Dimension dimension) {
  const auto whole = partIn(text, dimension);
  if (whole || dimension != support::dimension::time) {
    return whole ? std::optional(whole->value) : std::nullopt;
  }
  // As in missions: from the largest unit to the smallest, each part less than the unit before it.
  double sum = 0;
  double last = std::numeric_limits<double>::infinity();
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view first = firstPartOf(rest);
    const auto part = partIn(first, dimension);
    if (!part || !(part->unit > 0 && part->unit < last && part->value < last)) {
      return std::nullopt;
    }
    sum += part->value;
    last = part->unit;
    rest.remove_prefix(first.size());
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  }
  return sum > 0 ? std::optional(sum) : std::nullopt;
}

CLI::Option* addDurationOption(CLI::App& command, const std::string& name,
                               std::optional<double>& value, double least_s, double most_s,
                               const std::string& description) {
  return addOption(command, name, kTime, value, least_s, most_s, description);
}

CLI::Option* addDepthOption(CLI::App& command, const std::string& name,
                            std::optional<double>& value, double least_m, double most_m,
                            const std::string& description) {
  return addOption(command, name, kDepth, value, least_m, most_m, description);
}

CLI::Option* addFlightDuration(CLI::App& command, std::optional<double>& value) {
  constexpr double kShortest_s = 1;
  return addDurationOption(command, "--duration", value, kShortest_s, simulator::kLongestFlight_s,
                           "Fly for at most this time, as in 2day or 90min [the scenario's]");
}

}  // namespace glider::driver
