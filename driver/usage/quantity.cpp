// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/usage/quantity.h"

#include "simulator/scenario/scenario.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace glider::driver {
namespace {

/// What the value of an option is: "time", its unit alone "seconds", and an example.
struct Kind {
  support::Dimension dimension;
  const char* word;   ///< of --help
  const char* noun;   ///< "time"
  const char* plain;  ///< what a number alone is in
  const char* unit;   ///< of the bounds in messages
  const char* example;
};
constexpr Kind kTime = {support::dimension::time, "TIME", "time", "seconds", "s", "90min"};
constexpr Kind kDepth = {support::dimension::length, "DEPTH", "depth", "metres", "m", "60m"};

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
                       : fmt::format("`{}` is not from {:g} {} to {:g} {}", text, least, kind.unit,
                                     most, kind.unit);
          },
          "", kind.noun));
}

}  // namespace

std::optional<double> quantityIn(const std::string& text, support::Dimension dimension) {
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
    return end == last ? std::optional(number) : std::nullopt;
  }
  const auto found = support::findUnit({unit, last});
  return found && found->dimension == dimension ? std::optional(number * found->to_si)
                                                : std::nullopt;
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
