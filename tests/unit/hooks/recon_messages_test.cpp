// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Lines of the driver of UC Santa Barbara, messages against a second codec, and lines that are
// none.

#include "hooks/recon/codec.h"
#include "tests/unit/hooks/recon_named.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace glider::hooks::recon {
namespace {

using recon_described::described;
using recon_described::isSame;
using recon_described::lineOf;
using recon_described::randomValues;
using recon_described::shown;
using recon_described::summed;
using recon_described::valuesOf;
using namespace recon_named;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <typename Message>
std::string written(const Message& message) {
  char bytes[kMostLine];
  return {bytes, encode(message, bytes, sizeof bytes)};
}

/// The line, as a reader gives it, without its sum.
Line lineIn(const std::string& text) {
  return {text.data(), static_cast<uint32_t>(text.size())};
}

template <typename Message>
bool reads(const std::string& text, Message& message) {
  return decode(lineIn(text), message);
}

template <typename Message>
bool reads(const std::string& text) {
  Message message;
  return reads(text, message);
}

constexpr char kState[] =
    "#S,T15:46:20.5,LAT41N32.123,LON070W38.250,D12.5,DG15.0,A3.25,P-4.5,R1.5,TR1000,TRG1050,V1.75,"
    "H271.5,HR-2.5,HG270.0,M0D,L7,";

/// The state with one field replaced.
std::string stateWith(size_t index, const std::string& field) {
  std::string text;
  size_t at = 0;
  for (size_t i = 0; at < sizeof kState - 1; ++i) {
    const size_t comma = std::string_view(kState).find(',', at);
    text += (i == index ? field : std::string(kState + at, comma - at)) + ",";
    at = comma + 1;
  }
  return text;
}

TEST(ReconMessages, CommandsAreThoseOfTheDriver) {
  EXPECT_EQ(written(HeadingGoal{90}), "#C,Heading,Goal,90.000000,*2A\n");
  EXPECT_EQ(written(SpeedGoal{1.5, SpeedUnit::MetresPerSecond}),
            "#C,Speed,1.500000 meters/sec,*A3\n");
  EXPECT_EQ(written(DepthGoal{10}), "#C,Depth,Depth,10.000000,*D9\n");
  EXPECT_EQ(written(TriangleGoal{3, 3, 10, 30}),
            "#C,Depth,Triangle,3.000000,3.000000,10.000000,30.000000,*51\n");
  EXPECT_EQ(written(Override{true}), "#E,1,*1B\n");
  EXPECT_EQ(written(Override{false}), "#E,0,*1A\n");
  EXPECT_EQ(written(KeepAlive()), "#V,0.000000,*79\n");
  EXPECT_EQ(written(TimeQuery()), "#s,Time,query,*09\n");
  EXPECT_EQ(written(SpeedGoal{1000, SpeedUnit::Rpm}), summed("#C,Speed,1000.000000 rpm,*"));
  EXPECT_EQ(written(ModemText{textOf("HELLO")}), summed("#m 1,1, HELLO, *"));
}

TEST(ReconMessages, AreAllDescribed) {
  std::vector<std::string> listed;
#define RECON_MESSAGE(name) listed.push_back(#name);
#include "hooks/recon/messages.def"
#undef RECON_MESSAGE
  std::ranges::sort(listed);
  EXPECT_EQ(listed, described());
}

int rounds() {
  const char* const given = std::getenv("GLIDER_RECON_ROUNDS");
  return given != nullptr ? std::atoi(given) : 200;
}

/// In both directions, and no line is also read as another message.
TEST(ReconMessages, AreReadAndWrittenAsTheSecondCodecDoes) {
  std::mt19937 random(3);
  for (const std::string& name : described()) {
    for (int round = 0; round < rounds(); ++round) {
      const Values values = randomValues(name, random);
      const std::string line = lineOf(name, values);
      EXPECT_TRUE(withMessage(name, [&](auto message) {
        Setter set{values};
        each(set, message);
        EXPECT_EQ(written(message), line) << name;
        const auto again = valuesOf(name, written(message));
        ASSERT_TRUE(again) << line;
        EXPECT_TRUE(isSame(*again, values)) << line << shown(*again);
      }));
      const std::string text = line.substr(0, line.rfind('*'));
      for (const std::string& other : described()) {
        withMessage(other, [&](auto message) {
          const bool read = reads(text, message);
          ASSERT_EQ(read, name == other) << other << line;
          Reader reader;
          if (read) {
            each(reader, message);
          }
          EXPECT_TRUE(!read || isSame(reader.values, values)) << line << shown(reader.values);
        });
      }
    }
  }
}

TEST(ReconMessages, AStateIsRead) {
  State state;
  ASSERT_TRUE(reads(kState, state));
  EXPECT_EQ(state.time_s, 15 * 3600 + 46 * 60 + 20.5);
  EXPECT_NEAR(state.latitude_deg, 41 + 32.123 / 60, 1e-12);
  EXPECT_NEAR(state.longitude_deg, -(70 + 38.25 / 60), 1e-12);
  EXPECT_EQ(state.depth_m, 12.5);
  EXPECT_EQ(state.depth_goal_m, 15);
  EXPECT_EQ(state.altitude_m, 3.25);
  EXPECT_EQ(state.pitch_deg, -4.5);
  EXPECT_EQ(state.roll_deg, 1.5);
  EXPECT_EQ(state.rpm, 1000);
  EXPECT_EQ(state.rpm_goal, 1050);
  EXPECT_EQ(state.speed_m_s, 1.75);
  EXPECT_EQ(state.heading_deg, 271.5);
  EXPECT_EQ(state.heading_rate_deg_s, -2.5);
  EXPECT_EQ(state.heading_goal_deg, 270);
  EXPECT_EQ(state.mode, Mode::Override);
  EXPECT_EQ(state.leg, 7);
}

TEST(ReconMessages, AStateNeedsItsFields) {
  const std::string state = kState;
  EXPECT_TRUE(reads<State>(state + "NEW1,"));
  EXPECT_TRUE(reads<State>(state.substr(0, state.size() - 1)));  // no comma before the sum
  EXPECT_FALSE(reads<State>(state.substr(0, state.rfind(',', state.size() - 2) + 1)));
  EXPECT_FALSE(reads<State>(""));
  EXPECT_FALSE(reads<State>("#S,"));
}

/// Each field with another prefix, and each measured one with what is not a number.
TEST(ReconMessages, AFieldInAnotherPlaceIsRefused) {
  constexpr size_t kFields = 17;
  constexpr size_t kGoals[] = {5, 10, 14, 16};
  ASSERT_EQ(stateWith(99, ""), kState);
  for (size_t i = 0; i < kFields; ++i) {
    const bool goal = std::ranges::find(kGoals, i) != std::end(kGoals);
    EXPECT_EQ(reads<State>(stateWith(i, "Q1.0")), goal) << i;
    EXPECT_FALSE(reads<State>(stateWith(i, "x1.0"))) << i;
    EXPECT_FALSE(reads<State>(stateWith(i, "D1.0.0"))) << i;
    EXPECT_FALSE(reads<State>(stateWith(i, "D1 "))) << i;
  }
  EXPECT_FALSE(reads<State>(stateWith(12, "HR1.0")));
  EXPECT_FALSE(reads<State>(stateWith(13, "H1.0")));
  EXPECT_FALSE(reads<State>(stateWith(8, "TR1.0")));
}

TEST(ReconMessages, WhatTheVehicleDoesNotKnowIsUnknown) {
  State state;
  ASSERT_TRUE(reads(stateWith(6, "A0.00"), state));
  EXPECT_TRUE(std::isnan(state.altitude_m));
  ASSERT_TRUE(reads(stateWith(4, "D"), state));
  EXPECT_TRUE(std::isnan(state.depth_m));
  ASSERT_TRUE(reads(stateWith(4, "Dnan"), state));
  EXPECT_TRUE(std::isnan(state.depth_m));
  ASSERT_TRUE(reads(stateWith(4, "D0.0"), state));
  EXPECT_EQ(state.depth_m, 0);
  ASSERT_TRUE(reads(stateWith(1, "T"), state));
  EXPECT_TRUE(std::isnan(state.time_s));
  ASSERT_TRUE(reads(stateWith(2, "LAT"), state));
  EXPECT_TRUE(std::isnan(state.latitude_deg));
}

TEST(ReconMessages, TimesOfDay) {
  const auto timeOf = [](const std::string& field) {
    State state;
    return reads(stateWith(1, field), state) ? state.time_s : -1;
  };
  EXPECT_EQ(timeOf("T00:00:00.0"), 0);
  EXPECT_NEAR(timeOf("T23:59:59.9"), 86399.9, 1e-9);
  EXPECT_EQ(timeOf("T23:59:60.5"), 86400.5);  // a leap second
  EXPECT_EQ(timeOf("T12:34:56"), 45296);
  for (const char* field : {"T24:00:01.1", "T12:60:00.0", "T12:00:61.0", "T1:00:00.0", "T12:0:00.0",
                            "T12-00:00.0", "T12:00-00.0", "T12:00:", "T12:00:-1.0", "T12:00:1e1",
                            "T12:00:.5", "12:00:00.0", "T12:00:00.0x"}) {
    EXPECT_EQ(timeOf(field), -1) << field;
  }
}

TEST(ReconMessages, PositionsOfAllHemispheres) {
  const auto placeOf = [](size_t index, const std::string& field) {
    State state;
    const bool read = reads(stateWith(index, field), state);
    return !read ? kNaN : index == 2 ? state.latitude_deg : state.longitude_deg;
  };
  EXPECT_NEAR(placeOf(2, "LAT41S32.1"), -(41 + 32.1 / 60), 1e-12);
  EXPECT_NEAR(placeOf(2, "LAT00S30.000"), -0.5, 1e-12);
  EXPECT_NEAR(placeOf(2, "LAT90N00.000"), 90, 1e-12);
  EXPECT_NEAR(placeOf(3, "LON179E59.999"), 179 + 59.999 / 60, 1e-12);
  EXPECT_NEAR(placeOf(3, "LON180W00.000"), -180, 1e-12);
  EXPECT_NEAR(placeOf(3, "LON5E0.5"), 5 + 0.5 / 60, 1e-12);
  for (const char* field :
       {"LAT91N00.000", "LAT90N00.001", "LAT41N60.000", "LAT41E32.000", "LATN32.000", "LAT41N",
        "LAT41N-1.0", "LAT-41N32.0", "LAT41.5N1.0", "LAT41", "LAT4100000N1.0", "LON41N32.0"}) {
    EXPECT_TRUE(std::isnan(placeOf(2, field))) << field;
  }
  EXPECT_TRUE(std::isnan(placeOf(3, "LON180E00.001")));
  EXPECT_TRUE(std::isnan(placeOf(3, "LON070N38.0")));
}

/// A minute that is rounded up to 60 is the next degree.
TEST(ReconMessages, APositionIsRoundedAsAWhole) {
  State state;
  state.latitude_deg = 41.99999999;
  state.longitude_deg = -70.99999999;
  const std::string line = written(state);
  EXPECT_NE(line.find(",LAT42N00.000,LON071W00.000,"), std::string::npos) << line;
}

TEST(ReconMessages, ModesAreHexadecimal) {
  const auto modeOf = [](const std::string& field) {
    State state;
    return reads(stateWith(15, field), state) ? state.mode : -1;
  };
  EXPECT_EQ(modeOf("M0D"), 0x0D);
  EXPECT_EQ(modeOf("M0d"), 0x0D);
  EXPECT_EQ(modeOf("M1"), 1);
  EXPECT_EQ(modeOf("M1F"), 0x1F);
  EXPECT_EQ(modeOf("MFF"), 0xFF);
  for (const char* field : {"M", "M0G", "M0/", "M00D", "0D", "M-1", "M0:"}) {
    EXPECT_EQ(modeOf(field), -1) << field;
  }
}

TEST(ReconMessages, CommandsAreExact) {
  EXPECT_TRUE(reads<Override>("#E,1,"));
  EXPECT_FALSE(reads<Override>("#E,2,"));
  EXPECT_FALSE(reads<Override>("#E,,"));
  EXPECT_FALSE(reads<Override>("#E,1,1,"));
  EXPECT_FALSE(reads<HeadingGoal>("#C,Heading,Goal,nan,"));
  EXPECT_FALSE(reads<HeadingGoal>("#C,Heading,Goal,1e999,"));
  EXPECT_FALSE(reads<DepthGoal>("#C,Depth,Depth,,"));
  EXPECT_FALSE(reads<DepthGoal>("#C,Depth,Depth,1.0,2.0,"));
  EXPECT_FALSE(reads<SpeedGoal>("#C,Speed,1.0,"));
  EXPECT_FALSE(reads<SpeedGoal>("#C,Speed,1.0 knots,"));
  EXPECT_FALSE(reads<SpeedGoal>("#C,Speed,1.0  rpm,"));
  EXPECT_FALSE(reads<KeepAlive>("#V,1.000000,"));
  EXPECT_FALSE(reads<TimeSet>("#s,TIME,-1,"));
  EXPECT_FALSE(reads<TimeSet>("#s,TIME,,"));
  EXPECT_FALSE(reads<ModemData>("#m,MSG_DATA,1.5,2,x,"));
  EXPECT_FALSE(reads<ModemData>("#m,MSG_DATA,1,65536,x,"));
  EXPECT_FALSE(reads<ModemData>("#m,ACK,1,2,x,"));
}

TEST(ReconMessages, TextsMayHaveCommas) {
  ModemData data;
  const std::string line = "#m,MSG_DATA,3,4,one,two,";
  ASSERT_TRUE(reads(line, data));
  EXPECT_EQ(data.source, 3U);
  EXPECT_EQ(data.destination, 4U);
  EXPECT_EQ(data.text, textOf("one,two"));
  ModemText text;
  const std::string sent = "#m 1,1, one, two, ";
  ASSERT_TRUE(reads(sent, text));
  EXPECT_EQ(text.text, textOf("one, two"));
  EXPECT_FALSE(reads<ModemText>("#m 1,1, one, two,"));
  SimulationText told;
  const std::string nothing = "#G,,";
  ASSERT_TRUE(reads(nothing, told));
  EXPECT_EQ(told.text.size, 0U);
  EXPECT_FALSE(reads<SimulationText>("#G"));
  EXPECT_FALSE(reads<SimulationText>("#g,x,"));
  std::string many = "#G,";
  for (int i = 0; i < 40; ++i) {
    many += "x,";
  }
  ASSERT_TRUE(reads(many, told));
  EXPECT_EQ(told.text.size, many.size() - 4);
}

/// The vehicle would fly something else, or the line would be another one.
TEST(ReconMessages, WhatMakesNoSenseIsNotWritten) {
  for (const double number : {kNaN, kInfinity, -kInfinity}) {
    EXPECT_EQ(written(HeadingGoal{number}), "");
    EXPECT_EQ(written(SpeedGoal{number, SpeedUnit::Rpm}), "");
    EXPECT_EQ(written(DepthGoal{number}), "");
    EXPECT_EQ(written(TriangleGoal{3, number, 10, 30}), "");
    EXPECT_EQ(written(TimeSet{number}), "");
  }
  for (const char* text : {"a\n#E,1,*1B", "#", "*", "\x01", "\x7F", "\xFC"}) {
    EXPECT_EQ(written(ModemText{textOf(text)}), "") << text;
    EXPECT_EQ(written(SimulationText{textOf(text)}), "") << text;
  }
  EXPECT_NE(written(ModemText{textOf(" ~")}), "");
}

TEST(ReconMessages, ALineMustFit) {
  char bytes[32];
  EXPECT_EQ(encode(HeadingGoal{90}, bytes, 30), 30U);
  EXPECT_EQ(encode(HeadingGoal{90}, bytes, 29), 0U);
  EXPECT_EQ(encode(HeadingGoal{90}, bytes, 0), 0U);
  char large[2 * kMostLine];
  const std::string text(kMostLine - 7, 'x');  // "#G," ",*HH\n" are 8 bytes
  EXPECT_EQ(encode(SimulationText{textOf(text.c_str())}, large, sizeof large), 0U);
  EXPECT_EQ(encode(SimulationText{textOf(text.c_str() + 1)}, large, sizeof large), kMostLine);
}

TEST(ReconMessages, AtMost32FieldsAreRead) {
  std::string state = kState;
  for (int i = 17; i < 32; ++i) {
    state += "X,";
  }
  EXPECT_TRUE(reads<State>(state));
  EXPECT_FALSE(reads<State>(state + "X,"));
  EXPECT_FALSE(reads<State>(state + "X"));
}

}  // namespace
}  // namespace glider::hooks::recon
