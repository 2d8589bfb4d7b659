// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The text of the vehicle's port for a backseat driver.

#include "hooks/extctl/pairs.h"
#include "hooks/extctl/port.h"
#include "hooks/extctl/sentence.h"
#include "hooks/protocol/decimal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glider::hooks::extctl {
namespace {

std::vector<std::string> sentencesIn(std::string_view bytes, uint32_t* bad = nullptr) {
  SentenceReader reader;
  std::vector<std::string> found;
  for (const char c : bytes) {
    if (reader.push(static_cast<uint8_t>(c))) {
      found.emplace_back(reader.body(), reader.size());
    }
  }
  if (bad != nullptr) {
    *bad = reader.bad();
  }
  return found;
}

using Bodies = std::vector<std::string>;

TEST(Decimal, EachPowerOfTenIsExact) {
  for (int power = 0; power <= 22; ++power) {
    for (const char* sign : {"", "-"}) {
      const std::string text = "1e" + std::string(sign) + std::to_string(power);
      double value = 0;
      ASSERT_TRUE(hooks::readDecimal(text.data(), static_cast<uint32_t>(text.size()), &value));
      EXPECT_EQ(value, std::strtod(text.c_str(), nullptr)) << text;
    }
  }
}

TEST(ExtctlSentence, ReadsWhatVehiclesHaveSent) {
  EXPECT_EQ(sentencesIn("$HI*01\r\n"), Bodies{"HI"});
  EXPECT_EQ(sentencesIn("$SD,0:658.165286680912*2e\r\n"), Bodies{"SD,0:658.165286680912"});
  EXPECT_EQ(sentencesIn("$FI*0f\r\n$GO*08\r\n"), (Bodies{"FI", "GO"}));
}

TEST(ExtctlSentence, TakesEitherCaseAndAnyLineEnd) {
  EXPECT_EQ(sentencesIn("$SD,0:658.165286680912*2E\n"), Bodies{"SD,0:658.165286680912"});
  EXPECT_EQ(sentencesIn("$HI*01$GO*08"), (Bodies{"HI", "GO"})) << "two in a read, no line end";
  EXPECT_EQ(sentencesIn("$HI*01\r$GO*08\n\r\n"), (Bodies{"HI", "GO"}));
}

TEST(ExtctlSentence, FindsItsWayAfterGarbage) {
  using namespace std::string_view_literals;
  uint32_t bad = 0;
  EXPECT_EQ(sentencesIn("boot v1.2\r\nTT\0$HI*01\r\n"sv), Bodies{"HI"});
  EXPECT_EQ(sentencesIn("$B$HI*01\r\n", &bad), Bodies{"HI"});
  EXPECT_EQ(bad, 1U);
  EXPECT_EQ(sentencesIn("$H\0I*01\r\n$GO*08\r\n"sv, &bad), Bodies{"GO"}) << "no byte is guessed";
  EXPECT_EQ(bad, 1U);
  EXPECT_EQ(sentencesIn("$HI*02\r\n$HI*0\r\n$HI\r\n$HI*zz\r\n", &bad), Bodies{});
  EXPECT_EQ(bad, 4U);
}

TEST(ExtctlSentence, LinesAsLongAsTheVehiclesAndNoLonger) {
  char text[2048];
  for (const uint32_t length : {820U, kMostBody}) {
    SentenceWriter writer(text, sizeof text);
    const std::string body(length, 'A');
    writer.put(body.c_str());
    EXPECT_EQ(sentencesIn({text, writer.end()}), Bodies{body});
  }
  SentenceWriter writer(text, sizeof text);
  writer.put(std::string(kMostBody + 1, 'A').c_str());
  uint32_t bad = 0;
  EXPECT_EQ(sentencesIn(std::string(text, writer.end()) + "$HI*01\r\n", &bad), Bodies{"HI"});
  EXPECT_EQ(bad, 1U);
}

TEST(ExtctlPairs, AreReadOneByOneAndWhatIsNoneIsTold) {
  constexpr std::string_view kText = ",0:1.5,,12:-2,:5,x:1,7,8:5:,64:1,640:1,99999999999:1,3:nan,";
  PairReader reader(kText.data(), static_cast<uint32_t>(kText.size()));
  std::vector<std::pair<uint32_t, double>> good;
  uint32_t none = 0;
  for (Pair pair; reader.next(&pair);) {
    none += pair.good ? 0 : 1;
    if (pair.good && pair.index < kMostSensors) {
      good.emplace_back(pair.index, pair.value);
    }
  }
  EXPECT_EQ(none, 4U) << ":5, x:1, 7 and 8:5:";
  ASSERT_EQ(good.size(), 3U);
  EXPECT_EQ(good[0], (std::pair<uint32_t, double>{0, 1.5}));
  EXPECT_EQ(good[1], (std::pair<uint32_t, double>{12, -2}));
  EXPECT_EQ(good[2].first, 3U);
  EXPECT_TRUE(std::isnan(good[2].second));
  PairReader empty("", 0);
  Pair pair;
  EXPECT_FALSE(empty.next(&pair));
}

TEST(ExtctlSentence, WritesWhatItReads) {
  char text[64];
  SentenceWriter writer(text, sizeof text);
  writer.put("SW,");
  writer.put(7U);
  writer.put(':');
  writer.put(25.25);
  const uint32_t size = writer.end();
  EXPECT_EQ(sentencesIn({text, size}), Bodies{"SW,7:25.250000"});
  EXPECT_EQ(std::string_view(text + size - 2, 2), "\r\n");
}

TEST(ExtctlSentence, WhatDoesNotFitIsNotWritten) {
  char text[12];
  SentenceWriter fits(text, sizeof text);
  fits.put("123456");
  EXPECT_EQ(fits.end(), 12U);
  SentenceWriter too_long(text, sizeof text);
  too_long.put("1234567");
  EXPECT_EQ(too_long.end(), 0U);
}

double read(std::string_view text) {
  double value = 0;
  EXPECT_TRUE(readDecimal(text.data(), static_cast<uint32_t>(text.size()), &value)) << text;
  return value;
}

bool isNumber(std::string_view text) {
  double value = 0;
  return readDecimal(text.data(), static_cast<uint32_t>(text.size()), &value);
}

std::string written(double value) {
  char text[kMostDecimal];
  return {text, writeDecimal(value, text)};
}

TEST(ExtctlDecimal, ReadsEveryForm) {
  EXPECT_EQ(read("658.165286680912"), 658.165286680912);
  EXPECT_EQ(read("-7349.805800"), -7349.8058);
  EXPECT_EQ(read("+.5"), 0.5);
  EXPECT_EQ(read("5."), 5);
  EXPECT_EQ(read("1e-05"), 1e-05);
  EXPECT_EQ(read("1.5E+2"), 150);
  EXPECT_EQ(read("1764280800.123456"), 1764280800.123456);
  EXPECT_EQ(read("00000000000000000000012"), 12);
  EXPECT_TRUE(std::isnan(read("nan")));
  EXPECT_TRUE(std::isnan(read("-NaN")));
  EXPECT_TRUE(std::isnan(read("inf")));
  EXPECT_TRUE(std::isnan(read("1e999999999999"))) << "no double: unknown";
  EXPECT_EQ(read("1e-999999999999"), 0);
  EXPECT_TRUE(std::signbit(read("-0.0")));
}

TEST(ExtctlDecimal, RefusesWhatIsNone) {
  for (const char* text :
       {"", "-", ".", "e5", "1e", "1e+", "1.2.3", "0x10", "12 ", " 12", "1,2", "nano", "--1"}) {
    EXPECT_FALSE(isNumber(text)) << text;
  }
}

/// The C library is the reference.
TEST(ExtctlDecimal, AgreesWithTheLibrary) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> size(-8, 11.9);
  for (int i = 0; i < 100'000; ++i) {
    const double value = std::pow(10, size(random)) * ((random() & 1) != 0 ? 1 : -1);
    char text[64];
    (void)std::snprintf(text, sizeof text, "%.12f", value);
    const double truth = std::strtod(text, nullptr);
    const double ulp = std::nextafter(std::fabs(truth), INFINITY) - std::fabs(truth);
    ASSERT_LE(std::fabs(read(text) - truth), ulp) << text;
    (void)std::snprintf(text, sizeof text, "%.6f", value);
    ASSERT_NEAR(std::strtod(written(value).c_str(), nullptr), std::strtod(text, nullptr),
                1.0e-6 + std::fabs(value) * 4e-16)
        << text;
  }
}

TEST(ExtctlDecimal, WritesSixDecimals) {
  EXPECT_EQ(written(0), "0.000000");
  EXPECT_EQ(written(-0.4538), "-0.453800");
  EXPECT_EQ(written(1764280804), "1764280804.000000") << "the vehicle's clock";
  EXPECT_EQ(written(3910.5001234), "3910.500123");
  EXPECT_EQ(written(0.9999999), "1.000000");
  EXPECT_EQ(written(-0.0000001), "0.000000");
  EXPECT_EQ(written(1e300), "1000000000000.000000");
  EXPECT_EQ(written(std::nan("")), "nan");
  EXPECT_EQ(asSixDecimals(1.23456789), 1.234568);
  EXPECT_EQ(asSixDecimals(asSixDecimals(3910.5001234)), asSixDecimals(3910.5001234));
  // A number so large that millions of it have no halves: it does not creep upwards as it is passed
  // on.
  for (const double large :
       {4444444444.13444, -4444444444.13444, 8999999999.999999, 123456789012.25}) {
    EXPECT_EQ(asSixDecimals(large), large);
  }
}

}  // namespace
}  // namespace glider::hooks::extctl
