// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// By when a mission has ended: computed, and never exceeded by a flight.

#include "ir/prove/abstract/end_bound.h"

#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/falsification/random_flight.h"
#include "ir/prove/prove.h"
#include "ir/verify/verify.h"
#include "tests/random_missions/random.h"
#include "tests/unit/ir/missions.h"
#include "tests/unit/ir/slocum.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>

namespace glider::ir::prove {
namespace {

constexpr double kForever = 1e7;

/// In gaps between ticks beyond `seconds`; NaN: no bound is found. The power is never cut.
double gapsBeyond(double seconds, const std::string& text, double latest = kForever) {
  const Mission mission = missionOf(kHeader + text);
  const ProofContext proof_context = ProofContext(mission, slocum()).withoutPowerCuts();
  const auto end = boundOf(proof_context, latest, Goal::Exit).by;
  return end ? (*end - seconds) / slocum().world.tick_gap_s
             : std::numeric_limits<double>::quiet_NaN();
}

TEST(EndBound, IsOneGapAfterAGuardOnClocksMustBeTrue) {
  EXPECT_EQ(gapsBeyond(500, stateText("a", "case (ge missiontime 500:time) exit")), 1);
  EXPECT_EQ(gapsBeyond(500, stateText("a", "case (ge statetime 500:time) exit")), 1);
  EXPECT_NEAR(gapsBeyond(500, stateText("a", "case (gt statetime 500:time) exit")), 1, 1e-9);
  EXPECT_EQ(gapsBeyond(0, stateText("a", "case true exit")), 1);
  EXPECT_EQ(gapsBeyond(100, stateText("a",
                                      "case (or (gt (sensor depth) 5:length) (ge statetime "
                                      "100:time)) exit")),
            1);
}

TEST(EndBound, AConditionThatHoldsAtFirstEndsItAtOnce) {
  EXPECT_EQ(gapsBeyond(0, stateText("a", "case (lt missiontime 500:time) exit")), 1);
  EXPECT_EQ(gapsBeyond(0, stateText("a", "case (not (ge missiontime 500:time)) exit")), 1);
  EXPECT_EQ(gapsBeyond(300, stateText("a", "case (ge statetime 300:time) goto b") +
                                stateText("b", "case (lt resumetime 30:time) exit")),
            2);
  const double late = gapsBeyond(0, stateText("a", "case (ge statetime 300:time) goto b") +
                                        stateText("b", "case (lt missiontime 310:time) exit"));
  EXPECT_TRUE(late != late) << "the first tick may come after that";
  const double waits = gapsBeyond(0, stateText("a", "case (lt missiontime 2:time) exit"));
  EXPECT_TRUE(waits != waits);
}

TEST(EndBound, IsNoneIfASensorMayKeepTheState) {
  const double none = gapsBeyond(0, stateText("a", "case (gt (sensor depth) 5:length) exit"));
  EXPECT_TRUE(none != none);
  const double kept = gapsBeyond(0, stateText("a",
                                              "case (gt (sensor depth) 5:length) stay "
                                              "case (ge statetime 100:time) exit"));
  EXPECT_TRUE(kept != kept);
  const double unknown =
      gapsBeyond(0, stateText("a",
                              "case (and (ge statetime 100:time) (or (gt (sensor depth) 5:length) "
                              "(le (sensor depth) 5:length))) exit"));
  EXPECT_TRUE(unknown != unknown) << "the depth may be unknown";
}

TEST(EndBound, AddsUpTheStatesOfEveryWay) {
  EXPECT_EQ(gapsBeyond(700, stateText("a",
                                      "case (gt (sensor depth) 5:length) goto b "
                                      "case (ge statetime 300:time) goto c") +
                                stateText("b", "case (ge statetime 400:time) exit") +
                                stateText("c", "case (ge statetime 50:time) exit")),
            2);
  EXPECT_EQ(gapsBeyond(400, stateText("a",
                                      "case (ge missiontime 300:time) exit "
                                      "case (gt (sensor depth) 5:length) call b") +
                                stateText("b", "case (ge statetime 100:time) return")),
            2)
      << "called just before 300 s";
  const double loop = gapsBeyond(0, stateText("a", "case (ge statetime 300:time) goto b") +
                                        stateText("b", "case (ge statetime 300:time) goto a"));
  EXPECT_TRUE(loop != loop);
}

TEST(EndBound, CountsWhatVariablesCount) {
  const std::string legs = "variable n: number mission lowest 0 highest 10 initial n 0 " +
                           stateText("a",
                                     "case (lt statetime 100:time) stay "
                                     "case (lt (var n) 3) do set n (add (var n) 1) end goto a "
                                     "case true exit");
  EXPECT_EQ(gapsBeyond(400, legs), 4);
  const double never =
      gapsBeyond(0, "variable n: number mission lowest 0 highest 10 initial n 0 " +
                        stateText("a",
                                  "case (lt statetime 100:time) stay "
                                  "case (lt (var n) 3) do set n (var n) end goto a "
                                  "case true exit"));
  EXPECT_TRUE(never != never);
}

TEST(EndBound, AResumedStateKeepsItsVariables) {
  EXPECT_EQ(gapsBeyond(600, "variable n: number state of a lowest 0 highest 10 initial n 0 " +
                                stateText("a",
                                          "case (lt (var n) 3) do set n (add (var n) 1) end call b "
                                          "case true exit") +
                                stateText("b", "case (ge statetime 200:time) return")),
            7)
      << "three calls and the end";
}

TEST(EndBound, InterruptionsAreOnTheWay) {
  EXPECT_EQ(gapsBeyond(600, "always case (gt (sensor depth) 5:length) goto b " +
                                stateText("a", "case (ge statetime 500:time) exit") +
                                stateText("b", "case (ge statetime 100:time) exit")),
            2);
}

const std::string kAvoid = "always case (gt (sensor depth) 5:length) call b ";
const std::string kAvoiding = stateText("b", "case (ge statetime 900:time) return");

/// It may begin until the mission ends; after that the state that it returns to ends it at once.
TEST(EndBound, AnAvoidanceMayRepeatUntilTheEnd) {
  EXPECT_EQ(
      gapsBeyond(8100, kAvoid + stateText("a", "case (ge missiontime 7200:time) exit") + kAvoiding),
      3)
      << "called a gap after the end's time, and each lasts a gap longer";
  EXPECT_NEAR(
      gapsBeyond(8100, kAvoid + stateText("a", "case (gt missiontime 7200:time) exit") + kAvoiding),
      3, 1e-9);
}

TEST(EndBound, AnAvoidanceMayRepeatForEverIfTheEndIsNotAtOnce) {
  for (const char* end :
       {"(ge resumetime 30:time)", "(and (ge missiontime 7200:time) (gt (sensor depth) 1:length))",
        "(ge resumetime 20.5:time)"}) {
    const double none =
        gapsBeyond(0, kAvoid + stateText("a", std::string("case ") + end + " exit") + kAvoiding);
    EXPECT_TRUE(none != none) << end;
  }
  const double first =
      gapsBeyond(0, kAvoid + stateText("a", "case (ge missiontime 7200:time) exit") +
                        stateText("b", "case (ge statetime 900:time) goto a"));
  EXPECT_TRUE(first != first) << "after a goto `always` comes first";
  const double stays = gapsBeyond(0, kAvoid +
                                         stateText("a",
                                                   "case (gt (sensor depth) 1:length) stay "
                                                   "case (ge missiontime 7200:time) exit") +
                                         kAvoiding);
  EXPECT_TRUE(stays != stays) << "a case before it may keep the state";
}

/// What ends a late stay at once does not end an early one.
TEST(EndBound, EarlyAndLateArrivalsAreApart) {
  EXPECT_EQ(gapsBeyond(1500, stateText("a",
                                       "case (ge missiontime 1000:time) goto b "
                                       "case (gt (sensor depth) 5:length) goto b") +
                                 stateText("b",
                                           "case (ge statetime 500:time) exit "
                                           "case (lt missiontime 900:time) goto a")),
            2);
  const double early = gapsBeyond(0, stateText("a",
                                               "case (ge statetime 1000:time) goto b "
                                               "case (gt (sensor depth) 5:length) goto b") +
                                         stateText("b",
                                                   "case (ge missiontime 1000:time) exit "
                                                   "case (lt missiontime 900:time) goto b"));
  EXPECT_EQ(early, 52) << "1020 s and a gap more";
}

/// A mission whose states mostly lead on, and back as often as a counter allows.
std::string randomWays(uint64_t seed) {
  random_missions::Random random(seed);
  const auto states = 1 + random.below(4);
  const auto name = [](uint64_t i) { return std::string(1, static_cast<char>('a' + i)); };
  std::string text = "variable n: number mission lowest 0 highest 10 initial n 0 ";
  const auto always = random.below(6);
  if (always == 0) {
    text += "always case (ge missiontime 900:time) exit ";
  } else if (always < 3) {
    text += "always case (gt (sensor depth) 90:length) goto " + name(states) + " ";
  } else if (always < 5) {
    text += "always case (gt (sensor depth) 10:length) call z ";
  }
  for (uint64_t i = 0; i <= states; ++i) {
    const std::string time = std::to_string(10 * random.below(40));
    const std::string on = i == states ? "exit" : "goto " + name(i + 1 + random.below(states - i));
    std::string cases;
    if (random.below(3) == 0) {
      cases += "case (and (lt statetime " + time + ":time) (gt (sensor temp) 3:temperature)) stay ";
    }
    if (random.below(2) == 0) {
      cases += "case (and (lt (var n) " + std::to_string(random.below(4)) +
               ") (gt (sensor depth) 20:length)) do set n (add (var n) 1) end goto " +
               name(random.below(states + 1)) + " ";
    }
    if (random.below(3) == 0) {
      cases += "case (gt missiontime " + std::to_string(100 * random.below(20)) + ":time) exit ";
    }
    text += stateText(name(i), cases + "case (ge " +
                                   (random.below(2) == 0 ? "statetime " : "resumetime ") + time +
                                   ":time) " + on);
  }
  text += stateText("z", "case (gt (sensor temp) 20:temperature) return case (ge statetime " +
                             std::to_string(10 * random.below(40)) + ":time) return");
  return kHeader + text;
}

TEST(EndBound, AlwaysMayEndIt) {
  EXPECT_EQ(gapsBeyond(500, "always case (ge missiontime 500:time) exit " +
                                stateText("a", "case (gt (sensor depth) 5:length) goto a")),
            1);
  const double loop = gapsBeyond(0, "always case (ge missiontime 500:time) goto a " +
                                        stateText("a", "case (gt (sensor depth) 5:length) exit"));
  EXPECT_TRUE(loop != loop) << "it does not interrupt its own target";
}

TEST(EndBound, NoRandomFlightIsLonger) {
  size_t bounded = 0;
  double closest = 0;
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    const Mission mission = missionOf(randomWays(seed));
    const ProofContext proof_context = ProofContext(mission, slocum()).withoutPowerCuts();
    const auto end = boundOf(proof_context, kForever, Goal::Exit).by;
    if (!end) {
      continue;
    }
    ++bounded;
    support::DiagnosticEngine diagnostics;
    const MissionFacts facts = verify(mission, diagnostics);
    Requirement requirement;
    requirement.kind = RequirementKind::ExitWithin;
    requirement.seconds = *end;
    const auto longer = [&](uint64_t flight) {
      return flyAtRandom(proof_context, facts.stack_depth, requirement, flight, 1000).has_value();
    };
    for (uint64_t flight = 1; flight <= 5; ++flight) {
      EXPECT_FALSE(longer(flight)) << "mission " << seed << " by " << *end << " s";
    }
    requirement.seconds = *end * 0.7;
    closest += longer(1) || longer(2) || longer(3) ? 1 : 0;
  }
  EXPECT_GT(bounded, 100U) << "the random missions have no ends";
  EXPECT_GT(closest, 30) << "the bounds are far off";
}

TEST(Ending, OneSearchFindsWhatASearchUpToEachTimeFinds) {
  size_t bounded = 0;
  size_t open = 0;
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    const Mission mission = missionOf(randomWays(seed));
    const ProofContext proof_context = ProofContext(mission, slocum()).withoutPowerCuts();
    Ending ending(proof_context);
    for (const double latest :
         {60.0, 250.0, 600.0, 1000.0, 2500.0, kForever, 2 * kLongestMission}) {
      const auto end = boundOf(proof_context, latest, Goal::Exit).by;
      EXPECT_EQ(ending.by(latest), end) << "mission " << seed << " up to " << latest << " s";
      ++(end ? bounded : open);
    }
  }
  EXPECT_GT(bounded, 100U);
  EXPECT_GT(open, 100U);
}

