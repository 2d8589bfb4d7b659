// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/colours.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>

namespace glider::report::picture {
namespace {

struct Stop {
  double at;
  std::array<double, 3> rgb;
};

/// The report page's thermal scale without its lightest end, which is not visible on white paper.
constexpr Stop kScale[] = {
    {0, {0x0b, 0x27, 0x48}},    {0.16, {0x25, 0x3a, 0x7d}}, {0.36, {0x5f, 0x46, 0x93}},
    {0.53, {0x97, 0x52, 0x8a}}, {0.7, {0xcb, 0x60, 0x68}},  {0.86, {0xec, 0x85, 0x49}},
    {1, {0xf6, 0xbb, 0x4a}},
};

constexpr std::string_view kStates[] = {"#0072b2", "#e69f00", "#009e73", "#cc79a7",
                                        "#56b4e9", "#d55e00", "#f0e442"};

/// A component of a colour as light, 0 to 1.
double light(std::string_view hex) {
  unsigned value = 0;
  std::from_chars(hex.data(), hex.data() + 2, value, 16);
  const double v = value / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

}  // namespace

std::string scaleColour(size_t step, size_t steps) {
  const double x = static_cast<double>(step) / static_cast<double>(steps - 1);
  size_t upper = 1;
  while (upper + 1 < std::size(kScale) && kScale[upper].at < x) {
    ++upper;
  }
  const Stop &a = kScale[upper - 1], &b = kScale[upper];
  const double part = std::clamp((x - a.at) / (b.at - a.at), 0.0, 1.0);
  const auto mixed = [&](size_t i) { return std::lround(a.rgb[i] + (b.rgb[i] - a.rgb[i]) * part); };
  return fmt::format("#{:02x}{:02x}{:02x}", mixed(0), mixed(1), mixed(2));
}

std::string_view stateColour(double id) {
  return kStates[static_cast<size_t>(std::fmax(id, 0)) % std::size(kStates)];
}

std::string_view inkOn(std::string_view colour) {
  const double luminance = 0.2126 * light(colour.substr(1, 2)) +
                           0.7152 * light(colour.substr(3, 2)) +
                           0.0722 * light(colour.substr(5, 2));
  return luminance > 0.24 ? "#1b2733" : "#ffffff";
}

}  // namespace glider::report::picture
