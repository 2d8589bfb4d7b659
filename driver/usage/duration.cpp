// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/usage/duration.h"

#include "simulator/scenario/scenario.h"
#include "support/units/units.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace glider::driver {
namespace {

/// "s, min, h or day".
std::string unitsOfTime() {
  std::string list;
  auto units = support::unitsOf(support::dimension::time);
  std::erase_if(units, [](const support::Unit& unit) { return unit.soft; });  // `days` is `day`
  for (size_t i = 0; i < units.size(); ++i) {
    list += i == 0 ? "" : i + 1 == units.size() ? " or " : ", ";
    list += units[i].spelling;
  }
  return list;
}

}  // namespace

std::optional<double> secondsIn(const std::string& text) {
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
  return found && found->dimension == support::dimension::time
             ? std::optional(number * found->to_si)
             : std::nullopt;
}

CLI::Option* addDurationOption(CLI::App& command, const std::string& name,
                               std::optional<double>& value, double least_s, double most_s,
                               const std::string& description) {
  return command
      .add_option_function<std::string>(
          name, [&value](const std::string& text) { value = secondsIn(text); }, description)
      ->option_text("TIME")
      ->check(CLI::Validator(
          [least_s, most_s](const std::string& text) -> std::string {
            const auto seconds = secondsIn(text);
            if (!seconds) {
              return fmt::format(
                  "`{}` is not a time: write a number with {}, as in 90min; a number alone is in "
                  "seconds",
                  text, unitsOfTime());
            }
            return *seconds >= least_s && *seconds <= most_s
                       ? ""
                       : fmt::format("`{}` is not from {:g} s to {:g} s", text, least_s, most_s);
          },
          "", "time"));
}

CLI::Option* addFlightDuration(CLI::App& command, std::optional<double>& value) {
  constexpr double kShortest_s = 1;
  return addDurationOption(command, "--duration", value, kShortest_s, simulator::kLongestFlight_s,
                           "Fly for at most this time, as in 2day or 90min [the scenario's]");
}

}  // namespace glider::driver
