// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// No random flight stays under water longer, or has a clock or depth beyond what is proved about a
// single moment.

#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/profile_surfacing.h"
#include "ir/prove/abstract/surfacing.h"
#include "ir/prove/encoding/any_moment.h"
#include "ir/prove/falsification/random_flight.h"
#include "ir/verify/verify.h"
#include "tests/random_missions/random.h"
#include "tests/unit/ir/missions.h"
#include "tests/unit/ir/slocum.h"

#include <fmt/format.h>

#include <functional>

namespace glider::ir::prove {
namespace {

constexpr double kLong = 50000;

/// With profiles that dive, climb and surface, and a requirement that a test may replace.
const std::string kDives = kHeader +
                           "behaviour profile yo symbol \"\" () reads ()\n"
                           "behaviour route way symbol \"\" () reads ()\n";

std::string profileOf(random_missions::Random& random, bool up) {
  if (up) {
    return "begin entry do surface () end end ";
  }
  const auto depth = 5 + 5 * random.below(4);
  const std::string down = fmt::format("descend ({}:length, 0.4:angle)", depth);
  switch (random.below(3)) {
    case 0:
      return "begin entry do " + down + " end end ";
    case 1:
      return "begin entry do ascend (3:length, 0.4:angle) end case (le (sensor depth) 4:length) "
             "do " +
             down + " end stay end ";
    default:
      return "begin entry do if (gt (sensor temp) 10:temperature) surface () else " + down +
             " end end end ";
  }
}

std::string timeOf(random_missions::Random& random, uint64_t most) {
  return std::to_string(20 * (1 + random.below(most))) + ":time";
}

/// What leads out of a state that dives, or that climbs.
std::string guardOf(random_missions::Random& random, bool up) {
  const std::string clock = random.below(3) == 0 ? "statetime" : "resumetime";
  switch (random.below(up ? 6 : 4)) {
    case 0:
      return "(and (gt (sensor temp) 3:temperature) (ge " + clock + " " + timeOf(random, 60) + "))";
    case 1:
      return "(lt (sensor depth) " + std::string(random.below(2) == 0 ? "1" : "1.3") + ":length)";
    default:
      return "(ge " + clock + " " + timeOf(random, up ? 100 : 30) + ")";
  }
}

/// `missiontime` is later than a while after the timer, said in several ways.
std::string timerOf(random_missions::Random& random) {
  const std::string time = timeOf(random, 40);
  switch (random.below(5)) {
    case 0:
      return "(ge missiontime (add (var t) " + time + "))";
    case 1:
      return "(lt " + time + " (sub missiontime (var t)))";
    case 2:
      return "(or (gt (sensor temp) 25:temperature) (gt (sub missiontime (var t)) " + time + "))";
    case 3:
      return "(and (gt (sensor temp) 8:temperature) (gt (sub missiontime (var t)) " + time + "))";
    default:
      return "(gt (sub missiontime (var t)) " + time + ")";
  }
}

/// May set the timer.
std::string setOf(random_missions::Random& random, uint64_t often) {
  return random.below(10) < often ? "do set t missiontime end " : "";
}

/// A ring of states of which some climb to the surface; some call another for a while, and `always`
/// may interrupt. With `timed`, a variable holds when a case last set it.
std::string randomDives(uint64_t seed, bool timed = false) {
  random_missions::Random random(seed);
  const auto states = 2 + random.below(3);
  const auto timer = [&](uint64_t often, const std::string& transition) {
    return timed && random.below(10) < often
               ? "case " + timerOf(random) + " " + setOf(random, 7) + transition + " "
               : std::string();
  };
  const auto name = [&](uint64_t i) { return std::string(1, static_cast<char>('a' + i % states)); };
  std::string text = kDives;
  if (timed) {
    text += "variable t : time mission\ninitial t 0:time\nalways ";
    text += random.below(5) == 0
                ? "case (lt (sensor depth) " + std::string(random.below(2) == 0 ? "1" : "9") +
                      ":length) do set t missiontime end stay "
                : "";
    text += random.below(5) == 0 ? "case (gt (sensor depth) 12:length) call z " : "";
    text += timer(8, random.below(3) == 0 ? "goto a" : "call z");
    text += random.below(5) == 0 ? "case (gt (sensor temp) 30:temperature) goto b " : "";
  } else if (random.below(4) == 0) {
    text += "always case (gt (sensor depth) 12:length) call z ";
  } else if (random.below(6) == 0) {
    text +=
        "always case (gt (sensor temp) 30:temperature) do descend (9:length, 0.4:angle) end stay ";
  }
  for (uint64_t i = 0; i < states; ++i) {
    const bool up = i == 0 || random.below(3) == 0;
    text += "state " + name(i) + " route way begin end profile yo " + profileOf(random, up);
    if (random.below(5) == 0) {
      text +=
          "case (and (gt (sensor temp) 8:temperature) (lt statetime 900:time)) do descend "
          "(8:length, "
          "0.4:angle) end stay ";
    }
    if (random.below(4) == 0) {
      text += "case " + guardOf(random, false) + " call z ";
    }
    text += timer(3, "goto " + name(i + random.below(2)));
    text += "case " + guardOf(random, up) + " " + (timed ? setOf(random, 1) : "") + "goto " +
            name(i + 1) + " ";
    if (random.below(timed ? 5 : 2) == 0) {
      text += "case (ge resumetime " + timeOf(random, 100) + ") goto " + name(i + random.below(2)) +
              " ";
    }
    text += "\n";
  }
  const bool up = random.below(2) == 0;
  return text + "state z route way begin end profile yo " + profileOf(random, up) + "case " +
         guardOf(random, up) + " return case (ge statetime " + timeOf(random, 60) + ") return\n";
}

Requirement surfacesEvery(double seconds) {
  Requirement requirement;
  requirement.kind = RequirementKind::SurfacesEvery;
  requirement.seconds = seconds;
  return requirement;
}

struct Tally {
  size_t bounded = 0;
  size_t near = 0;
  size_t timed = 0;  ///< bounded by a timer
};

/// Flies missions against their bounds.
Tally flyAgainstBounds(uint64_t missions, const std::function<std::string(uint64_t)>& textOf,
                       bool power_cuts = false) {
  Tally tally;
  for (uint64_t seed = 1; seed <= missions; ++seed) {
    const std::string text = textOf(seed);
    const Mission mission = missionOf(text);
    const ProofContext all(mission, slocum());
    const ProofContext proof_context = power_cuts ? all : all.withoutPowerCuts();
    const auto longest = longestSubmersion(proof_context, {}, kLong);
    if (!longest) {
      continue;
    }
    ++tally.bounded;
    support::DiagnosticEngine diagnostics;
    const MissionFacts facts = verify(mission, diagnostics);
    const auto deeper = [&](double seconds, uint64_t flight) {
      return flyAtRandom(proof_context, facts.stack_depth, surfacesEvery(seconds), flight, 2500)
          .has_value();
    };
    for (uint64_t flight = 1; flight <= 6; ++flight) {
      EXPECT_FALSE(deeper(*longest, flight)) << "mission " << seed << " in " << *longest << " s\n"
                                             << text;
    }
    if (submersionsOf(proof_context, {}).timer.valid()) {
      ++tally.timed;
    }
    tally.near += deeper(*longest * 0.4, 1) || deeper(*longest * 0.4, 2) ? 1U : 0U;
  }
  return tally;
}

TEST(Submersion, NoRandomFlightIsLonger) {
  const Tally tally = flyAgainstBounds(1500, [](uint64_t seed) { return randomDives(seed); });
  EXPECT_GT(tally.bounded, 200U);
  EXPECT_GT(tally.near, 50U) << "the bounds are far off";
}

TEST(Submersion, NoRandomFlightWithPowerCutsIsLonger) {
  const Tally tally = flyAgainstBounds(200, [](uint64_t seed) { return randomDives(seed); }, true);
  EXPECT_GT(tally.bounded, 20U);
}

TEST(Submersion, NoRandomFlightOfAMissionWithATimerIsLonger) {
  const Tally tally = flyAgainstBounds(3000, [](uint64_t seed) { return randomDives(seed, true); });
  EXPECT_GT(tally.bounded, 200U);
  EXPECT_GT(tally.near, 50U) << "the bounds are far off";
  EXPECT_GT(tally.timed, 50U);
}

const std::string kDown = "descend (20:length, 0.4:angle)";

std::string diveState(const std::string& name, const std::string& command,
                      const std::string& cases) {
  return "state " + name + " route way begin end profile yo begin entry do " + command +
         " end end " + cases + "\n";
}

/// With an own timer t: the states a and b dive and have these cases, z climbs and returns, y dives
/// for 7000 s and returns.
Mission withTimer(const std::string& always, const std::string& of_a, const std::string& of_b) {
  return missionOf(kDives + "variable t : time mission\ninitial t 0:time\n" + always +
                   diveState("a", kDown, of_a) + diveState("b", kDown, of_b) +
                   diveState("z", "surface ()", "case (ge statetime 2000:time) return ") +
                   diveState("y", kDown, "case (ge statetime 7000:time) return "));
}

std::optional<double> longestWithTimer(const std::string& always, const std::string& of_a,
                                       const std::string& of_b = "") {
  const Mission mission = withTimer(always, of_a, of_b);
  return longestSubmersion(ProofContext(mission, slocum()).withoutPowerCuts(), {}, kLong);
}

/// Less the time that the climb in z takes.
double divesFor(const std::string& always, const std::string& of_a, const std::string& of_b = "") {
  const Mission mission = withTimer(always, of_a, of_b);
  const ProofContext proof_context = ProofContext(mission, slocum()).withoutPowerCuts();
  return longestSubmersion(proof_context, {}, kLong).value_or(0) - climbTimes(proof_context)[2];
}

const std::string kTimer = "(gt (sub missiontime (var t)) 3000:time) do set t missiontime end ";

TEST(Submersion, ATimersCaseIsTriedATickLate) {
  const double gap = slocum().world.tick_gap_s;
  EXPECT_NEAR(divesFor("always case " + kTimer + "call z\n", ""), 3000 + gap, 0.01);
  EXPECT_NEAR(divesFor("", "case " + kTimer + "call z "), 3000 + gap, 0.01);
  // Resumed, b is called again before the case of `always` is tried.
  const std::string call = "case (ge statetime 0:time) call b ";
  const std::string back = "case (ge statetime 0:time) return ";
  EXPECT_NEAR(divesFor("always case " + kTimer + "call z\n", call, back), 3000 + 2 * gap, 0.01);
}

/// L3 and L4: a call by a state keeps its limit, a goto ends it.
TEST(GreatestLimits, AreThoseOfTheWaysThere) {
  const std::string a_goes = "case (ge statetime 9:time) goto b ";
  const std::string b_calls = "case (ge statetime 9:time) call y ";
  const std::string hot = "case (gt (sensor temp) 30:temperature) ";
  const auto limits = [&](const std::string& always, const std::string& of_a,
                          const std::string& of_b) {
    return greatestLimits(withTimer(always, of_a, of_b));
  };
  constexpr size_t kNone = std::numeric_limits<size_t>::max();
  const std::string always = "always " + hot + "call b " + hot + "goto z\n";
  EXPECT_EQ(limits(always, "", ""), (std::vector<size_t>{kNone, 0, 1, 0}));
  EXPECT_EQ(limits(always, "", b_calls + "case (ge statetime 99:time) goto z "),
            (std::vector<size_t>{kNone, 0, kNone, 0}));
  EXPECT_EQ(limits(always, a_goes, b_calls), (std::vector<size_t>{kNone, kNone, 1, kNone}));
}

TEST(Submersion, ATimersCaseMayNotBeTried) {
  const std::string always = "always case " + kTimer + "call ";
  const auto without_surfacing = longestWithTimer(always + "y\n", "");
  EXPECT_FALSE(without_surfacing && *without_surfacing < 7000) << "y keeps it from firing";
  const std::string every_tick = "case (ge resumetime 0:time) ";
  EXPECT_FALSE(longestWithTimer(always + "z\n", every_tick + "do set t missiontime end stay "))
      << "the timer is set again and again";
  EXPECT_FALSE(longestWithTimer("", every_tick + "goto b case " + kTimer + "call z ",
                                every_tick + "goto a case " + kTimer + "call z "))
      << "another case is always first";
  EXPECT_TRUE(longestWithTimer(always + "z\n", every_tick + "goto b ", every_tick + "goto a "))
      << "`always` comes before it";
  EXPECT_FALSE(longestWithTimer("always " + every_tick + "stay case " + kTimer + "call z\n", ""))
      << "a case before it fires on every tick";
}

/// A command to surface, or one that looks like it.
std::string climbOf(random_missions::Random& random) {
  const char* climbs[] = {"ascend (3:length, 0.4:angle) ",
                          "ascend (3:length, 0.4:angle) surface () ",
                          "if (gt (sensor temp) 10:temperature) surface () else surface () end "};
  const auto kind = random.below(10);
  return kind < 3 ? climbs[kind] : "surface () ";
}

/// A state whose profile dives and comes to the surface by itself, more or less; its cases come in
/// any order, and some forget to set what they should.
std::string randomProfile(uint64_t seed) {
  random_missions::Random random(seed);
  const auto maybe = [&](const std::string& text, uint64_t of = 8) {
    return random.below(of) == 0 ? std::string() : text;
  };
  const std::string s = "\"a.profile.s\"";
  const std::string d = "\"a.profile.d\"";
  const std::string r = "\"a.profile.r\"";
  const auto since = [&](const std::string& v) { return "(sub missiontime (var " + v + "))"; };
  const std::string down = fmt::format("descend ({}:length, 0.4:angle) ", 5 + 5 * random.below(3));
  const std::string up = climbOf(random);
  std::vector<std::string> cases = {
      "case (and (var " + s + ") " + maybe("(not (lt (sensor depth) 1:length))", 3) + ") do " +
          maybe("set " + r + " missiontime ") + up + "end stay ",
      "case (and (var " + s + ") (ge " + since(r) + " " + timeOf(random, 60) + ")) do set " + s +
          " false " + maybe("set " + d + " missiontime ") + maybe(down) + "end stay ",
      "case " + maybe("(and (not (var " + s + ")) ", 2) + "(ge " + since(random.below(6) ? d : r) +
          " " + timeOf(random, 50) + ")",
      "case (var " + s + ") do " + maybe(up) + "end stay ",
      "case (ge (sensor depth) 8:length) do " +
          std::string("ascend (3:length, 0.4:angle) end stay "),
      "case (le (sensor depth) 4:length) do " + down + "end stay "};
  // `(and x )` without a second operand is x; a case that begins with `(and (not` is closed.
  for (std::string& text : cases) {
    if (const auto empty = text.find(" )"); empty != std::string::npos) {
      text.erase(empty, 2);
      text.erase(text.find("(and "), 5);
    }
  }
  std::string& surfaces = cases[2];
  surfaces += surfaces.starts_with("case (and (not") ? ") " : " ";
  surfaces +=
      "do set " + s + " true " + maybe("set " + r + " missiontime ") + maybe(up, 20) + "end stay ";
  for (int i = 0; i < 2; ++i) {
    if (random.below(2) == 0) {
      std::swap(cases[random.below(cases.size())], cases[random.below(cases.size())]);
    }
  }
  std::string text =
      kDives + "variable " + s + ": bool profile of a\nvariable " + d +
      ": time profile of a\nvariable " + r + ": time profile of a\n" +
      "state a route way begin end profile yo begin entry do initial " + s + " false initial " + d +
      " missiontime initial " + r + " missiontime " +
      (random.below(4) == 0 ? down : "if (var " + s + ") surface () else " + down + "end ") +
      "end ";
  for (const std::string& one : cases) {
    text += one;
  }
  text += "end ";
  if (random.below(3) == 0) {
    text += "case (gt (sensor temp) 15:temperature) call z case (ge resumetime " +
            timeOf(random, 90) + ") goto a ";
  }
  return text + "\nstate z route way begin end profile yo " +
         profileOf(random, random.below(2) == 0) + "case (ge statetime " + timeOf(random, 40) +
         ") return\n";
}

TEST(Submersion, NoRandomFlightOfAProfileThatSurfacesIsLonger) {
  const Tally tally = flyAgainstBounds(1500, [](uint64_t seed) { return randomProfile(seed); });
  EXPECT_GT(tally.bounded, 100U);
  EXPECT_GT(tally.near, 50U) << "the bounds are far off";
}

/// A profile that dives for 3000 s and climbs, again and again, with more cases first or last.
struct SurfacingProfile {
  static constexpr double kClimb = 1000;

