// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What GL3115, GL3116 and GL3118 call impossible happens in no random flight.

#include "ir/prove/context/proof_context.h"
#include "ir/prove/falsification/random_flight.h"
#include "ir/prove/prove.h"
#include "ir/verify/verify.h"
#include "support/diagnostics/ids/verification.h"
#include "tests/random_missions/random.h"
#include "tests/unit/ir/missions.h"
#include "tests/unit/ir/slocum.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace glider::ir::prove {
namespace {

using random_missions::Random;
using support::DiagnosticId;

const std::string kStart = kHeader +
                           "behaviour profile yo symbol \"\" () reads ()\n"
                           "behaviour route way symbol \"\" () reads ()\n";

std::string profileOf(Random& random, uint32_t depth) {
  const std::string down = fmt::format("descend ({}:length, 0.4:angle)", depth);
  const std::string up = "ascend (3:length, 0.4:angle)";
  switch (random.below(4)) {
    case 0:
      return "begin entry do " + down + " end end ";
    case 1:
      return fmt::format("begin entry do hover ({}:length) end end ", depth);
    case 2:
      return fmt::format(
          "begin entry do {0} end case (ge (sensor depth) {1}:length) do {2} end stay case (le "
          "(sensor depth) 3:length) do {0} end stay end ",
          down, depth, up);
    default:
      return "begin entry do if (gt (sensor temp) 10:temperature) surface () else " + down +
             " end end end ";
  }
}

/// The condition of the case that leads to `hit`, with what it watches.
std::string hitOf(Random& random, const std::string& state, uint32_t deepest) {
  const double depth = deepest + 4 + 0.2 * random.below(14);
  const uint32_t time = 20 * (1 + random.below(60));
  const std::string deep = fmt::format("(gt (sensor depth) {}:length)", depth);
  switch (random.below(6)) {
    case 0:
      return fmt::format("temporal held state {} {} for 8:time case (temporal 0)", state, deep);
    case 1:
      return fmt::format(
          "temporal held state {} (gt (sensor temp) 5:temperature) for {}:time case (temporal 0)",
          state, time);
    case 2:
      return fmt::format("temporal mean state {} (sensor temp) over {} case (known (temporal 0))",
                         state, time);
    case 3:
      return fmt::format(
          "temporal highest state {} (sensor depth) over 20 case (gt (temporal 0) {}:length)",
          state, depth);
    default:
      return "case " + deep;
  }
}

/// A ring of states, each left by a clock; one of them also leads to `hit`. Some call another, and
/// `always` may.
std::string randomMission(uint64_t seed) {
  Random random(seed);
  const uint32_t states = 2 + random.below(2);
  const uint32_t with_hit = random.below(states);
  uint32_t deepest = 0;
  std::string text = kStart;
  const bool interrupted = random.below(4) == 0;
  if (interrupted) {
    text += "always case (gt (sensor temp) 30:temperature) call z\n";
  }
  for (uint32_t i = 0; i < states; ++i) {
    const std::string name(1, static_cast<char>('a' + i));
    const uint32_t depth = 5 + 5 * random.below(4);
    deepest = std::max(deepest, depth);
    text += "state " + name + " route way begin end profile yo " + profileOf(random, depth);
    if (i == with_hit) {
      text += hitOf(random, name, random.below(3) == 0 ? depth : deepest) + " goto hit ";
    }
    if (random.below(4) == 0) {
      text += "case (lt (sensor temp) 0:temperature) call z ";
    }
    const char* clock = random.below(2) == 0 ? "statetime" : "resumetime";
    const char next =
        random.below(3) == 0 && i > 0 ? 'a' : static_cast<char>('a' + (i + 1) % states);
    text += fmt::format("case (ge {} {}:time) goto {}\n", clock, 20 * (1 + random.below(40)), next);
  }
  return text + "state z route way begin end profile yo " +
         profileOf(random, 5 + 5 * random.below(5)) +
         "case (ge statetime 100:time) return\n"
         "state hit route way begin end profile yo begin entry do surface () end end "
         "case (ge statetime 60:time) exit\n";
}

/// Whether one of these is reported.
bool reports(const Mission& mission, const MissionFacts& facts,
             std::initializer_list<DiagnosticId> ids) {
  support::DiagnosticEngine diagnostics;
  (void)prove(mission, facts, slocum(), {}, diagnostics);
  return std::ranges::any_of(diagnostics.sorted(), [&](const support::Diagnostic& one) {
    return std::ranges::find(ids, one.id) != ids.end();
  });
}

TEST(StateFaults, WhatIsNeverTrueFiresInNoRandomFlight) {
  size_t reported = 0;
  size_t fired = 0;
  for (uint64_t seed = 1; seed <= 1200; ++seed) {
    const std::string text = randomMission(seed);
    const Mission mission = missionOf(text);
    support::DiagnosticEngine diagnostics;
    const MissionFacts facts = verify(mission, diagnostics);
    ASSERT_FALSE(diagnostics.hasErrors()) << text;
    const bool never =
        reports(mission, facts,
                {support::diagnostics::neverTrueInState, support::diagnostics::longerThanState});
    Requirement reach;
    reach.kind = RequirementKind::Reach;
    const auto is_hit = [](const State& state) { return state.name == "hit"; };
    reach.state = {static_cast<uint32_t>(std::ranges::find_if(mission.states, is_hit) -
                                         mission.states.begin())};
    const ProofContext proof_context(mission, slocum());
    bool any = false;
    for (uint64_t flight = 1; flight <= 4 && !any; ++flight) {
      any = flyAtRandom(proof_context, facts.stack_depth, reach, flight, 1500).has_value();
    }
    EXPECT_FALSE(never && any) << "mission " << seed << "\n" << text;
    reported += never ? 1 : 0;
    fired += any ? 1 : 0;
  }
  EXPECT_GT(reported, 200U);
  EXPECT_GT(fired, 200U) << "the flights show nothing";
}

/// A mission without any reading for months has not ended.
TEST(StateFaults, AMissionThatNeedsReadingsDoesNotEndWithoutThem) {
  size_t reported = 0;
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const auto guard = [&] {
      const char* guards[] = {"(gt (sensor temp) 5:temperature)",
                              "(ge statetime 600:time)",
                              "(not (known (sensor depth)))",
                              "(and (ge missiontime 900:time) (lt (sensor depth) 5:length))",
                              "(or (gt (sensor temp) 9:temperature) (ge resumetime 90:time))",
                              "(ge (age temp) 100:time)"};
      return std::string(guards[random.below(std::size(guards))]);
    };
    std::string text = kStart;
    if (random.below(4) == 0) {
      text += "always case " + guard() + " exit\n";
    }
    for (const char* name : {"a", "b", "c"}) {
      const char* to[] = {"exit", "goto a", "goto b", "goto c"};
      text += fmt::format("state {} route way begin end profile yo {} case {} {} case {} goto {}\n",
                          name, profileOf(random, 10), guard(), to[random.below(4)], guard(),
                          "abc"[random.below(3)]);
    }
    const Mission mission = missionOf(text);
    support::DiagnosticEngine diagnostics;
    const MissionFacts facts = verify(mission, diagnostics);
    if (diagnostics.hasErrors() ||
        !reports(mission, facts, {support::diagnostics::endNeedsReadings})) {
      continue;
    }
    ++reported;
    Interpreter interpreter(mission, facts.stack_depth);
    TickResult result = interpreter.start();
    for (double time = 4; time < 20000; time += 4) {
      result = interpreter.tick(time, {});
    }
    EXPECT_FALSE(result.finished) << text;
  }
  EXPECT_GT(reported, 20U);
}

}  // namespace
}  // namespace glider::ir::prove