TEST(Ending, MayBeBeyondAYear) {
  const Mission mission = missionOf(kHeader + stateText("a", "case (ge statetime 4e7:time) exit"));
  const ProofContext proof_context(mission, slocum());
  Ending ending(proof_context);
  EXPECT_FALSE(ending.bound().by);
  EXPECT_FALSE(ending.by(3.9e7));
  EXPECT_EQ(ending.by(5e7), 4e7 + kResumeWithin_s) << "the power may be cut just before";
}

TEST(EndBound, IsNeverRoundedDown) {
  for (int i = 1; i < 100; ++i) {
    const double stay = i / 10.0;
    const Mission mission = missionOf(
        kHeader + stateText("a", "case (ge statetime " + fmt::format("{}", stay) + ":time) exit"));
    const ProofContext proof_context = ProofContext(mission, slocum()).withoutPowerCuts();
    const auto end = boundOf(proof_context, kForever, Goal::Exit).by;
    ASSERT_TRUE(end);
    EXPECT_GE(static_cast<long double>(*end),
              static_cast<long double>(stay) + static_cast<long double>(proof_context.tick_gap_s));
  }
}

TEST(EndBound, PowerCutsComeOnTop) {
  const auto bound = [](const std::string& text) {
    const Mission mission = missionOf(kHeader + text);
    return boundOf(ProofContext(mission, slocum()), kForever, Goal::Exit).by;
  };
  const std::string plain = stateText("a", "case (ge missiontime 500:time) exit");
  EXPECT_EQ(bound(plain), 500 + kResumeWithin_s);
  EXPECT_EQ(bound("resume within 36000\n" + plain), 36500);
  EXPECT_EQ(bound("resume within 1\n" + plain), 500 + slocum().world.tick_gap_s);
  EXPECT_FALSE(bound(stateText("a", "case (ge statetime 300:time) goto b") +
                     stateText("b", "case (lt resumetime 30:time) exit")))
      << "the first tick may come later";
}

