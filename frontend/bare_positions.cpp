// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/bare_positions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace glider::frontend {
namespace {

constexpr double kMostLatitude = 90;
constexpr double kMostLongitude = 180;
/// Few gliders fly at higher latitudes; positions there need a letter.
constexpr double kPolar = 70;

size_t wholeDigits(std::string_view digits) {
  return std::min(digits.find_first_not_of("0123456789"), digits.size());
}

/// Degrees, if `digits` can be ddmm.mmmm; otherwise empty.
std::optional<double> readDdmm(std::string_view digits) {
  constexpr size_t kFewest = 3;
  constexpr size_t kMost = 5;
  const size_t whole = wholeDigits(digits);
  const bool decimal = digits.find_first_not_of("0123456789.") == std::string_view::npos;
  if (!decimal || whole < kFewest || whole > kMost) {
    return std::nullopt;
  }
  const double minutes = valueOf(digits.substr(whole - 2));
  const double degrees = valueOf(digits.substr(0, whole - 2)) + minutes / 60;
  return minutes < 60 && degrees <= kMostLongitude ? std::optional(degrees) : std::nullopt;
}

}  // namespace

double valueOf(std::string_view digits) {
  return std::strtod(std::string(digits).c_str(), nullptr);
}

bool isPlainlyDdmm(std::string_view digits) {
  return wholeDigits(digits) >= 3 || valueOf(digits) == 0 || valueOf(digits) >= 100;
}

bool isLongitudeFirst(double first, double second) {
  const double north = std::fabs(first);
  const double east = std::fabs(second);
  return north <= kMostLongitude && east <= kMostLatitude &&
         (north > kMostLatitude || (north > kPolar && east <= kPolar));
}

std::string withLetter(double degrees, bool latitude) {
  std::string text = fmt::format("{:.6f}", std::fabs(degrees));
  text.erase(text.find_last_not_of('0') + 1);
  text += text.back() == '.' ? "0 " : " ";
  return text + (degrees < 0 ? (latitude ? 'S' : 'W') : (latitude ? 'N' : 'E'));
}

std::optional<std::string> pairWithLetters(const BareNumber& first, const BareNumber& second) {
  const auto a = readDdmm(first.digits);
  const auto b = readDdmm(second.digits);
  if (!a || !b) {
    return std::nullopt;
  }
  double north = first.negative ? -*a : *a;
  double east = second.negative ? -*b : *b;
  if (isLongitudeFirst(north, east)) {
    std::swap(north, east);
  }
  if (std::fabs(north) > kMostLatitude) {
    return std::nullopt;
  }
  return withLetter(north, true) + " " + withLetter(east, false);
}

bool isPairByLooks(std::string_view first, std::string_view second, bool before, bool after) {
  const auto fraction = [](std::string_view digits) {
    return digits.find('.') != std::string_view::npos;
  };
  return readDdmm(first) && readDdmm(second) &&
         ((before && !after) || (fraction(first) && fraction(second)));
}

}  // namespace glider::frontend
