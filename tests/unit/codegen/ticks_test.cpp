// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Single ticks of compiled missions, flown in this process, at the edges that random missions
// seldom meet.

#include "codegen/load/loaded_mission.h"
#include "tests/unit/codegen/compiled_mission.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <tuple>
#include <vector>

namespace glider::codegen_tests {
namespace {

constexpr uint32_t kDepth = 1, kTemp = 2, kWarm = 3;

struct Tick {
  double time;
  std::vector<GliderUpdate> updates;
};

std::string sensor(const std::string& name, const std::string& vehicle, uint32_t id) {
  return fmt::format(
      "sensor {} vehicle {} id {} encoding linear to_si 1 lowest -100 highest 100 stale_after 20\n",
      name, vehicle, id);
}

std::string state(const std::string& name, const std::string& cases) {
  return fmt::format(
      "state {} route drift () profile yo (5:length, 10:length, 0.4:angle, 0.4:angle) {}\n", name,
      cases);
}

/// A mission with three sensors; `text` has its states.
codegen::LoadedMission load(const std::string& text) {
  const Checked checked = checkedMission(
      "glider_ir 1\nmission m platform slocum\n" + sensor("depth: length", "m_depth", kDepth) +
      sensor("temp: temperature", "sci_water_temp", kTemp) +
      sensor("warm: temperature", "sci_water_temp", kWarm) +
      "behaviour profile yo symbol \"glider.profile.yo.length.length.angle.angle\" "
      "(top: length, bottom: length, dive: angle, climb: angle) reads (depth)\n"
      "behaviour route drift symbol \"glider.route.noheading\" () reads ()\n" +
      text);
  const auto shared = codegen::linkShared(checked.input(), board("host"), {});
  EXPECT_TRUE(shared.has_value()) << shared.error().message;
  auto loaded = codegen::LoadedMission::load(*shared);
  EXPECT_TRUE(loaded.has_value()) << loaded.error().message;
  return std::move(*loaded);
}

/// Whether the mission is over after `ticks`.
bool isOver(const std::string& text, const std::vector<Tick>& ticks) {
  const codegen::LoadedMission loaded = load(text);
  std::vector<double> memory(loaded.mission().context_bytes / sizeof(double));
  GliderContext* context = loaded.start(memory.data(), nullptr, nullptr, 0);
  for (const Tick& tick : ticks) {
    loaded.step(context, tick.time, tick.updates.data(),
                static_cast<uint32_t>(tick.updates.size()));
  }
  return context->finished != 0;
}

/// Whether `guard` is true after `ticks`, or was before.
bool isTrue(const std::string& before, const std::string& guard, const std::vector<Tick>& ticks) {
  return isOver(before + state("a", "case " + guard + " exit"), ticks);
}

TEST(Ticks, AWindowTakesReadingsThatAreSixSecondsOld) {
  const std::string window = "temporal highest always (max (sensor temp) (sensor warm)) over 4\n";
  const auto taken = [&](double time) {
    return isTrue(window, "(gt (temporal 0) 15:temperature)",
                  {{4, {{20, kTemp, 0}}}, {time, {{1, kWarm, 0}}}});
  };
  EXPECT_TRUE(taken(10));
  EXPECT_FALSE(taken(10.25));
}

TEST(Ticks, AWindowTakesAReadingWhenTheVehicleHasMovedAlong) {
  EXPECT_TRUE(isTrue("temporal highest always (sensor temp) over 4 along (sensor depth)\n",
                     "(gt (temporal 0) 15:temperature)",
                     {{4, {{20, kTemp, 0}, {1, kDepth, 0}}}, {8, {{6, kDepth, 0}}}}));
}

/// Each kind of window over a leg, on one dive and after it; `warm` says what the vehicle does.
TEST(Ticks, WindowsOverALeg) {
  const std::vector<Tick> dive = {{4, {{0, kWarm, 0}}},
                                  {8, {{1, kWarm, 0}, {0, kDepth, 0}, {20, kTemp, 0}}},
                                  {12, {{1, kWarm, 0}, {3, kDepth, 0}, {20, kTemp, 0}}},
                                  {16, {{1, kWarm, 0}, {6, kDepth, 0}, {14, kTemp, 0}}},
                                  {20, {{1, kWarm, 0}, {9, kDepth, 0}, {13, kTemp, 0}}},
                                  {24, {{0, kWarm, 0}}}};
  const std::string depth_where = " always (sensor depth) where (sensor temp)";
  const std::tuple<std::string, std::string, std::string> rows[] = {
      {"mean always (sensor temp)", "16.75", "temperature"},
      {"lowest always (sensor temp)", "13", "temperature"},
      {"highest always (sensor temp)", "20", "temperature"},
      {"spread always (sensor temp)", "7", "temperature"},
      {"at_lowest" + depth_where, "9", "length"},
      {"at_highest" + depth_where, "0", "length"},
      {"steepest always (sensor temp) where (sensor depth)", "-2", "dim(-1,0,0,0,1,0)"},
      {"at_steepest" + depth_where, "4.5", "length"}};
  for (const auto& [window, value, type] : rows) {
    const std::string text = "temporal " + window + " over this 1 2 along (sensor warm)\n";
    const std::string guard = fmt::format(
        "(and (gt (sensor depth) 8:length) (and (le (temporal 0) {0}:{1}) (ge (temporal "
        "0) {0}:{1})))",
        value, type);
    EXPECT_TRUE(isTrue(text, guard, dive)) << window;
  }
  EXPECT_TRUE(isTrue("temporal number always (sensor warm) over this 1 1 along (sensor warm)\n",
                     "(gt (temporal 0) 0.5)", dive));
}

TEST(Ticks, HeldForAnUnknownTime) {
  const std::string held =
      "temporal held always (gt (sensor temp) 15:temperature) for (mul 1:time (div (sensor depth) "
      "1:length))\n";
  const auto answers = [&](const std::string& guard, std::vector<GliderUpdate> updates) {
    return isTrue(held, guard, {{4, std::move(updates)}});
  };
  EXPECT_FALSE(answers("(not (temporal 0))", {{20, kTemp, 0}}));
  EXPECT_FALSE(answers("(temporal 0)", {{20, kTemp, 0}}));
  EXPECT_TRUE(answers("(not (temporal 0))", {{20, kTemp, 0}, {50, kDepth, 0}}));
  EXPECT_TRUE(answers("(temporal 0)", {{20, kTemp, 0}, {0, kDepth, 0}}));
}

/// `symbol` is a function of the C library.
std::string function(const std::string& symbol, const std::string& parameters,
                     const std::string& result) {
  return fmt::format("function f symbol {} ({}): {}\nuse f\n", symbol, parameters, result);
}

TEST(Ticks, ATruthValueOfCThatIsUnknown) {
  const std::string root = function("sqrt", "x: temperature", "bool lowest 0 highest 1");
  const auto answers = [&](const std::string& guard, double temperature) {
    return isTrue(root, guard, {{4, {{temperature, kTemp, 0}}}});
  };
  EXPECT_FALSE(answers("(call 0 (sensor temp))", -1));
  EXPECT_FALSE(answers("(not (call 0 (sensor temp)))", -1));
  EXPECT_TRUE(answers("(call 0 (sensor temp))", 1));
  EXPECT_TRUE(answers("(not (call 0 (sensor temp)))", 0));
}

TEST(Ticks, ResultsOfCAtTheEndsOfTheirRange) {
  const std::string same = function("rint", "x: temperature", "number lowest -3 highest 2");
  const auto result = [&](double temperature, const std::string& is) {
    return isTrue(same, "(" + is + ")", {{4, {{temperature, kTemp, 0}}}});
  };
  EXPECT_TRUE(result(2, "eq (call 0 (sensor temp)) 2"));
  EXPECT_TRUE(result(-3, "eq (call 0 (sensor temp)) -3"));
  EXPECT_FALSE(result(3, "known (call 0 (sensor temp))"));
  EXPECT_FALSE(result(-4, "known (call 0 (sensor temp))"));
}

/// A use is worth all the tick what its first call gave: in `b`, that of the state's own case.
TEST(Ticks, NoCallInACaseThatMayNotInterrupt) {
  const std::string text = function("rint", "x: temperature", "number lowest -100 highest 100") +
                           "always case (gt (sensor depth) 90:length) exit case (gt (call 0 "
                           "(sensor temp)) 15) goto b\n" +
                           state("a", "case (gt (sensor depth) 95:length) exit") +
                           state("b", "case (gt (call 0 (sensor warm)) 15) exit");
  EXPECT_TRUE(isOver(text, {{4, {{20, kTemp, 0}}}, {8, {{5, kTemp, 0}, {20, kWarm, 0}}}}));
  EXPECT_FALSE(isOver(text, {{4, {{20, kTemp, 0}}}, {8, {{20, kTemp, 0}, {5, kWarm, 0}}}}));
}

/// One bit for each row of a table of guards, in words of 32.
TEST(Ticks, RoomForTheRowsOfATable) {
  const auto bytes = [](size_t rows) {
    std::string cases, table = "table column missiontime (ge 500) ";
    for (size_t i = 0; i < rows; ++i) {
      cases += "case (ge missiontime 500:time) exit ";
      table += fmt::format("row {} (1 1) exact ", i);
    }
    return load(state("a", cases + table + "end")).mission().context_bytes;
  };
  EXPECT_EQ(bytes(1), bytes(32));
  EXPECT_EQ(bytes(33), bytes(64));
  EXPECT_LE(bytes(32), bytes(33));
}

}  // namespace
}  // namespace glider::codegen_tests
