// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/log/format.h"
#include "runtime/log/mission_log.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace glider::runtime {
namespace {

std::string text(double value) {
  char out[kNumberBytes];
  return {out, formatNumber(value, out)};
}

TEST(Format, Numbers) {
  struct {
    double value;
    const char* text;
  } const table[] = {{0, "0"},
                     {-0.0, "0"},
                     {1, "1"},
                     {-1, "-1"},
                     {10, "10"},
                     {500, "500"},
                     {0.454, "0.454"},
                     {5.25, "5.25"},
                     {-73.8301, "-73.8301"},
                     {0.1, "0.1"},
                     {1.0 / 3, "0.333333333333"},
                     {2.0 / 3, "0.666666666667"},
                     {999999999999.9, "1000000000000"},
                     {1700000000.5, "1700000000.5"},
                     {1e14, "100000000000000"},
                     {1e15, "1e+15"},
                     {1.5e300, "1.5e+300"},
                     {0.00001, "0.00001"},
                     {0.000001, "1e-6"},
                     {std::numeric_limits<double>::min(), "2.22507385851e-308"},
                     {std::numeric_limits<double>::max(), "1.79769313486e+308"},
                     {std::numeric_limits<double>::infinity(), "inf"},
                     {-std::numeric_limits<double>::infinity(), "-inf"},
                     {std::numeric_limits<double>::quiet_NaN(), ""}};
  for (const auto& row : table) {
    EXPECT_EQ(text(row.value), row.text) << row.value;
  }
}

TEST(Format, IsRightToTwelveDigits) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> digits(1, 10);
  std::uniform_int_distribution<int> exponents(-300, 300);
  for (int i = 0; i < 20000; ++i) {
    const double value = digits(random) * std::pow(10, exponents(random));
    const double read = std::strtod(text(value).c_str(), nullptr);
    ASSERT_NEAR(read / value, 1, 6e-12) << text(value);
  }
}

TEST(Format, TextIsCutAtItsEndAndSaysSo) {
  char bytes[4];
  Text text(bytes, sizeof bytes);
  text.put("abc");
  EXPECT_FALSE(text.full());
  text.put("de");
  EXPECT_TRUE(text.full());
  EXPECT_EQ(std::string(text.bytes(), text.size()), "abcd");
}

struct Disk {
  std::string content;
  int32_t room = 1 << 20;
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count) {
    auto& disk = *static_cast<Disk*>(self);
    const auto taken = std::min(disk.room, static_cast<int32_t>(count));
    disk.content.append(reinterpret_cast<const char*>(bytes), static_cast<size_t>(taken));
    disk.room -= taken;
    return taken;
  }
};

TEST(MissionLog, HandsOverMoreThanItsBufferHolds) {
  Disk disk;
  MissionLog log({&disk, Disk::write});
  for (int i = 0; i < 1000; ++i) {
    log.event(i, "something with a name of some length", "detail", i);
  }
  log.flush();
  EXPECT_EQ(std::count(disk.content.begin(), disk.content.end(), '\n'), 1001) << "the header too";
  EXPECT_NE(disk.content.find("\n999,event,something with a name of some length,999,detail,\n"),
            std::string::npos);
  EXPECT_EQ(log.failures(), 0U);
}

TEST(MissionLog, AFullDiskIsCountedAndLaterLinesStartAtALinesBeginning) {
  Disk disk;
  MissionLog log({&disk, Disk::write});
  log.event(0, "first", "", NAN);
  log.flush();
  const std::string before = disk.content;
  disk.room = 5;
  log.event(1, "lost", "", NAN);
  log.flush();
  EXPECT_EQ(log.failures(), 1U);
  disk.room = 1000;
  log.event(2, "kept", "", NAN);
  log.flush();
  EXPECT_EQ(disk.content, before + "1,eve\n2,event,kept,,,\n");
}

TEST(MissionLog, NamesOfAnyLengthFit) {
  Disk disk;
  MissionLog log({&disk, Disk::write});
  const std::string name(10000, 'x');
  log.event(1, name.c_str(), name.c_str(), 1);
  log.flush();
  EXPECT_EQ(disk.content, "time_s,record,name,value,from,to\n1,event," +
                              std::string(MissionLog::kNameBytes, 'x') + ",1," +
                              std::string(MissionLog::kNameBytes, 'x') + ",\n");
}

}  // namespace
}  // namespace glider::runtime
