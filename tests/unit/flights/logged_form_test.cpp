// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/logged_form.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace glider::flights {
namespace {

std::string shown(const std::string& unit, double value) {
  const LoggedForm form{unit, 1, LoggedForm::Half::None};
  return shownValues({&form, 1}, {&value, 1});
}

TEST(LoggedForm, TimesAreAsPeopleSayThem) {
  EXPECT_EQ(shown("timestamp", 1250000180), "2009-08-11T14:16:20Z");
  EXPECT_EQ(shown("s", 12600), "3 h 30 min");
  EXPECT_EQ(shown("s", 54808), "15 h 13 min 28 s");
  EXPECT_EQ(shown("s", 41.5), "41.5 s");
}

TEST(LoggedForm, AnglesHaveNoSignAtZeroAndNoWholeTurn) {
  constexpr double kDegree = std::numbers::pi / 180;
  EXPECT_EQ(shown("rad", -0.01 * kDegree), "0.0 deg");
  EXPECT_EQ(shown("rad", 359.97 * kDegree), "0.0 deg");
  EXPECT_EQ(shown("rad", 360.5 * kDegree), "360.5 deg");
  EXPECT_EQ(shown("rad", -26 * kDegree), "-26.0 deg");
  EXPECT_EQ(shown("deg", -1e-9), "0.00000 deg");
}

TEST(LoggedForm, NumbersHaveAsManyDigitsAsAreKnown) {
  EXPECT_EQ(shown("1", 2), "2");
  EXPECT_EQ(shown("", -0.0), "0");
  EXPECT_EQ(shown("m", 123456.4), "123456 m");
  EXPECT_EQ(shown("m", 1e300), "1e+300 m");
  EXPECT_EQ(shown("m", std::nan("")), "unknown");
}

}  // namespace
}  // namespace glider::flights