TEST(EndBound, NoRandomFlightWithPowerCutsIsLonger) {
  size_t bounded = 0;
  for (uint64_t seed = 1; seed <= 150; ++seed) {
    const Mission mission = missionOf(randomWays(seed));
    const ProofContext proof_context(mission, slocum());
    const auto end = boundOf(proof_context, kForever, Goal::Exit).by;
    if (!end) {
      continue;
    }
    ++bounded;
    support::DiagnosticEngine diagnostics;
    const MissionFacts facts = verify(mission, diagnostics);
    Requirement requirement;
    requirement.kind = RequirementKind::ExitWithin;
    requirement.seconds = *end;
    for (uint64_t flight = 1; flight <= 10; ++flight) {
      EXPECT_FALSE(
          flyAtRandom(proof_context, facts.stack_depth, requirement, flight, 1000).has_value())
          << "mission " << seed << " by " << *end << " s";
    }
  }
  EXPECT_GT(bounded, 40U);
}

/// Otherwise its counterexample could not be replayed.
TEST(RandomFlight, TicksAtTimesThatTheVehiclesClockCanShow) {
  const Mission mission =
      missionOf(kHeader + stateText("a", "case (ge missiontime 20000:time) exit"));
  const ProofContext proof_context(mission, slocum());
  Requirement requirement;
  requirement.kind = RequirementKind::ExitWithin;
  requirement.seconds = 3000;
  size_t power_cuts = 0;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const auto run = flyAtRandom(proof_context, 0, requirement, seed, 1000);
    ASSERT_TRUE(run);
    for (const ConcreteTick& tick : run->ticks) {
      EXPECT_EQ(std::fmod(tick.mission_time, 1.0 / 64), 0) << "seed " << seed;
      power_cuts += std::fmod(tick.mission_time, 4) != 0 ? 1U : 0U;
    }
  }
  EXPECT_GT(power_cuts, 0U);
}

