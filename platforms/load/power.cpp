// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/power.h"

#include "hooks/protocol/sampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace glider::platforms {
namespace {

struct WhenRow {
  std::string_view word, unit, what;
};

constexpr WhenRow kWhens[] = {
#define DRAW(name, word, unit, what) {word, unit, what},
#include "platforms/load/draws.def"
};

const WhenRow& rowOf(DrawWhen when) {
  return kWhens[static_cast<size_t>(when)];
}

}  // namespace

std::string_view wordOf(DrawWhen when) {
  return rowOf(when).word;
}

std::optional<DrawWhen> drawWhenOf(std::string_view word) {
  const auto* row = std::ranges::find(kWhens, word, &WhenRow::word);
  return row == std::end(kWhens) ? std::nullopt
                                 : std::optional(static_cast<DrawWhen>(row - std::begin(kWhens)));
}

std::string drawWords() {
  std::string words;
  for (const WhenRow& row : kWhens) {
    words += fmt::format("{}\"{}\"", words.empty() ? "" : ", ", row.word);
  }
  return words;
}

std::string_view unitOf(DrawWhen when) {
  return rowOf(when).unit;
}

std::string_view describe(DrawWhen when) {
  return rowOf(when).what;
}

std::vector<std::string> devicesOf(const Power& power) {
  std::vector<std::string> devices;
  for (const Draw& draw : power.draws) {
    if (std::ranges::find(devices, draw.device) == devices.end()) {
      devices.push_back(draw.device);
    }
  }
  if (!power.propeller.rpm.empty()) {
    devices.emplace_back(kPropellerDevice);
  }
  devices.emplace_back(kSbcDevice);
  devices.emplace_back(kModemDevice);
  return devices;
}

size_t placeOf(const Power& power, std::string_view device) {
  const std::vector<std::string> devices = devicesOf(power);
  return static_cast<size_t>(std::ranges::find(devices, device) - devices.begin());
}

namespace {

/// The wave number of the longest swell in water so deep, rad/m: w^2 = g k tanh(k h).
double waveNumber(double water_m) {
  constexpr double kGravity = 9.81;
  const double angular = 2 * std::numbers::pi / kSwell_s;
  const double in_deep_water = angular * angular / kGravity;
  double k = in_deep_water;
  for (int i = 0; i < 60; ++i) {  // halves the error
    k = std::sqrt(k * in_deep_water / std::tanh(k * water_m));
  }
  return k;
}

}  // namespace

double hoverPump(const EnergyModel& model, double depth_m) {
  // The pressure of a wave fades towards the bottom by cosh(k z), z above it. The shallowest water
  // and the longest wave that are assumed leave the most of it.
  const double water_m = std::max(depth_m, 0.0) + kBelowDives_m;
  const double k = waveNumber(water_m);
  const double left = std::cosh(k * kBelowDives_m) / std::cosh(k * water_m);
  return model.hover_pump_cc_s + model.hover_swell_cc_s * left;
}

std::optional<double> shareOn(const Draw& draw, uint32_t code) {
  const double period_s = hookSamplingSecs(code);
  if (std::isnan(period_s)) {
    return std::nullopt;
  }
  return period_s < 0 ? 0 : draw.reading_s / std::max(draw.reading_s, period_s);
}

}  // namespace glider::platforms
