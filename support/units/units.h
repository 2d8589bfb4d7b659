// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glider::support {

/// A physical dimension: exponents of metre, kilogram, second, ampere, kelvin and radian. Values of
/// a dimension are always held in the coherent SI unit (a pressure in Pa, a charge in A·s); units
/// exist only at input and output.
struct Dimension {
  std::array<int8_t, 6> exponents{};

  bool operator==(const Dimension&) const = default;
  [[nodiscard]] bool dimensionless() const { return *this == Dimension{}; }
};

/// The dimension of a product, a quotient. Empty when an exponent leaves [-12, 12]: no physical
/// quantity does.
std::optional<Dimension> product(Dimension a, Dimension b);
std::optional<Dimension> quotient(Dimension a, Dimension b);
/// The dimension of a square root; empty when an exponent is odd.
std::optional<Dimension> squareRoot(Dimension a);

namespace dimension {
#define DIMENSION(name, m, kg, s, a, k, rad, unit) \
  inline constexpr Dimension name{{m, kg, s, a, k, rad}};
#include "support/units/dimensions.def"
#undef DIMENSION
}  // namespace dimension

struct Unit {
  std::string_view spelling;
  Dimension dimension;
  double to_si;
  bool soft = false;  ///< only a unit right after a number: elsewhere the word is a name
};

/// The unit spelled `spelling` as in the language ("degC", "m/s"); empty if there is none.
std::optional<Unit> findUnit(std::string_view spelling);
/// A quotient or product of units, "degC/m"; empty if a part is unknown.
std::optional<Unit> parseUnit(std::string_view spelling);
/// The unit of a bare number where `dimension` is expected; empty for unnamed dimensions.
std::optional<Unit> bareUnit(Dimension dimension);
/// The units of `dimension` that have a spelling of their own, in the order of units.def.
std::vector<Unit> unitsOf(Dimension dimension);
/// For messages: "length", or "m^2/s" for a dimension without a name, "plain number" for none.
std::string describe(Dimension dimension);
/// The unit to show values of `dimension` in: "m", "degC", "m^2/s", "" for a plain number.
std::string unitName(Dimension dimension);
/// The named dimension `name` ("length"); empty if there is none.
std::optional<Dimension> findDimension(std::string_view name);

}  // namespace glider::support
