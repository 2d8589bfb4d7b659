// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The tables [[instrument]] of a platform file, and what links them to the power table.

#include "hooks/protocol/sampling.h"
#include "platforms/load/load_platform.h"
#include "support/diagnostics/diagnostic.h"
#include "tests/slocum.h"
#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace glider::platforms {
namespace {

constexpr char kFile[] = GLIDER_SOURCE_DIR "/platforms/slocum.toml";

/// What is wrong with the Slocum's file when `from`, from its first [[instrument]] on, is `to`; "":
/// nothing.
std::string instrumentsWith(const std::string& from, const std::string& to) {
  std::string text = tests::slurp(kFile);
  const size_t at = text.find(from, text.find("[[instrument]]"));
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  text.replace(text.find("name = \"slocum\""), 15, "name = \"p\"");
  const tests::TemporaryFolder folder;
  const auto platform = loadPlatform(folder.write("p.toml", text));
  return platform ? "" : platform.error().message;
}

testing::AssertionResult refusesInstruments(const std::string& from, const std::string& to,
                                            const std::string& why) {
  const std::string told = instrumentsWith(from, to);
  return told.find(why) != std::string::npos ? testing::AssertionSuccess()
                                             : testing::AssertionFailure() << told;
}

TEST(Instruments, AreThoseOfTheFileInItsOrder) {
  const auto platform = loadPlatform(kFile);
  ASSERT_TRUE(platform);
  ASSERT_EQ(platform->instruments.size(), 3U);
  EXPECT_EQ(platform->instruments[0].name, "ctd");
  EXPECT_EQ(platform->instruments[2].vehicle_name, "c_oxy4_on");
  for (uint32_t place = 0; place < 3; ++place) {
    const std::string& name = platform->instruments[place].name;
    const auto row = std::ranges::find(platform->power.draws, name, &Draw::device);
    ASSERT_NE(row, platform->power.draws.end()) << name;
    EXPECT_EQ(row->instrument, place);
    EXPECT_EQ(row->reading_s, platform->instruments[place].reading_s);
  }
  EXPECT_FALSE(platform->power.draws.front().instrument) << "the hotel is none";
}

TEST(Instruments, HaveNamesAndNumbers) {
  EXPECT_EQ(instrumentsWith("reading_s = 4.0", "reading_s = 2.0"), "");
  EXPECT_TRUE(refusesInstruments("reading_s = 4.0", "reading_s = 0.0", "must be positive"));
  EXPECT_TRUE(refusesInstruments("shortest_s = 1.0", "shortest_s = -1.0", "shortest_s"));
  EXPECT_TRUE(refusesInstruments("name = \"ctd\"", "name = \"c t d\"", "letters, digits"));
  EXPECT_TRUE(refusesInstruments("name = \"ctd\"", "name = \"optode\"", "of another instrument"));
  EXPECT_TRUE(refusesInstruments("name = \"ctd\"", "name = \"depth\"", "that of a sensor"));
  EXPECT_TRUE(refusesInstruments("vehicle_name = \"c_profile_on\"\n", "", "vehicle_name"));
  EXPECT_TRUE(refusesInstruments("shortest_s = 1.0", "shortest = 1.0", "shortest"));
}

TEST(Instruments, MeasureSensorsOfTheScienceComputer) {
  EXPECT_TRUE(refusesInstruments("\"sci_water_temp\"", "\"temp\"", "`temp` is none"));
  EXPECT_TRUE(refusesInstruments("\"sci_water_temp\"", "\"m_depth\"", "`m_depth` is none"));
  EXPECT_TRUE(
      refusesInstruments("[\"sci_oxy4_oxygen\"]", "[\"sci_water_temp\"]", "another instrument"));
  EXPECT_TRUE(refusesInstruments("[\"sci_oxy4_oxygen\"]", "[]", "what the instrument measures"));
}

TEST(Instruments, NeedTheirWordInAnInstruction) {
  EXPECT_TRUE(refusesInstruments("\"sci_hook_sampling\"", "\"sci_hook_sampled\"",
                                 "no sensor `sci_hook_sampling`"));
}

/// The share of the time for which the row of a device draws.
TEST(Instruments, AreOnForTheirReadings) {
  const auto platform = loadPlatform(kFile);
  ASSERT_TRUE(platform);
  const auto ctd = std::ranges::find(platform->power.draws, "ctd", &Draw::device);
  EXPECT_FALSE(shareOn(*ctd, kHookSamplingOfVehicle));
  EXPECT_EQ(shareOn(*ctd, kHookSamplingOff), 0);
  EXPECT_EQ(shareOn(*ctd, kHookSamplingFastest), 1);
  EXPECT_EQ(shareOn(*ctd, hookSamplingCode(2)), 1);
  EXPECT_EQ(shareOn(*ctd, hookSamplingCode(40)), 0.1);
}

}  // namespace
}  // namespace glider::platforms