  std::string first = "";
  std::string last = "";
  std::string entry = "if (var \"a.profile.s\") surface () else " + kDown + " end";
  std::string wait = "2000:time";
  std::string surfaces = "do set \"a.profile.s\" true set \"a.profile.r\" missiontime surface () ";
  std::string stays = "case (var \"a.profile.s\") do surface () end stay ";
  std::string route = "";
  std::string state_entry = "";
  std::string done = "";
  std::string initial = "false ";
  std::string own = "";

  [[nodiscard]] Mission mission() const {
    const std::string s = "\"a.profile.s\" ";
    const std::string d = "\"a.profile.d\" ";
    const std::string r = "\"a.profile.r\" ";
    const std::string q = "\"a.profile.q\" ";
    return missionOf(kDives + "variable " + s + ": bool profile of a\nvariable " + q +
                     ": bool profile of a\nvariable " + d + ": time profile of a\nvariable " + r +
                     ": time profile of a\nstate a route way begin " + route + "end " +
                     state_entry + "profile yo " + done + "begin entry do initial " + s + initial +
                     "initial " + q + "false initial " + d + "missiontime initial " + r +
                     "missiontime " + entry + " end " + first + "case (and (var " + s +
                     ") (ge (sub missiontime (var " + r + ")) " + wait + ")) do set " + s +
                     "false set " + d + "missiontime " + kDown + " end stay " +
                     "case (and (not (var " + s + ")) (gt (sub missiontime (var " + d +
                     ")) 3000:time)) " + surfaces + "end stay " + stays + last + "end " + own +
                     "\n" + diveState("z", kDown, "case (ge statetime 0:time) return "));
  }

