// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/spelling.h"

#include <gtest/gtest.h>

namespace glider::frontend {
namespace {

TEST(Spelling, Distance) {
  EXPECT_EQ(editDistance("depth", "depth"), 0U);
  EXPECT_EQ(editDistance("depht", "depth"), 1U);
  EXPECT_EQ(editDistance("", "abc"), 3U);
  EXPECT_EQ(editDistance("temp", "tmp"), 1U);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3U);
}

TEST(Spelling, Closest) {
  EXPECT_EQ(closest("tmp", {"depth", "temp"}), "temp");
  EXPECT_EQ(closest("DEPTH", {"depth", "temp"}), "depth");
  EXPECT_EQ(closest("x", {"depth", "temp"}), "");
  EXPECT_EQ(closest("altitude", {"depth", "temp"}), "");
  EXPECT_EQ(closest("abc", {}), "");
}

TEST(Spelling, Suggestions) {
  const auto hint = [](std::string_view word, const std::vector<std::string_view>& candidates) {
    return didYouMean(word, candidates, "no").hint;
  };
  EXPECT_EQ(hint("tmp", {"temp"}), "did you mean `temp`?");
  EXPECT_EQ(hint("zzz", {"temp"}), "no");
  EXPECT_EQ(hint("temperature", {"depth", "temp"}), "did you mean `temp`?");
  EXPECT_EQ(hint("water_temp", {"depth", "temp"}), "did you mean `temp`?");
  EXPECT_EQ(hint("latitude", {"altitude", "lat", "lon"}), "did you mean `lat`?")
      << "the first letter is seldom wrong";
  EXPECT_EQ(hint("depthrat", {"depth", "depthrate"}), "did you mean `depthrate`?");
  EXPECT_EQ(hint("hover", {"climb_to", "hover_at"}), "did you mean `hover_at`?");
  EXPECT_EQ(hint("sci_water_temperature", {"sci_water_pressure", "sci_water_temp"}),
            "did you mean `sci_water_temp`?");
  EXPECT_EQ(hint("a_b", {"a"}), "no") << "one letter says nothing";
}

/// Only what differs in nothing but capitals, and from one word, is certain.
TEST(Spelling, CertainSuggestions) {
  const auto fix = [](std::string_view word, const std::vector<std::string_view>& candidates) {
    return didYouMean(word, candidates, "").fix;
  };
  EXPECT_EQ(fix("Temp", {"depth", "temp"}), "temp");
  EXPECT_EQ(fix("tempp", {"temp"}), "");
  EXPECT_EQ(fix("UP", {"up", "Up"}), "") << "two are meant";
  EXPECT_EQ(fix("up", {"Up"}), "") << "the definition may be wrong";
  EXPECT_EQ(fix("UP", {"up", "up"}), "up");
}

TEST(Spelling, UnitWords) {
  EXPECT_EQ(unitForWord("metres"), "m");
  EXPECT_EQ(unitForWord("Hours"), "h");
  EXPECT_EQ(unitForWord("C"), "degC");
  EXPECT_EQ(unitForWord("KM"), "km");
  EXPECT_EQ(unitForWord("parsec"), "");
}

}  // namespace
}  // namespace glider::frontend