TEST(EndBound, AnUnknownConditionTakesNeitherBranch) {
  const auto text = [](const std::string& condition) {
    return "variable limit: time mission lowest 0 highest 72000 initial limit 36000:time "
           "state a route drift () profile glide () entry do if " +
           condition +
           " set limit 600:time else set limit 1200:time end end "
           "case (ge statetime (var limit)) exit\n";
  };
  EXPECT_EQ(gapsBeyond(36000, text("(gt (sensor temp) 10:temperature)")), 1);
  EXPECT_EQ(gapsBeyond(1200, text("(and (known (sensor temp)) (gt (sensor temp) 10:temperature))")),
            1)
      << "this is never unknown";
  EXPECT_EQ(gapsBeyond(1200, text("(known (sensor depth)) set limit 900:time "
                                  "if (gt (sensor temp) 10:temperature) set limit 5:time end")),
            1)
      << "an if in an if";
}

/// With a profile that dives to 20 m.
std::string withRoute(const std::string& route) {
  return kHeader + "behaviour profile down symbol \"\" () reads ()\n" +
         "behaviour route way symbol \"\" () reads ()\n" +
         "require always (le (sensor depth) 30:length)\n" + "state a route " + route +
         " profile down begin entry do descend (20:length, 0.4:angle) end end "
         "case (ge missiontime 500:time) exit\n";
}

