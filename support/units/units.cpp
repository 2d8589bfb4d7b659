// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/units/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace glider::support {
namespace {

struct NamedDimension {
  std::string_view name;
  Dimension dimension;
  std::string_view unit;
};

constexpr NamedDimension kDimensions[] = {
#define DIMENSION(name, m, kg, s, a, k, rad, unit) {#name, dimension::name, unit},
#include "support/units/dimensions.def"
#undef DIMENSION
};

constexpr Unit kUnits[] = {
#define UNIT(spelling, dim, to_si) {spelling, dimension::dim, to_si},
#define SOFT_UNIT(spelling, dim, to_si) {spelling, dimension::dim, to_si, true},
#include "support/units/units.def"
#undef UNIT
};

std::optional<Dimension> combine(Dimension a, Dimension b, int sign) {
  constexpr int kLargest = 12;
  Dimension result;
  for (size_t i = 0; i < a.exponents.size(); ++i) {
    const int exponent = a.exponents[i] + sign * b.exponents[i];
    if (exponent < -kLargest || exponent > kLargest) {
      return std::nullopt;
    }
    result.exponents[i] = static_cast<int8_t>(exponent);
  }
  return result;
}

const NamedDimension* named(Dimension dimension) {
  auto found = std::ranges::find(kDimensions, dimension, &NamedDimension::dimension);
  return found == std::end(kDimensions) ? nullptr : &*found;
}

/// "m^2*degC/s" from the exponents.
std::string compound(Dimension dimension) {
  constexpr std::string_view kBase[] = {"m", "kg", "s", "A", "degC", "rad"};
  std::string above;
  std::string below;
  for (size_t i = 0; i < std::size(kBase); ++i) {
    const int exponent = dimension.exponents[i];
    std::string& side = exponent > 0 ? above : below;
    const int power = exponent > 0 ? exponent : -exponent;
    if (power == 0) {
      continue;
    }
    side += fmt::format("{}{}{}", side.empty() ? "" : "*", kBase[i],
                        power > 1 ? fmt::format("^{}", power) : "");
  }
  above = above.empty() ? "1" : above;
  return below.empty() ? above : above + "/" + below;
}

}  // namespace

std::optional<Dimension> product(Dimension a, Dimension b) {
  return combine(a, b, 1);
}
std::optional<Dimension> quotient(Dimension a, Dimension b) {
  return combine(a, b, -1);
}

std::optional<Dimension> squareRoot(Dimension a) {
  for (int8_t& exponent : a.exponents) {
    if (exponent % 2 != 0) {
      return std::nullopt;
    }
    exponent = static_cast<int8_t>(exponent / 2);
  }
  return a;
}

std::optional<Unit> findUnit(std::string_view spelling) {
  auto found = std::ranges::find(kUnits, spelling, &Unit::spelling);
  return found == std::end(kUnits) ? std::nullopt : std::optional<Unit>(*found);
}

std::optional<Unit> parseUnit(std::string_view spelling) {
  if (auto unit = findUnit(spelling)) {
    return unit;
  }
  const size_t split = spelling.find_last_of("*/");
  if (split == std::string_view::npos) {
    return std::nullopt;
  }
  auto left = parseUnit(spelling.substr(0, split));
  auto right = findUnit(spelling.substr(split + 1));
  if (!left || !right) {
    return std::nullopt;
  }
  const bool divides = spelling[split] == '/';
  auto dim = divides ? quotient(left->dimension, right->dimension)
                     : product(left->dimension, right->dimension);
  if (!dim) {
    return std::nullopt;
  }
  return Unit{spelling, *dim, divides ? left->to_si / right->to_si : left->to_si * right->to_si};
}

std::optional<Unit> bareUnit(Dimension dimension) {
  const NamedDimension* name = named(dimension);
  if (name == nullptr) {
    return std::nullopt;
  }
  return name->unit.empty() ? Unit{"", dimension, 1.0} : findUnit(name->unit);
}

std::vector<Unit> unitsOf(Dimension dimension) {
  std::vector<Unit> units;
  std::ranges::copy_if(kUnits, std::back_inserter(units),
                       [&](const Unit& unit) { return unit.dimension == dimension; });
  return units;
}

std::string describe(Dimension dimension) {
  if (dimension.dimensionless()) {
    return "plain number";
  }
  const NamedDimension* name = named(dimension);
  return name != nullptr ? std::string(name->name) : compound(dimension);
}

std::string unitName(Dimension dimension) {
  const NamedDimension* name = named(dimension);
  return name != nullptr ? std::string(name->unit) : compound(dimension);
}

std::optional<Dimension> findDimension(std::string_view name) {
  auto found = std::ranges::find(kDimensions, name, &NamedDimension::name);
  return found == std::end(kDimensions) ? std::nullopt : std::optional<Dimension>(found->dimension);
}

}  // namespace glider::support
