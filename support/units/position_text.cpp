// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/units/position_text.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

namespace glider::support {
namespace {

std::string half(double degrees, char positive, char negative) {
  constexpr int64_t kDegree = 60000;  // thousandths of a minute
  const int64_t thousandths = std::llround(std::fabs(degrees) * kDegree);
  return fmt::format("{} {:06.3f} {}", thousandths / kDegree,
                     static_cast<double>(thousandths % kDegree) / 1000,
                     std::signbit(degrees) ? negative : positive);
}

}  // namespace

std::string latitudeText(double degrees) {
  return half(degrees, 'N', 'S');
}

std::string longitudeText(double degrees) {
  return half(degrees, 'E', 'W');
}

std::string positionText(double latitude, double longitude) {
  return latitudeText(latitude) + " " + longitudeText(longitude);
}

std::string lengthText(double metres) {
  constexpr double kKilometre = 1000;
  const double whole = std::round(metres);
  return std::fabs(whole) < kKilometre ? fmt::format("{:.0f} m", whole)
                                       : fmt::format("{:.5g} km", whole / kKilometre);
}

}  // namespace glider::support