TEST(StateDepths, WhatIsInCMayCommandAnyDepth) {
  const auto deepest = [](const std::string& text) {
    const Mission mission = missionOf(text);
    return deepestByState(ProofContext(mission, slocum())).at(0);
  };
  EXPECT_EQ(deepest(withRoute("way begin entry do drift () end end")), 25);
  EXPECT_TRUE(std::isinf(deepest(withRoute("drift ()"))));
  EXPECT_TRUE(std::isinf(deepest(kHeader + "behaviour route way symbol \"\" () reads ()\n" +
                                 "state a route way begin entry do drift () end end "
                                 "profile glide () case true exit\n")));
}

TEST(StateDepths, KnowWhereVariablesAreEverSetTo) {
  const auto deepest = [](const std::string& set) {
    const Mission mission = missionOf(
        kHeader + "behaviour profile down symbol \"\" () reads ()\n" +
        "behaviour route way symbol \"\" () reads ()\n" +
        "variable d: length mission\ninitial d 5:length\n" +
        "state a route way begin end profile down begin entry do descend ((var d), 0.4:angle) end "
        "end case (gt (sensor depth) 1:length) do set d " +
        set + " end goto a case (ge missiontime 500:time) exit\n");
    return deepestByState(ProofContext(mission, slocum())).at(0);
  };
  EXPECT_EQ(deepest("(clamp (sensor depth) 5:length 28:length)"), 33);
  EXPECT_EQ(deepest("(min (add (var d) 1:length) 7.5:length)"), 12.5);
  EXPECT_TRUE(std::isinf(deepest("(add (var d) 1:length)")));
}

Verdict verdictOf(const std::string& text) {
  const Mission mission = missionOf(text);
  support::DiagnosticEngine diagnostics;
  const MissionFacts facts = verify(mission, diagnostics);
  return prove(mission, facts, slocum(), {}, diagnostics).requirements.at(0).verdict;
}

