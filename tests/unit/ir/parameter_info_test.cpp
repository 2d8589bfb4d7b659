// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/parameter_info.h"

#include "support/units/units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <sstream>

namespace glider::ir {
namespace {

/// "m=3ff0000000000000 ft=…" read back.
std::vector<std::pair<std::string, double>> factorsOf(const Type& type) {
  std::vector<std::pair<std::string, double>> rows;
  std::istringstream in(unitFactors(type));
  for (std::string word; in >> word;) {
    const size_t at = word.find('=');
    rows.emplace_back(word.substr(0, at),
                      std::bit_cast<double>(std::stoull(word.substr(at + 1), nullptr, 16)));
  }
  return rows;
}

using Rows = std::vector<std::pair<std::string, double>>;

TEST(UnitFactors, PositionsHaveTheirLetters) {
  EXPECT_EQ(factorsOf({TypeKind::Latitude, {}}), (Rows{{"N", 1}, {"S", -1}}));
  EXPECT_EQ(factorsOf({TypeKind::Longitude, {}}), (Rows{{"E", 1}, {"W", -1}}));
  EXPECT_EQ(unitFactors({TypeKind::Bool, {}}), "bool");
}

TEST(UnitFactors, TheBareUnitComesFirstAndNoneTwice) {
  for (const support::Dimension dimension :
       {support::dimension::length, support::dimension::time, support::dimension::angle,
        support::dimension::speed, support::dimension::temperature}) {
    const Rows rows = factorsOf({TypeKind::Quantity, dimension});
    const auto bare = support::bareUnit(dimension);
    ASSERT_TRUE(bare);
    ASSERT_FALSE(rows.empty());
    EXPECT_EQ(rows[0].first, bare->spelling);
    EXPECT_EQ(rows[0].second, bare->to_si);
    EXPECT_EQ(rows.size(), support::unitsOf(dimension).size());
    for (const support::Unit& unit : support::unitsOf(dimension)) {
      EXPECT_EQ(std::ranges::count(rows, std::pair{std::string(unit.spelling), unit.to_si}), 1)
          << unit.spelling;
    }
  }
}

TEST(UnitFactors, ACompoundWithoutAUnitOfItsOwnIsItsName) {
  support::Dimension area = support::dimension::length;
  for (auto& exponent : area.exponents) {
    exponent = static_cast<std::remove_reference_t<decltype(exponent)>>(2 * exponent);
  }
  const Rows rows = factorsOf({TypeKind::Quantity, area});
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows[0].second, 1);
}

/// A mission with the parameter `name`, which begins at `initial`, without limits.
Mission withParameter(const std::string& name, const Type& type, const Expr& initial) {
  Mission mission;
  mission.exprs.push_back(initial);
  Variable variable;
  variable.name = name;
  variable.type = type;
  variable.kind = VariableKind::Parameter;
  variable.initial = {0};
  variable.lowest = -Variable::kEndless;
  variable.highest = Variable::kEndless;
  mission.variables.push_back(variable);
  return mission;
}

ParameterInfo infoOf(const Type& type, const Expr& initial) {
  const auto infos = parameterInfos(withParameter("p", type, initial));
  EXPECT_EQ(infos.size(), 1U);
  return infos.at(0);
}

TEST(ParameterInfos, APositionWithoutLimitsIsOnEarth) {
  Expr initial;
  initial.op = Op::Constant;
  initial.number = 39;
  const ParameterInfo latitude = infoOf({TypeKind::Latitude, {}}, initial);
  EXPECT_EQ(latitude.initial, 39);
  EXPECT_EQ(latitude.lowest, -90);
  EXPECT_EQ(latitude.highest, 90);
  const ParameterInfo longitude = infoOf({TypeKind::Longitude, {}}, initial);
  EXPECT_EQ(longitude.lowest, -180);
  EXPECT_EQ(longitude.highest, 180);
  const ParameterInfo length = infoOf({TypeKind::Quantity, support::dimension::length}, initial);
  EXPECT_EQ(length.highest, Variable::kEndless);
}

/// What counts in one unit is not to be set in another.
TEST(ParameterInfos, ANumberOfAUnitTakesNoOther) {
  Expr initial;
  initial.op = Op::Constant;
  Mission mission = withParameter("p", {TypeKind::Quantity, {}}, initial);
  EXPECT_NE(parameterInfos(mission).at(0).units.find("uM="), std::string::npos);
  mission.variables[0].unit = "ug/L";
  EXPECT_EQ(parameterInfos(mission).at(0).units, "ug/L=3ff0000000000000");
}

TEST(ParameterInfos, ATruthIsZeroOrOne) {
  Expr initial;
  initial.op = Op::True;
  EXPECT_EQ(infoOf({TypeKind::Bool, {}}, initial).initial, 1);
  initial.op = Op::False;
  EXPECT_EQ(infoOf({TypeKind::Bool, {}}, initial).initial, 0);
}

TEST(ParameterInfos, OtherVariablesAreNoParameters) {
  Expr initial;
  initial.op = Op::Constant;
  Mission mission = withParameter("p", {TypeKind::Quantity, {}}, initial);
  mission.variables.push_back(mission.variables[0]);
  mission.variables[1].kind = VariableKind::Mission;
  EXPECT_EQ(parameterInfos(mission).size(), 1U);
}

}  // namespace
}  // namespace glider::ir
