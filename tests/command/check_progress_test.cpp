// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a long check says of its progress, and to whom. `script` gives it a terminal.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Promises of a counter that Z3 proves one by one, in some seconds together: none follows from
/// those before it.
std::string slowMission() {
  std::string text = "mission survey\nvar n : number = 0 in 0 .. 99\n";
  for (int most = 69; most >= 20; --most) {
    text += "require always\n  n <= " + std::to_string(most) + "\n";
  }
  auto state = [&](const std::string& name, const std::string& profile, const char* cases) {
    text += "state " + name + "\nbegin\n  flightprofile " + profile +
            "\n  sensors missiontime, statetime, depth, temp\n  events\n" + cases + "end\n";
  };
  state("look", "yo(5 m, 25 m, 26 deg, 26 deg)",
        "    case missiontime >= 1 h goto home\n"
        "    case n < 20 && temp > 20 degC do set n = n + 1 end call hot\n");
  state("hot", "yo(5 m, 28 m, 26 deg, 26 deg)", "    case statetime >= 10 min return\n");
  state("home", "surfaced", "    case statetime >= 10 min exit\n");
  return text;
}

TEST(CheckProgress, IsOneLineOfATerminalThatIsGoneAtTheEnd) {
  const TemporaryFolder folder;
  (void)folder.write("slow.mission", slowMission());
  const Outcome outcome =
      runShell("cd " + folder.path().string() +
               " && script -qec '$GLIDERCC check --effort 20 slow.mission' /dev/null");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, testing::ContainsRegex("\r\x1b\\[Kslow.mission: proving [0-9]+ of 50: "
                                                  "require always n <= [0-9]+, [0-9]+ s\r"));
  const size_t last = outcome.out.rfind("\r\x1b[K");
  ASSERT_NE(last, std::string::npos);
  EXPECT_THAT(outcome.out.substr(last), testing::StartsWith("\r\x1b[Kslow.mission: fine; "));
  EXPECT_THAT(outcome.out.substr(0, last), Not(HasSubstr("\n"))) << "all on one line";
}

TEST(CheckProgress, IsNothingWithoutATerminal) {
  const TemporaryFolder folder;
  (void)folder.write("slow.mission", slowMission());
  const Outcome outcome =
      runShell("cd " + folder.path().string() + " && $GLIDERCC check --effort 20 slow.mission");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, testing::StartsWith("slow.mission: fine; "));
}

}  // namespace
}  // namespace glider::tests
