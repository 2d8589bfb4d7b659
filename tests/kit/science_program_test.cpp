// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The kit's example proglet, built by a C99 compiler for this computer and for the vehicle's, flies
// as the simulator's science computer: the same flight, byte for byte, as with the simulator's own.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using testing::HasSubstr;

std::string flown(const TemporaryFolder& folder, const std::string& name,
                  const std::string& arguments) {
  const auto out = folder.path() / name;
  const Outcome outcome =
      runShell("$GLIDERCC sim " + arguments + " -o " + out.string() + " >/dev/null");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return slurp(out / "trace.csv") + slurp(out / "events.csv");
}

class ScienceProgram : public testing::TestWithParam<std::string> {};

TEST_P(ScienceProgram, FliesAsTheSimulatorsOwn) {  // accepts: GL9151 GL9379
  const TemporaryFolder folder;
  const std::string own = flown(folder, "own", GetParam());
  ASSERT_GT(own.size(), 10000U);
  EXPECT_TRUE(own == flown(folder, "host", GetParam() + " --science '" GLIDER_SCIENCE_HOST "'"));
  EXPECT_TRUE(own == flown(folder, "m68k", GetParam() + " --science '" GLIDER_SCIENCE_M68K "'"));
}

INSTANTIATE_TEST_SUITE_P(
    Flights, ScienceProgram,
    testing::Values(GLIDER_SOURCE_DIR "/missions/gallery/thermocline.mission --scenario figure5",
                    GLIDER_SOURCE_DIR "/missions/gallery/bloom.mission --scenario bloom",
                    GLIDER_SOURCE_DIR "/missions/gallery/survey_box.mission --seed 5",
                    GLIDER_SOURCE_DIR "/missions/figure2.mission --kill-sbc-at 900",
                    GLIDER_SOURCE_DIR
                    "/missions/gallery/hull_sweep.mission --scenario " GLIDER_SOURCE_DIR
                    "/tests/kit/troubled.toml"),
    [](const auto& flight) { return "of" + std::to_string(flight.index); });

TEST(ScienceProgram, ThatCannotServeIsRefusedByName) {
  const std::string sim = "$GLIDERCC sim " GLIDER_SOURCE_DIR
                          "/missions/gallery/thermocline.mission -o /dev/null/none --science ";
  for (const auto& [command, why] : {std::pair("false", "it ended with status 1"),
                                     {"/nonexistent", "No such file or directory"},
                                     {"cat", "it answers otherwise than a program of the kit"},
                                     {"''", "no program is named"}}) {
    const Outcome outcome = runShell(sim + command);
    EXPECT_EQ(outcome.status, 2) << command;
    EXPECT_THAT(outcome.err, HasSubstr(why)) << command;
    EXPECT_THAT(outcome.err, HasSubstr("GL9151")) << command;
  }
}

/// A program that answers the greeting, and then runs `script` of a shell.
std::string afterHello(const TemporaryFolder& folder, const std::string& script) {
  return "sh " +
         folder.write("p", "read hello\necho $hello | cut -d' ' -f1-3\n" + script + "\n").string();
}

TEST(ScienceProgram, ThatAnswersWithoutAnEndIsLeftBehind) {
  const TemporaryFolder folder;
  for (const auto& [script, why] :
       {std::pair("yes 'event 6 0 1 2 3 4 5 41'", "its answer has no end"),
        {"yes done", "it has not answered for 10 s"},
        {"trap '' TERM; exec >&- <&-; sleep 60", "it has closed its output, and goes on"},
        {"cat >/dev/null", "it has not answered for 10 s"}}) {
    const Outcome outcome = runShell("$GLIDERCC sim " GLIDER_SOURCE_DIR
                                     "/missions/gallery/thermocline.mission --duration 600 -o " +
                                     (folder.path() / "flight").string() + " --science '" +
                                     afterHello(folder, script) + "' 2>&1");
    EXPECT_EQ(outcome.status, 1) << script;
    EXPECT_THAT(outcome.out, HasSubstr(std::string(why) + " [GL9379")) << script;
  }
}

TEST(ScienceProgram, ThatEndsInAFlightIsAnErrorAndHookbehTakesOver) {
  const TemporaryFolder folder;
  const Outcome outcome = runShell("$GLIDERCC sim " GLIDER_SOURCE_DIR
                                   "/missions/gallery/thermocline.mission --duration 1800 -o " +
                                   (folder.path() / "flight").string() +
                                   " --science '" GLIDER_SOURCE_DIR
                                   "/tests/kit/ends_after 400 " GLIDER_SCIENCE_HOST "'");
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("it ended with status 3 [GL9379"));
  EXPECT_THAT(outcome.out, HasSubstr("hookbeh: the SBC is silent, control revoked"));
}

}  // namespace
}  // namespace glider::tests
