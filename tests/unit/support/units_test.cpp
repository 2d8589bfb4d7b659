// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/units/units.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::support {
namespace {

TEST(Units, ConvertToSi) {
  EXPECT_DOUBLE_EQ(findUnit("km")->to_si, 1000);
  EXPECT_DOUBLE_EQ(findUnit("kn")->to_si * 3600, 1852);
  EXPECT_DOUBLE_EQ(findUnit("deg")->to_si * 180, std::acos(-1.0));
  EXPECT_DOUBLE_EQ(findUnit("Ah")->to_si, 3600);
  EXPECT_FALSE(findUnit("furlong"));
}

TEST(Units, EveryNamedDimensionHasItsBareUnit) {
  for (const char* name : {"length", "time", "angle", "temperature", "speed", "pressure",
                           "conductivity", "voltage", "current", "power", "energy", "charge"}) {
    const auto dimension = findDimension(name);
    ASSERT_TRUE(dimension) << name;
    ASSERT_TRUE(bareUnit(*dimension)) << name;
    EXPECT_EQ(bareUnit(*dimension)->dimension, *dimension) << name;
    EXPECT_EQ(describe(*dimension), name);
  }
}

TEST(Units, QuotientsAndProductsCompose) {
  const auto gradient = parseUnit("degC/m");
  ASSERT_TRUE(gradient);
  EXPECT_EQ(gradient->dimension, *quotient(dimension::temperature, dimension::length));
  EXPECT_EQ(*product(gradient->dimension, dimension::length), dimension::temperature);
  EXPECT_EQ(*product(dimension::voltage, dimension::current), dimension::power);
  EXPECT_EQ(*product(dimension::power, dimension::time), dimension::energy);
  EXPECT_EQ(*squareRoot(*product(dimension::length, dimension::length)), dimension::length);
  EXPECT_FALSE(squareRoot(dimension::length));
  EXPECT_FALSE(parseUnit("degC/furlong"));
  EXPECT_FALSE(parseUnit(""));
  EXPECT_EQ(unitName(gradient->dimension), "degC/m");
}

TEST(Units, ExponentsStayBounded) {
  Dimension d = dimension::length;
  int doublings = 0;
  while (auto next = product(d, d)) {
    d = *next;
    ASSERT_LT(++doublings, 10);
  }
  EXPECT_EQ(doublings, 3);
}

}  // namespace
}  // namespace glider::support