  [[nodiscard]] double longest() const {
    const Mission m = mission();
    const ProofContext proof_context = ProofContext(m, slocum()).withoutPowerCuts();
    const Valuation values = anyValues(m);
    const TimerGuards guards(proof_context, values, kLong);
    return profileSurfacing(proof_context, guards, {0}, kClimb).longest;
  }

  [[nodiscard]] bool isBounded() const { return std::isfinite(longest()); }
};

TEST(ProfileSurfacing, IsBoundedByItsTimerAndTwoClimbs) {
  // Resumed while it climbs, it may leave that climb at once, and set its timer under water.
  EXPECT_NEAR(SurfacingProfile().longest(),
              3000 + slocum().world.tick_gap_s + 2 * SurfacingProfile::kClimb, 0.1);
}

/// Each way around begins where the last one was at the surface, if the state lasts for that long.
TEST(ProfileSurfacing, EndsTheWayBeforeIfItLastsLongEnough) {
  const auto longest = [](const std::string& stay) {
    const Mission m =
        SurfacingProfile{.own = "case (ge statetime " + stay + ":time) goto a "}.mission();
    return longestSubmersion(ProofContext(m, slocum()).withoutPowerCuts(), {}, kLong);
  };
  EXPECT_TRUE(longest("9000"));
  EXPECT_FALSE(longest("2000"));
}

TEST(ProfileSurfacing, IsNotBoundedWhereItNeedNotSurface) {
  const std::string warm = "(gt (sensor temp) 5:temperature)";
  const std::string q = "(var \"a.profile.q\")";
  const std::string set_d = "set \"a.profile.d\" missiontime ";
  EXPECT_FALSE((SurfacingProfile{.first = "case (and (not (var \"a.profile.s\")) " + warm +
                                          ") do " + kDown + " end stay "}
                    .isBounded()))
      << "a case that stays in the mode comes first";
  EXPECT_TRUE(
      (SurfacingProfile{.last = "case " + warm + " do " + kDown + " end stay "}.isBounded()));
  EXPECT_FALSE(
      (SurfacingProfile{.last = "case " + warm + " do " + set_d + "end stay "}.isBounded()))
      << "the timer is set again and again";
  EXPECT_FALSE(
      (SurfacingProfile{.last = "case (and " + warm + " " + q + ") do " + set_d +
                                "set \"a.profile.q\" false end stay case (and " + warm + " (not " +
                                q + ")) do " + set_d + "set \"a.profile.q\" true end stay "}
           .isBounded()))
      << "it is set by going back and forth between two modes";
  EXPECT_FALSE((SurfacingProfile{.wait = "100:time"}.isBounded()))
      << "it leaves the climb too early";
  EXPECT_FALSE(
      (SurfacingProfile{.last = "case " + warm + " do set \"a.profile.r\" missiontime end stay ",
                        .surfaces = "do set \"a.profile.s\" true surface () "}
           .isBounded()))
      << "the wait may have begun before the climb";
  EXPECT_FALSE((SurfacingProfile{.entry = "if (not (var \"a.profile.s\")) " + kDown + " end",
                                 .stays = "",
                                 .own = "case " + warm + " call z "}
                    .isBounded()))
      << "resumed, it goes on as if it still climbed";
  EXPECT_FALSE((SurfacingProfile{.surfaces = "do set \"a.profile.s\" true set \"a.profile.r\" "
                                             "missiontime if " +
                                             warm + " surface () else surface () end "}
                    .isBounded()))
      << "neither branch runs of an `if` whose condition is unknown";
  EXPECT_FALSE((SurfacingProfile{.initial = "(gt (sensor depth) 5:length) "}.isBounded()))
      << "what it remembers may be unknown";
  EXPECT_FALSE(
      (SurfacingProfile{.stays = "case (var \"a.profile.s\") do " + kDown + " surface () end stay "}
           .isBounded()))
      << "each tick begins a new climb";
  EXPECT_FALSE((SurfacingProfile{.stays = "case (and (var \"a.profile.s\") " + warm +
                                          ") do ascend (4:length, 0.4:angle) surface () end stay "}
                    .isBounded()));
  const std::string set_s = "do set \"a.profile.s\" true end ";
  EXPECT_FALSE((SurfacingProfile{.state_entry = "entry " + set_s}.isBounded()));
  EXPECT_FALSE((SurfacingProfile{.own = "case " + warm + " " + set_s + "call z "}.isBounded()))
      << "another list sets what it remembers";
  EXPECT_FALSE((SurfacingProfile{.last = "case " + warm + " done ", .done = "done \"a.profile.s\" "}
                    .isBounded()));
  EXPECT_FALSE((SurfacingProfile{.route = "entry do " + kDown + " end "}.isBounded()));
  EXPECT_FALSE(
      (SurfacingProfile{.own = "case " + warm + " do " + kDown + " end stay "}.isBounded()));
}

/// The route may command a depth too.
TEST(Submersion, ARouteThatCommandsADepthIsNoClimb) {
  const auto longest = [](const std::string& route) {
    const Mission mission = missionOf(
        kDives + "state a route way " + route +
        "profile yo begin entry do surface () end end case (ge statetime 900:time) goto a\n");
    return longestSubmersion(ProofContext(mission, slocum()).withoutPowerCuts(), {}, kLong);
  };
  EXPECT_TRUE(longest("begin end "));
  EXPECT_FALSE(longest("begin entry do descend (9:length, 0.4:angle) end end "));
  EXPECT_FALSE(
      longest("begin case (gt (sensor temp) 9:temperature) do descend (9:length, 0.4:angle) "
              "end stay end "));
}

/// Of all states: the greatest bound that is proved about each clock and of the depth holds in
/// flight.
TEST(AnyMomentOf, WhatIsProvedHoldsInRandomFlights) {
  size_t proved = 0;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    std::string text = randomDives(seed);
    const char* conditions[] = {"(le (sensor depth) 25:length)",
                                "(le resumetime 1500:time)",
                                "(le statetime 1500:time)",
                                "(or (le (sensor depth) 15:length) (ge missiontime 400:time))",
                                "(ge (sub missiontime statetime) 0:time)",
                                "(or (le (age depth) 60:time) (lt (sensor depth) 0:length))",
                                "(ge statetime resumetime)"};
    std::string promises;
    for (const char* condition : conditions) {
      promises += std::string("require always ") + condition + "\n";
    }
    const size_t at = std::min(text.find("always case"), text.find("state a"));
    text.insert(at, promises);
    const Mission mission = missionOf(text);
    const ProofContext proof_context(mission, slocum());
    const std::vector<StateBounds> bounds = stateBounds(proof_context, {});
    AnyMoment moment(proof_context, bounds);
    support::DiagnosticEngine diagnostics;
    const MissionFacts facts = verify(mission, diagnostics);
    std::vector<Requirement> kept;
    Budget budget(100000000);
    for (const Requirement& requirement : mission.requirements) {
      if (moment.neverFalse(requirement.condition, 400000, budget)) {
        kept.push_back(requirement);
      }
    }
    proved += kept.size();
    for (uint64_t flight = 1; flight <= 5 && !kept.empty(); ++flight) {
      const auto run = flyAtRandom(proof_context, facts.stack_depth, kept, flight, 1500);
      EXPECT_FALSE(run.has_value()) << "mission " << seed << " at " << (run ? run->when : 0) << "\n"
                                    << text;
    }
  }
  EXPECT_GT(proved, 150U);
}

TEST(Budget, IsSharedAndEnds) {
  Budget budget(1000);
  EXPECT_EQ(budget.allow(700), 700U);
  budget.spend(600);
  EXPECT_EQ(budget.allow(700), 400U);
  budget.spend(600);
  EXPECT_EQ(budget.allow(700), 0U);
  EXPECT_TRUE(budget.isUsedUp());
  EXPECT_FALSE(budget.isOver()) << "it has no time limit";
  EXPECT_FALSE(budget.milliseconds().has_value());
  const Budget late(1000, Budget::Clock::now());
  EXPECT_TRUE(late.isUsedUp());
  EXPECT_TRUE(late.isOver());
  EXPECT_EQ(late.milliseconds(), 1U);
}

}  // namespace
}  // namespace glider::ir::prove
