// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/log/format.h"
#include "runtime/log/mission_log.h"
#include "tests/unit/runtime/log_csv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

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

TEST(Format, TextIsCutAtItsEndAndIsMarkedAsCut) {
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
  int syncs = 0;
  bool full = false;
  bool dies = false;  ///< takes what is written, and forgets it
  static int32_t sync(void* self) {
    auto& disk = *static_cast<Disk*>(self);
    ++disk.syncs;
    return disk.dies ? -1 : 0;
  }
  static int32_t renew(void* self) { return static_cast<const Disk*>(self)->full ? 1 : 0; }
};

class LogOf : public ::testing::Test {
 protected:
  LogOf() {
    mission_.name = "bench";
    mission_.state_count = 1;
    mission_.states = states_;
    state_.name = "only";
  }
  [[nodiscard]] static std::string eventRow(int time) {
    return std::to_string(time) + ",event,silent link," + std::to_string(time) + ",,\n";
  }
  void event(int time) { log_.event(time, LogEvent::SilentLink, LogDetail::None, time); }
  [[nodiscard]] std::string csv() const { return testing::csvOf(disk_.content, &damage_); }

  Disk disk_;
  GliderStateInfo state_{};
  const GliderStateInfo* const states_[1] = {&state_};
  GliderMission mission_{};
  MissionLog log_{{&disk_, Disk::write, Disk::sync, Disk::renew}, mission_};
  mutable logs::LogDamage damage_;
  const std::string head_ = "time_s,record,name,value,from,to\n0,start,bench,,,\n";
};

TEST_F(LogOf, HandsOverMoreThanItsBufferHolds) {
  std::string expected = head_;
  for (int i = 0; i < 1000; ++i) {
    event(i);
    expected += eventRow(i);
  }
  log_.flush();
  EXPECT_EQ(csv(), expected);
  EXPECT_EQ(damage_.bad + damage_.missing + damage_.unreadable, 0U);
  EXPECT_EQ(log_.failures(), 0U);
}

TEST_F(LogOf, AFullDiskIsCountedAndLaterRecordsAreReadable) {
  event(0);
  log_.flush();
  disk_.room = 5;
  event(1);
  log_.flush();
  EXPECT_EQ(log_.failures(), 1U);
  EXPECT_TRUE(log_.isFailing());
  disk_.room = 1000;
  event(2);
  log_.flush();
  EXPECT_FALSE(log_.isFailing());
  EXPECT_EQ(csv(), head_ + eventRow(0) + eventRow(2));
  EXPECT_EQ(damage_.bad, 1U);
  EXPECT_EQ(damage_.missing, 1U);
}

TEST_F(LogOf, WhoseFirstWriteFailsCanStillBeRead) {
  for (const int32_t room : {0, 1, 10}) {
    disk_.content.clear();
    MissionLog log({&disk_, Disk::write, Disk::sync, Disk::renew}, mission_);
    disk_.room = room;
    log.event(0, LogEvent::SilentLink, LogDetail::None, 0);
    log.flush();
    disk_.room = 1 << 20;
    for (int i = 1; i < 3; ++i) {
      log.event(i, LogEvent::SilentLink, LogDetail::None, i);
      log.flush();
    }
    EXPECT_EQ(csv(), head_ + eventRow(1) + eventRow(2)) << room;
  }
}

TEST_F(LogOf, AHeadOfWhichAPieceIsLostComesAgain) {
  const std::string long_name(MissionLog::kNameBytes, 'n');
  const GliderLogInfo item{"missiontime", 0, kGliderMissionTime, 0};
  std::vector<GliderStateInfo> states(100, state_);
  std::vector<const GliderStateInfo*> pointers;
  for (GliderStateInfo& state : states) {
    state.name = long_name.c_str();
    state.log = &item;
    state.log_count = 1;
    pointers.push_back(&state);
  }
  mission_.states = pointers.data();
  mission_.state_count = 100;
  disk_.room = 3000;  // less than the head
  event(0);
  log_.flush();
  EXPECT_TRUE(log_.isFailing());
  disk_.room = 1 << 20;
  GliderContext context{};
  context.mission = &mission_;
  context.state = 99;
  log_.values(context);
  log_.flush();
  EXPECT_TRUE(csv().ends_with("0,start,bench,,,\n0,value,missiontime,0,,\n")) << csv();
}

TEST_F(LogOf, ACardThatForgetsWhatItTookIsAFailure) {
  disk_.dies = true;
  event(0);
  log_.flush();
  EXPECT_EQ(log_.failures(), 1U);
  EXPECT_TRUE(log_.isFailing());
  disk_.dies = false;
  event(1);
  log_.flush();
  EXPECT_FALSE(log_.isFailing());
}

TEST_F(LogOf, NamesOfAnyLengthFit) {
  const std::string name(10000, 'x');
  mission_.name = name.c_str();
  event(1);
  log_.flush();
  EXPECT_EQ(csv(), "time_s,record,name,value,from,to\n0,start," +
                       std::string(MissionLog::kNameBytes, 'x') + ",,,\n" + eventRow(1));
}

TEST_F(LogOf, AfterAnyPowerCutAllBeforeItsEndIsRead) {
  std::string before = head_;
  for (int i = 0; i < 3; ++i) {
    event(i);
    log_.flush();
    before += eventRow(i);
  }
  const size_t whole = disk_.content.size();
  event(3);
  log_.flush();
  for (size_t cut = whole; cut < disk_.content.size(); ++cut) {
    const std::string torn = disk_.content.substr(0, cut);
    EXPECT_EQ(testing::csvOf(torn), before) << cut;
    // The program starts again, and writes behind it.
    Disk next{torn};
    MissionLog again({&next, Disk::write, Disk::sync, Disk::renew}, mission_);
    again.event(9, LogEvent::SilentLink, LogDetail::None, 9);
    again.flush();
    // Of a record that lacks but its end, that is put there.
    const std::string kept = before + (cut + 1 == disk_.content.size() ? eventRow(3) : "");
    EXPECT_EQ(testing::csvOf(next.content), kept + "0,start,bench,,,\n" + eventRow(9)) << cut;
  }
}

TEST_F(LogOf, IsOnTheCardWhenItMattersAndOnlyThen) {
  GliderSensorInfo sensor{"m_depth", nullptr, 1, 0, 1200, 20, 1, kGliderLinear};
  GliderReading reading{3, 0, 3, 1, 0};
  GliderLogInfo item{"depth", 0, kGliderSensor, 0};
  state_.log = &item;
  state_.log_count = 1;
  mission_.sensors = &sensor;
  mission_.sensor_count = 1;
  GliderContext context{};
  context.mission = &mission_;
  context.readings = &reading;
  log_.begin(context);
  log_.flush();
  EXPECT_EQ(disk_.syncs, 1);
  for (int i = 0; i < 10; ++i) {
    context.mission_time = i;
    log_.values(context);
    log_.flush();
  }
  EXPECT_EQ(disk_.syncs, 1);
  event(11);
  log_.flush();
  EXPECT_EQ(disk_.syncs, 2);
}

TEST_F(LogOf, AFullLogRestartsWithAllThatIsNeededToReadIt) {
  event(1);
  log_.flush();
  disk_.full = true;
  event(2);
  log_.flush();
  EXPECT_EQ(csv(), head_ + eventRow(1) + eventRow(2));
  disk_.full = false;
  disk_.content.clear();
  event(3);
  log_.flush();
  EXPECT_EQ(csv(), head_ + eventRow(3));
}

}  // namespace
}  // namespace glider::runtime
