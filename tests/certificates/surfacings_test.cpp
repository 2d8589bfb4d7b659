// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The time under water that is proved about random profiles that come to the surface by themselves,
// more or less, and of missions with a timer: the second check accepts it.

#include "tests/certificates/issued.h"
#include "tests/random_missions/random.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace glider::tests {
namespace {

using random_missions::Random;

std::string surfaceIn(Random& random) {
  const char* ways[] = {"surface()",
                        "if depth > 5 m then surface() else surface() end",
                        "descend(20 m, 26 deg) surface()",
                        "if known(depth) then ascend(4 m, 26 deg) end surface()",
                        "if depth > 5 m then surface() end",
                        "ascend(2 m, 26 deg)"};
  return random.below(3) == 0 ? random.pick(ways) : ways[0];
}

/// With its cases in any order, some of which forget to set what they should.
std::string profileText(Random& random) {
  const auto maybe = [&](const std::string& text) { return random.below(7) == 0 ? "" : text; };
  const std::string dive =
      random.below(4) == 0 ? "descend(min(30 m, altitude), 26 deg) " : "descend(30 m, 26 deg) ";
  std::string cases[] = {
      "case up && missiontime - arrived >= 20 min do set up = false " +
          maybe("set dived = missiontime ") + maybe(dive) + "end stay\n",
      "case up do " + maybe(surfaceIn(random)) + " end stay\n",
      "case " + maybe("!up && ") + "missiontime - dived >= 2 h do set up = true " +
          maybe("set arrived = missiontime ") + surfaceIn(random) + " end stay\n",
      "case depth >= 30 m do ascend(4 m, 26 deg) end stay\n",
      "case depth <= 4 m do " + dive + "end stay\n"};
  for (int i = 0; i < 2; ++i) {
    std::swap(cases[random.below(3)], cases[random.below(random.below(3) == 0 ? 5 : 3)]);
  }
  std::string text = fmt::format(
      "flightprofile p\nbegin\n  var up: bool = {}\n  var dived: time = missiontime\n"
      "  var arrived: time = missiontime\n  entry do {} if up then {} else {} end end\n  events\n",
      random.below(6) == 0 ? "temp > 5 degC" : "false",
      random.below(3) == 0 ? "set arrived = missiontime" : "", surfaceIn(random), dive);
  for (const std::string& one : cases) {
    text += "    " + one;
  }
  return text + "end\n";
}

std::string missionText(Random& random) {
  const bool timed = random.below(2) == 0;
  const std::string call = random.below(3) == 0 ? "goto b" : "call b";
  return fmt::format(
      "mission m\nvar talked: time = 0 s\nrequire surfaces every 9 h\n{}{}"
      "state a\nbegin\n  flightroute heading(90 deg)\n  flightprofile p\n"
      "  sensors missiontime, depth, temp, altitude\n  events\n"
      "    case missiontime >= 30 h exit\n{}end\n"
      "state b\nbegin\n  flightroute heading(90 deg)\n  flightprofile surfaced\n"
      "  sensors missiontime, depth\n  events\n    case statetime >= {} min {}\nend\n",
      profileText(random),
      timed ? "always\n  case missiontime - talked > 3 h do set talked = missiontime end " + call +
                  "\n"
            : "",
      timed ? "" : "    case temp > 20 degC call b\n", random.below(3) == 0 ? 5 : 40,
      call == "goto b" && timed ? "goto a" : "return");
}

TEST(Surfacings, ThatAreProvedAreAcceptedBySecondCheck) {
  if (!solverIsInstalled()) {
    GTEST_SKIP() << "cvc5 is not installed";
  }
  ir::prove::Options quick;
  quick.total_effort = 1;
  size_t proved = 0;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const std::string text = missionText(random);
    SCOPED_TRACE(text);
    const Issued issued = issue(text, quick);
    ASSERT_EQ(issued.findings.requirements.size(), 1U);
    const std::string file = issued.file(0);
    if (issued.findings.requirements[0].verdict != ir::prove::Verdict::Proved) {
      continue;
    }
    ++proved;
    const analysis::Rechecked found = issued.rechecked(0, file);
    EXPECT_TRUE(found.accepted) << seed << ": " << found.reason;
  }
  EXPECT_GT(proved, 8U);
}

}  // namespace
}  // namespace glider::tests
