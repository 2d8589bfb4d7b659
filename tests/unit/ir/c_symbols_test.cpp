// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/c_symbols.h"

#include "ir/core/types.h"
#include "ir/text/c_header.h"

#include <gtest/gtest.h>

namespace glider::ir {
namespace {

namespace dimension = support::dimension;

const Type kOdd = quantity(*support::quotient(dimension::temperature,
                                              *support::product(dimension::time, dimension::time)));

std::string declarationOf(const std::string& symbol) {
  const auto read = readSymbol(symbol);
  return read ? read->declaration : "none";
}

TEST(CSymbols, SpellTheTypes) {
  EXPECT_EQ(functionSymbol("density", {{"t", quantity(dimension::temperature)}, {"x", kOdd}},
                           quantity(dimension::number)),
            "glider.function.density.temperature.s_2K1.number");
  EXPECT_EQ(functionSymbol("beat", {}, {TypeKind::Bool, {}}), "glider.function.beat.bool");
  EXPECT_EQ(sensorSymbol("range", quantity(dimension::length)), "glider.sensor.range.length");
  EXPECT_EQ(behaviourSymbol(BehaviourKind::Profile, "up", {}, {}), "glider.profile.up");
  EXPECT_EQ(behaviourSymbol(BehaviourKind::Route, "to",
                            {{"a", {TypeKind::Latitude, {}}}, {"b", {TypeKind::Longitude, {}}}},
                            {{"range", kFirstOwnSensor + 3}}),
            "glider.route.to.latitude.longitude.reads.range.3");
}

TEST(CSymbols, AreReadAsTheLanguageHasThem) {
  EXPECT_EQ(declarationOf("glider.function.density.temperature.s_2K1.number"),
            "function density(temperature, degC/s^2): number");
  EXPECT_EQ(declarationOf("glider.function.beat.bool"), "function beat(): bool");
  EXPECT_EQ(declarationOf("glider.sensor.range.length"), "sensor range: length");
  EXPECT_EQ(declarationOf("glider.profile.up"), "flightprofile up");
  EXPECT_EQ(declarationOf("glider.route.to.latitude.longitude.reads.range.3.a.0"),
            "flightroute to(latitude, longitude) reads range, a");
}

TEST(CSymbols, SymbolsOfAnotherFormAreRefused) {
  for (const char* other : {"", "main", "glider", "glider.function", "glider.function.f",
                            "glider.planet.x.length", "gliderMission", "x.function.f.length"}) {
    EXPECT_EQ(declarationOf(other), "none") << other;
  }
  EXPECT_EQ(declarationOf("glider.function.f.m99.q1.s_"), "function f(m99, q1): s_")
      << "foreign words stay";
}

/// Every dimension that the language can write has a word of its own.
TEST(CSymbols, TypesThatDifferHaveSymbolsThatDiffer) {
  std::vector<support::Dimension> all = {
#define DIMENSION(name, m, kg, s, a, k, rad, unit) dimension::name,
#include "support/units/dimensions.def"
#undef DIMENSION
  };
  const size_t named = all.size();
  for (size_t i = 0; i < named; ++i) {
    for (size_t k = 0; k < named; ++k) {
      all.push_back(*support::product(all[i], all[k]));
      all.push_back(*support::quotient(all[i], all[k]));
    }
  }
  for (const support::Dimension& a : all) {
    for (const support::Dimension& b : all) {
      EXPECT_EQ(a == b, sensorSymbol("x", quantity(a)) == sensorSymbol("x", quantity(b)));
    }
  }
}

/// Also where the language shows another unit.
TEST(CHeader, SaysInWhichUnitAValueIs) {
  const auto says = [](const Type& type, const std::string& unit) {
    Function function;
    function.name = "f";
    function.result = type;
    const std::string header = printHeader({{function}, {}, {}}, "m");
    EXPECT_NE(header.find("gives " + unit + ". Each"), std::string::npos) << header;
  };
  says(quantity(dimension::pressure), "Pa");
  says(quantity(dimension::charge), "C");
  says(quantity(dimension::length), "m");
  says(quantity(dimension::number), "a number");
  says({TypeKind::Bool, {}}, "0 or 1");
  says({TypeKind::Latitude, {}}, "degrees north");
  says({TypeKind::Longitude, {}}, "degrees east");
}

}  // namespace
}  // namespace glider::ir
