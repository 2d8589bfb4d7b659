// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The functions of runtime/numbers against the C library's in long double.

#include "runtime/numbers/numbers.h"

#include "tests/unit/runtime/numbers_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace glider {
namespace {

using numbers_samples::Random;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kPoints = 200000;

/// The error in units of the last place that a double has there.
double ulps(double value, long double exact) {
  const int exponent = std::max(std::ilogb(static_cast<double>(exact)), -1021);
  return static_cast<double>(std::fabs(value - exact) / std::ldexp(1.0L, exponent - 52));
}

using Draw = std::function<double(Random&)>;

struct Worst {
  double ulps = 0;
  double at = 0;
};

Worst worst(double (*ours)(double), long double (*theirs)(long double), const Draw& draw) {
  Random random(20240229);
  Worst result;
  for (int i = 0; i < kPoints; ++i) {
    const double x = draw(random);
    const double error = ulps(ours(x), theirs(x));
    if (!(error <= result.ulps)) {
      result = {error, x};
    }
  }
  return result;
}

void expectClose(double (*ours)(double), long double (*theirs)(long double), double bound) {
  const Draw draws[] = {[](Random& r) { return r.between(-0.8, 0.8); },
                        [](Random& r) { return r.between(-7.0, 7.0); },
                        [](Random& r) { return r.between(-1048576.0, 1048576.0); },
                        [](Random& r) { return r.spread(-1000, 19); }};
  for (const Draw& draw : draws) {
    const Worst found = worst(ours, theirs, draw);
    EXPECT_LT(found.ulps, bound) << "at " << found.at;
  }
}

TEST(Numbers, SineIsCloseToTheLibrarys) {
  expectClose(gliderSin, sinl, 0.85);
}

TEST(Numbers, CosineIsCloseToTheLibrarys) {
  expectClose(gliderCos, cosl, 0.85);
}

TEST(Numbers, TangentIsCloseToTheLibrarys) {
  expectClose(gliderTan, tanl, 1.0);
}

TEST(Numbers, TheDoublesNextToQuarterTurnsKeepTheirPrecision) {
  Random random(7);
  for (int i = 0; i < kPoints; ++i) {
    const double quarters = std::floor(random.between(1, 667544));
    const double x = static_cast<double>(quarters * 1.570796326794896619231321691639751442L);
    EXPECT_LT(ulps(gliderSin(x), sinl(x)), 0.85) << x;
    EXPECT_LT(ulps(gliderCos(x), cosl(x)), 0.85) << x;
    EXPECT_LT(ulps(gliderTan(x), tanl(x)), 1.0) << x;
  }
}

TEST(Numbers, ArctangentIsCloseToTheLibrarys) {
  Random random(3);
  for (int i = 0; i < kPoints; ++i) {
    const double points[][2] = {
        {random.between(-1, 1), random.between(-1, 1)},
        {random.spread(-30, 30), random.spread(-30, 30)},
        {random.spread(-1021, 1023), random.spread(-1021, 1023)},
    };
    for (const auto& [y, x] : points) {
      const long double exact = atan2l(y, x);
      if (std::fabs(exact) > 0x1p-1022L) {
        EXPECT_LT(ulps(gliderAtan2(y, x), exact), 0.85) << y << " " << x;
      }
    }
  }
}

TEST(Numbers, ArctangentKnowsEveryQuarter) {
  EXPECT_EQ(gliderAtan2(0, 1), 0.0);
  EXPECT_EQ(gliderAtan2(1, 0), M_PI_2);
  EXPECT_EQ(gliderAtan2(0, -1), M_PI);
  EXPECT_EQ(gliderAtan2(-0.0, -1), M_PI);
  EXPECT_EQ(gliderAtan2(-1, 0), -M_PI_2);
  EXPECT_EQ(gliderAtan2(1, 1), M_PI_4);
  EXPECT_EQ(gliderAtan2(-1e300, -1e300), -3 * M_PI_4);
  EXPECT_EQ(gliderAtan2(1e-300, -1e300), M_PI);
}

TEST(Numbers, TheRestOfADivisionIsExact) {
  Random random(7);
  for (const double of : {1.0, 100.0, 6.283185307179586}) {
    for (int i = 0; i < kPoints / 10; ++i) {
      const double size =
          i % 2 == 0 ? random.between(0.0, 20000.0) : std::fabs(random.spread(-1000, 1000));
      ASSERT_EQ(runtime::bitsOf(runtime::restOf(size, of)), runtime::bitsOf(std::fmod(size, of)))
          << size << " by " << of;
    }
    for (const double size : {0.0, of, 2 * of, 1e300, std::nextafter(of, 0.0),
                              std::nextafter(3 * of, 0.0), std::numeric_limits<double>::max()}) {
      EXPECT_EQ(runtime::restOf(size, of), std::fmod(size, of)) << size << " by " << of;
    }
    EXPECT_TRUE(std::isnan(runtime::restOf(std::numeric_limits<double>::infinity(), of)));
  }
}

TEST(Numbers, WhatHasNoValueIsUnknown) {
  EXPECT_TRUE(std::isnan(gliderAtan2(0, 0)));
  EXPECT_TRUE(std::isnan(gliderAtan2(kNaN, 1)));
  EXPECT_TRUE(std::isnan(gliderAtan2(1, kInfinity)));
  for (const double x : {kNaN, kInfinity, -kInfinity, 1048576.5, -1e300}) {
    EXPECT_TRUE(std::isnan(gliderSin(x))) << x;
    EXPECT_TRUE(std::isnan(gliderCos(x))) << x;
    EXPECT_TRUE(std::isnan(gliderTan(x))) << x;
  }
  EXPECT_FALSE(std::isnan(gliderSin(1048576)));
}

TEST(Numbers, ResultsAreSettled) {
  EXPECT_FALSE(std::signbit(gliderSin(-0.0)));
  EXPECT_EQ(gliderSin(0x1p-1060), 0.0);
  EXPECT_EQ(gliderAtan2(0x1p-1000, 0x1p100), 0.0);
}

// What tests/boards expects of every board.
TEST(Numbers, TheDigestIsTheBoards) {
  EXPECT_EQ(numbers_samples::digestOf(GLIDER_NUMBERS_ROUNDS), GLIDER_NUMBERS_DIGEST);
}

}  // namespace
}  // namespace glider
