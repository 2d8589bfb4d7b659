// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Bounds that can be computed by hand, and what makes them greater.

#include "ir/prove/energy/energy_bound.h"

#include "compiler/compilation.h"
#include "tests/world/fleet.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace glider::tests {
namespace {

using ir::prove::EnergyBound;

constexpr double kHour_s = 3600;

std::string stateText(const std::string& name, const std::string& profile,
                      const std::string& cases) {
  return fmt::format(
      "state {}\nbegin\n  flightprofile {}\n  sensors missiontime, depth, temp, statetime\n"
      "  events\n{}end\n",
      name, profile, cases);
}

EnergyBound boundOf(const std::string& text, double board_W = 0) {
  setenv("GLIDERCC_SHARE", GLIDER_BINARY_DIR "/share/glidercc", 1);
  const auto compiled = compiler::compileText("test.mission", "mission test\n" + text);
  EXPECT_TRUE(compiled && compiled->checked) << text;
  const auto bound = ir::prove::energyBoundOf(compiled->checked->mission(), slocum(),
                                              platforms::BoardPower{board_W, 0, "", {}},
                                              ir::prove::Parameters::AsWritten);
  EXPECT_TRUE(bound) << text;
  return bound.value_or(EnergyBound{});
}

double amountOf(platforms::DrawWhen when) {
  const auto& draws = slocum().power.draws;
  double sum = 0;
  for (const platforms::Draw& draw : draws) {
    sum += draw.when == when ? draw.amount * (1 + draw.spread) : 0;
  }
  return sum;
}

/// What a glider takes at all times, W.
double always() {
  return amountOf(platforms::DrawWhen::Always) + amountOf(platforms::DrawWhen::Fin) +
         amountOf(platforms::DrawWhen::PitchBattery) * slocum().power.bounds->pitch_battery_share;
}

/// A yo between two depths, W: a whole cycle by the power table, the pump at the end of a dive.
double yoPower(double top_m, double bottom_m, double pitch_rad) {
  const platforms::Platform& p = slocum();
  const double cc = 2 * p.envelope.pump_cc;
  const double leg_s =
      cc / p.motion->pump_rate_cc_s +
      (bottom_m - top_m - p.find("m_depth")->noise) /
          (p.power.bounds->glide_m_s *
           std::sin(pitch_rad + p.power.bounds->pitch_off_deg * std::acos(-1.0) / 180));
  double out = 0;
  for (const platforms::Draw& draw : p.power.draws) {
    if (draw.when == platforms::DrawWhen::PumpOut) {
      const double deepest = bottom_m + p.envelope.inflection_overshoot_m;
      out += cc * (draw.amount + draw.amount_per_m * deepest) * (1 + draw.spread);
    }
  }
  const double in = cc * amountOf(platforms::DrawWhen::PumpIn);
  const double share = (pitch_rad + p.power.bounds->pitch_off_deg * std::acos(-1.0) / 180) /
                       p.envelope.steepest_pitch_rad;
  const double turns = 2 * share * p.power.bounds->pitch_battery_turn_s *
                       amountOf(platforms::DrawWhen::PitchBattery);
  // A turn may go on to the surface, and stays there as long as the pump takes there and back.
  const bool broaches = top_m < p.envelope.inflection_overshoot_m + 0.5;
  const double above =
      broaches ? 2 * cc / p.motion->pump_rate_cc_s * amountOf(platforms::DrawWhen::Surface) : 0;
  return always() + (out + in + turns + above) / (2 * leg_s);
}

TEST(EnergyBound, OfAYoIsThatOfItsCycle) {
  constexpr double kPitch = 26 * 3.14159265358979 / 180;
  for (const auto& [top, bottom] : {std::pair{5.0, 40.0}, {4.0, 100.0}, {10.0, 18.0}}) {
    const EnergyBound bound =
        boundOf(stateText("fly", fmt::format("yo({} m, {} m, 26 deg, 26 deg)", top, bottom),
                          "    case temp > 30 degC exit\n"));
    EXPECT_FALSE(bound.joules);
    EXPECT_NEAR(bound.watts, yoPower(top, bottom, kPitch), 0.001) << top << " to " << bottom;
    EXPECT_FALSE(bound.states.front().restless);
  }
}

/// Where a yo turns and the command comes late, hookbeh hovers meanwhile: by a port, but not after
/// a nap, from which the SBC is woken before.
TEST(EnergyBound, ALateCommandAtATurnTakesStrokesButNotAfterANap) {
  constexpr double kLate_s = 15;
  const auto wattsWith = [](const std::string& line, double late_s) {
    const auto compiled = compiler::compileText(
        "test.mission",
        "mission test\n" + line +
            stateText("fly", "yo(10 m, 100 m, 26 deg, 26 deg)", "    case temp > 30 degC exit\n"));
    platforms::Platform vehicle = slocum();
    vehicle.world.command_delay_s = late_s;
    return ir::prove::energyBoundOf(compiled->checked->mission(), vehicle, platforms::BoardPower{},
                                    ir::prove::Parameters::AsWritten)
        ->watts;
  };
  const double at_once = wattsWith("", 0);
  EXPECT_GT(wattsWith("", kLate_s), at_once * 1.1);
  EXPECT_NEAR(wattsWith("nap at most 4 min\n", kLate_s), at_once, 1e-9);
}

TEST(EnergyBound, UntilTheEndIsThatOfTheTime) {
  const std::string yo = "yo(5 m, 40 m, 26 deg, 26 deg)";
  const EnergyBound bound =
      boundOf(stateText("fly", yo, "    case missiontime > 20 h exit\n"), 3.0);
  ASSERT_TRUE(bound.joules);
  // A power cut may delay the end; a first dive and half a cycle more.
  const double least = (yoPower(5, 40, 26 * 3.14159265358979 / 180) + 3.0) * 20 * kHour_s;
  EXPECT_GT(*bound.joules, least);
  EXPECT_LT(*bound.joules, least * 1.03);
  double sum = 0;
  for (const ir::prove::DeviceEnergy& one : bound.devices) {
    sum += one.joules;
  }
  EXPECT_NEAR(sum, *bound.joules, *bound.joules * 1e-3);
  EXPECT_EQ(bound.devices.front().device, "pump");
  EXPECT_EQ(bound.devices[1].device, "SBC");
}

TEST(EnergyBound, AParameterIsWhatTheMissionSays) {
  const auto with = [](const char* depth) {
    return boundOf(fmt::format("param bottom: length = {} in 10 m .. 100 m\n", depth) +
                   stateText("fly", "yo(5 m, bottom, 26 deg, 26 deg)",
                             "    case temp > 30 degC exit\n"))
        .watts;
  };
  EXPECT_NEAR(with("40 m"), yoPower(5, 40, 26 * 3.14159265358979 / 180), 0.001);
  EXPECT_GT(with("15 m"), with("40 m"));
}

TEST(EnergyBound, DepthsThatAVariableMovesTogetherAreAsFarApartAsTheyAre) {
  const auto with = [](const char* change) {
    return boundOf("var middle: length = 40 m in 20 m .. 60 m\n" +
                   stateText("fly", "yo(middle - 15 m, middle + 15 m, 26 deg, 26 deg)",
                             fmt::format("{}    case temp > 30 degC exit\n", change)));
  };
  const EnergyBound steady = with("");
  EXPECT_LT(steady.watts, 36);
  // It may turn anywhere once the variable may move meanwhile.
  const EnergyBound moving =
      with("    case temp > 20 degC do set middle = clamp(depth, 20 m, 60 m) end stay\n");
  EXPECT_TRUE(moving.states.front().restless);
  EXPECT_GT(moving.watts, 40);
}

TEST(EnergyBound, ATimerOfTheProfileCounts) {
  const auto with = [](const char* period) {
    return boundOf(stateText(
        "fly",
        fmt::format("yo_and_surface(5 m, 60 m, 26 deg, 26 deg, period = {}, pause = 5 min)",
                    period),
        "    case temp > 30 degC exit\n"));
  };
  const EnergyBound seldom = with("6 h"), often = with("10 min");
  EXPECT_FALSE(seldom.states.front().restless);
  EXPECT_FALSE(often.states.front().restless);
  // How long it stays at the surface has no bound.
  const double floats = always() + amountOf(platforms::DrawWhen::Surface);
  EXPECT_NEAR(seldom.watts, floats, 0.01);
  EXPECT_GT(often.watts, seldom.watts + 0.05);
}

TEST(EnergyBound, StatesThatFollowOneAnotherAtOnceAreNamed) {
  const std::string up = stateText("up", "climb_to(10 m)", "    case temp > 20 degC goto down\n");
  const EnergyBound bound =
      boundOf(stateText("down", "dive_to(50 m)", "    case temp < 20 degC goto up\n") + up);
  EXPECT_EQ(bound.round.size(), 2U);
  EXPECT_LT(bound.round_s, 60);
  // To sink and climb takes a while.
  const EnergyBound slow =
      boundOf(stateText("down", "dive_to(50 m)", "    case depth > 45 m goto up\n") +
              stateText("up", "climb_to(10 m)", "    case depth < 15 m goto down\n"));
  EXPECT_TRUE(slow.round.empty());
  EXPECT_LT(slow.watts, 0.85 * bound.watts);
}

TEST(EnergyBound, ALeastTimeInAStateCounts) {
  const auto with = [](const char* least) {
    return boundOf(
        stateText("dive", "yo(5 m, 50 m, 26 deg, 26 deg)",
                  fmt::format("    case {}temp > 20 degC goto up\n", least)) +
        stateText("up", "surfaced", fmt::format("    case {}temp > 10 degC goto dive\n", least)));
  };
  const EnergyBound any = with(""), slow = with("statetime > 30 min && ");
  EXPECT_FALSE(any.round.empty());
  EXPECT_TRUE(slow.round.empty());
  EXPECT_LT(slow.watts, 12);
  EXPECT_GT(any.watts, 4 * slow.watts);
}

TEST(EnergyBound, TheTimesOfHeldAndOfWindowsCount) {
  const auto watts = [](const std::string& guard) {
    return boundOf("assume no outage\n" +
                   stateText("a", "yo(20 m, 150 m)", "    case " + guard + " goto b\n") +
                   stateText("b", "yo(20 m, 150 m)", "    case " + guard + " goto a\n"))
        .watts;
  };
  const double at_once = watts("temp > 10 degC");
  const double timed = watts("temp > 10 degC && statetime >= 10 min");
  EXPECT_LT(timed, 0.5 * at_once);
  EXPECT_NEAR(watts("held(temp > 10 degC, 10 min)"), timed, 0.01 * timed);
  EXPECT_NEAR(watts("mean(temp, 10 min) > 10 degC"), timed, 0.01 * timed);
  // A window goes on while its state waits for a return, a `held` begins again.
  const auto called = [](const std::string& guard) {
    return boundOf("assume no outage\n" +
                   stateText("a", "yo(20 m, 150 m)", "    case " + guard + " call b\n") +
                   stateText("b", "yo(20 m, 150 m)", "    case resumetime >= 10 s return\n"))
        .watts;
  };
  EXPECT_GT(called("mean(temp, 10 min) > 10 degC"), 0.9 * called("temp > 10 degC"));
  EXPECT_LT(called("held(temp > 10 degC, 10 min)"), 0.7 * called("temp > 10 degC"));
}

TEST(EnergyBound, AChainThatLastsForYearsHasAnEnd) {
  std::string text;
  for (int i = 0; i < 20; ++i) {
    text += stateText(fmt::format("s{}", i), "surfaced",
                      fmt::format("    case statetime > 30 days goto s{}\n", i + 1));
  }
  const EnergyBound bound =
      boundOf(text + stateText("s20", "surfaced", "    case statetime > 1 min exit\n"));
  ASSERT_TRUE(bound.joules);
  EXPECT_NEAR(*bound.joules / (20 * 30 * 24 * kHour_s),
              always() + amountOf(platforms::DrawWhen::Surface), 0.1);
}

TEST(EnergyBound, CountersEndWhatWouldGoOn) {
  const auto with = [](const char* counts) {
    return boundOf(
        fmt::format("var n: number = 0 in 0 .. 4\n"
                    "state dive\nbegin\n  flightprofile yo(5 m, 50 m, 26 deg, 26 deg)\n"
                    "  sensors depth, statetime\n  events\n"
                    "    case statetime > 30 min && {} do set n = min(n + 1, 4) end goto up\n"
                    "    case statetime > 35 min exit\nend\n",
                    counts) +
        stateText("up", "surfaced", "    case statetime > 10 min goto dive\n"));
  };
  const EnergyBound three = with("n < 3"), one = with("n < 1");
  ASSERT_TRUE(three.joules && one.joules);
  EXPECT_GT(*three.joules, *one.joules + 2 * 35 * 60 * 5.0);
  EXPECT_LT(*three.joules, *one.joules * 3);
}

/// Missions that a first form of the bound got wrong: a mission, and what a flight of the simulator
/// took by the numbers of the table, W.
struct Hungry {
  const char* what;
  std::string text;
  double flown_W;
};

std::string profileText(const std::string& body) {
  return "flightprofile own()\nbegin\n" + body + "end\n" +
         stateText("fly", "own()", "    case temp > 90 degC exit\n");
}

class Hunger : public testing::TestWithParam<Hungry> {};

TEST_P(Hunger, IsWithinTheBound) {
  const EnergyBound bound = boundOf(GetParam().text, 3.42);
  EXPECT_GT(bound.watts, GetParam().flown_W * 1.1) << GetParam().what;
  EXPECT_LT(bound.watts, 130);
  for (const auto& state : bound.states) {
    EXPECT_GT(state.watts, 3) << GetParam().what;
  }
}

INSTANTIATE_TEST_SUITE_P(
    , Hunger,
    testing::Values(
        Hungry{"nothing is commanded", profileText("  entry do log \"on\" end\n"), 11.5},
        Hungry{"it may leave early only",
               stateText("fly", "yo(5 m, 10 m)",
                         "    case statetime < 1 min && depth > 9 m goto idle\n") +
                   stateText("idle", "surfaced", "    case statetime > 1 min exit\n"),
               8.1},
        Hungry{"ascends to two depths",
               profileText("  entry do ascend(165 m, 26 deg) end\n  events\n"
                           "    case depth > 151 m do ascend(4 m, 26 deg) end stay\n"
                           "    case depth < 150 m do ascend(165 m, 26 deg) end stay\n"),
               15.1},
        Hungry{"hovers at two depths",
               profileText("  entry do hover(160 m) end\n  events\n"
                           "    case depth > 150 m do hover(140 m) end stay\n"
                           "    case depth < 150 m do hover(160 m) end stay\n"),
               19.6},
        Hungry{
            "hovers at a depth that is moved",
            "var at: length = 140 m in 100 m .. 180 m\n" +
                stateText("fly", "hover_at(at)",
                          "    case temp > 90 degC exit\n"
                          "    case true do set at = clamp(300 m - at, 100 m, 180 m) end stay\n"),
            18.9},
        Hungry{"waits at a target short of another",
               profileText("  entry do descend(160 m, 26 deg) end\n  events\n"
                           "    case depth >= 165 m do ascend(10 m, 26 deg) end stay\n"
                           "    case temp > 80 degC do descend(165 m, 26 deg) end stay\n"),
               10.3},
        Hungry{"a command whose depth may be unknown",
               profileText("  entry do descend(160 m, 26 deg) end\n  events\n"
                           "    case depth >= 160 m do ascend(clamp(altitude, 4 m, 10 m), 26 deg) "
                           "end stay\n"),
               10.2},
        Hungry{"a new pitch each time",
               "var steep: angle = 45 deg in 11 deg .. 45 deg\n" +
                   stateText("fly", "yo(5 m, 180 m, steep, steep)",
                             "    case temp > 90 degC exit\n"
                             "    case true do set steep = clamp(56 deg - steep, 11 deg, 45 deg) "
                             "end stay\n"),
               16},
        Hungry{"a state that is entered again near its turn",
               "flightprofile nod()\nbegin\n  entry do descend(60 m, 30 deg) end\n  events\n"
               "    case depth <= 58 m do surface() end stay\nend\n" +
                   stateText("fly", "nod()",
                             "    case missiontime > 3 h exit\n    case depth <= 57 m goto fly\n"),
               15.4},
        Hungry{"descends to the surface", profileText("  entry do descend(0.5 m, 26 deg) end\n"),
               10.5}));

/// `surface` pumps to the end, and a climb that has arrived holds its depth: by turns they take
/// strokes, though both are upwards.
TEST(EnergyBounds, TwoCommandsUpwardsTakeStrokes) {
  const auto text = [](const char* other) {
    return fmt::format(
        "flightprofile flick(at: length)\nbegin\n  var up: bool = false\n"
        "  var since: time = missiontime\n  entry do ascend(at, 26 deg) end\n  events\n"
        "    case up && missiontime - since >= 16 s do set since = missiontime set up = false "
        "ascend(at, 26 deg) end stay\n"
        "    case !up && missiontime - since >= 16 s do set since = missiontime set up = true "
        "{} end stay\nend\nstate fly\nbegin\n  flightprofile flick(150 m)\n"
        "  sensors missiontime, depth\n  events\n    case missiontime > 2 h exit\nend\n",
        other);
  };
  const platforms::Platform& p = slocum();
  double stroke_j = 0;
  for (const platforms::Draw& draw : p.power.draws) {
    const bool pumps =
        draw.when == platforms::DrawWhen::PumpOut || draw.when == platforms::DrawWhen::PumpIn;
    stroke_j +=
        pumps ? 2 * p.envelope.pump_cc * (draw.amount + draw.amount_per_m * 150) * (1 + draw.spread)
              : 0;
  }
  EXPECT_GT(*boundOf(text("surface()")).joules, 2 * kHour_s / 32 * stroke_j);
}

}  // namespace
}  // namespace glider::tests