TEST(Requirements, ARouteInCMayBreakADepth) {
  EXPECT_EQ(verdictOf(withRoute("way begin entry do drift () end end")), Verdict::Proved);
  EXPECT_EQ(verdictOf(withRoute("drift ()")), Verdict::Refuted);
}

const std::string kShallow =
    "require always (le (sensor depth) 30:length)\n"
    "behaviour profile down symbol \"\" () reads ()\n"
    "behaviour route way symbol \"\" () reads ()\n";
const std::string kQuietRoute = "route way begin end ";
const std::string kTo20m = kQuietRoute +
                           "profile down begin entry do descend (20:length, 0.4:angle) end end "
                           "case (ge missiontime 500:time) ";

/// The guard leads to a dive that breaks the requirement.
TEST(Requirements, AReadingOfTheDepthIsOffByTheDepthErrorAtMost) {
  // A reading below the sensor's range is unknown: the range must not hide the error.
  std::string header = kHeader;
  header.replace(header.find("lowest -1"), 9, "lowest -9");
  const auto diveIf = [&](const std::string& guard) {
    return verdictOf(header + kShallow + "state a " + kTo20m + "exit case (" + guard +
                     ") goto b\nstate b " + kQuietRoute +
                     "profile down begin entry do descend (40:length, 0.4:angle) end end "
                     "case (ge missiontime 900:time) exit\n");
  };
  EXPECT_EQ(diveIf("lt (sensor depth) -1.0:length"), Verdict::Proved);
  EXPECT_NE(diveIf("lt (sensor depth) -0.8:length"), Verdict::Proved);
  EXPECT_EQ(diveIf("gt (sensor depth) 26.0:length"), Verdict::Proved);
  EXPECT_NE(diveIf("gt (sensor depth) 25.8:length"), Verdict::Proved);
}

/// From 25 m the vehicle gets below 30 m by the next tick.
void expectThatItsCommandsCount(const std::function<Verdict(const std::string&)>& verdict) {
  const std::string deeper = "begin entry do descend (40:length, 0.4:angle) end end ";
  EXPECT_EQ(verdict(kQuietRoute + "profile down begin end "), Verdict::Proved);
  EXPECT_NE(verdict(kQuietRoute + "profile down " + deeper), Verdict::Proved);
  EXPECT_NE(verdict("route way " + deeper + "profile down begin end "), Verdict::Proved);
  EXPECT_NE(verdict(kQuietRoute + "profile glide () "), Verdict::Proved) << "in C";
  EXPECT_NE(verdict("route drift () profile down begin end "), Verdict::Proved) << "in C";
}

TEST(Requirements, WhatAStateCommandsAsItIsEnteredCounts) {
  expectThatItsCommandsCount([](const std::string& b) {
    return verdictOf(kHeader + kShallow + "state a " + kTo20m + "goto b\nstate b " + b +
                     "case true exit\n");
  });
}

TEST(Requirements, WhatAStateCommandsAsItIsResumedCounts) {
  expectThatItsCommandsCount([](const std::string& a) {
    return verdictOf(kHeader + kShallow +
                     "resume within 20\nvariable back: bool mission\ninitial back false\n" +
                     "state a " + a + "case (var back) exit " +
                     "case true do set back true end call b\nstate b " + kTo20m + "return\n");
  });
}

TEST(EndBound, ARouteThatCommandsADepthIsNotAClimb) {
  const auto home = [](const std::string& route) {
    const Mission mission = missionOf(kHeader + "behaviour profile up symbol \"\" () reads ()\n" +
                                      "behaviour route way symbol \"\" () reads ()\n" +
                                      "state a route way begin entry do " + route +
                                      " end end profile up begin entry do surface () end end case "
                                      "(ge missiontime 500:time) exit\n");
    const ProofContext proof_context = ProofContext(mission, slocum()).withoutPowerCuts();
    return *boundOf(proof_context, kForever, Goal::ExitOrSurface).by;
  };
  EXPECT_EQ(home("drift ()"), 0);
  EXPECT_EQ(home("descend (30:length, 0.4:angle)"), 520);
}

}  // namespace
}  // namespace glider::ir::prove
