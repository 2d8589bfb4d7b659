// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The command line itself: what is misspelt is named with what was meant, help is where it is
// looked for, the examples in it work, and pipes and terminals get what they expect.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <sstream>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string kTwoStates = GLIDER_SOURCE_DIR "/missions/figure2.mission";

/// The commands that --help lists.
std::vector<std::string> commands() {
  std::vector<std::string> names;
  std::istringstream lines(runShell("$GLIDERCC --help").out);
  bool listed = false;
  for (std::string line; std::getline(lines, line);) {
    if (listed && line.starts_with("  ")) {
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
    listed = listed ? !line.empty() : line == "Subcommands:";
  }
  return names;
}

TEST(Usage, AMisspeltOptionIsNamedWithTheNearest) {
  const Outcome outcome = runShell("$GLIDERCC check --fromat json " + kTwoStates);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err,
            "glidercc: error: `glidercc check` has no option `--fromat`; did you mean "
            "`--format`?\n  hint: `glidercc check --help` lists what it takes\n");
  EXPECT_THAT(runShell("$GLIDERCC sim --senario=front " + kTwoStates).err,
              HasSubstr("did you mean `--scenario`?"));
  // Also where it hides that something else is missing.
  EXPECT_THAT(runShell("$GLIDERCC graph --deepst").err, HasSubstr("did you mean `--deepest`?"));
  EXPECT_THAT(runShell("$GLIDERCC graph x --qqqqq").err,
              HasSubstr("`glidercc graph` has no option `--qqqqq`\n"));
  EXPECT_THAT(runShell("$GLIDERCC campaign --mi my.mi " + kTwoStates).err,
              HasSubstr("`glidercc campaign` has no option `--mi`\n  hint: the scenario names the "
                        "vehicle's mission file: copy one of `scenarios/`, set `skeleton = "
                        "\"my.mi\"` in it, and give the copy with `--scenario`\n"));
  EXPECT_THAT(runShell("$GLIDERCC build a b").err,
              HasSubstr("`glidercc build` takes no argument `b`"));
}

TEST(Usage, AMisspeltCommandIsNamedWithTheNearest) {
  const std::string err = runShell("$GLIDERCC chekc " + kTwoStates).err;
  EXPECT_THAT(err, StartsWith("glidercc: error: there is no command `chekc`; did you mean "
                              "`check`?\n  hint: the commands are: "));
  EXPECT_THAT(runShell("$GLIDERCC help chekc").err, HasSubstr("did you mean `check`?"));
}

TEST(Usage, AMisspeltChoiceIsNamedWithTheNearest) {
  const auto err = [](const std::string& words) {
    const Outcome outcome = runShell("$GLIDERCC " + words);
    EXPECT_EQ(outcome.status, 2) << words;
    return outcome.err;
  };
  EXPECT_THAT(err("check m --format jsn"),
              HasSubstr("--format: `jsn` is not one of text, json, sarif; did you mean `json`?"));
  EXPECT_THAT(err("sim m --picture p --colour-by temperature"), HasSubstr("did you mean `temp`?"));
  EXPECT_THAT(err("sim m --picture p --colour temperature"),
              StartsWith("glidercc: error: `temperature` is not one of state, "));
  EXPECT_THAT(err("campaign m --fault silent"), HasSubstr("`silent` is not one of "));
}

TEST(Usage, AMisspeltScenarioOrTargetIsNamedWithTheNearest) {
  const TemporaryFolder folder;
  const std::string mission = " " + folder.path().string() + "/m.mission";
  ASSERT_EQ(runShell("$GLIDERCC new transect" + mission).status, 0);
  EXPECT_THAT(runShell("$GLIDERCC sim --scenario blom" + mission).err,
              HasSubstr("hint: did you mean `bloom`?\n"));
  EXPECT_THAT(runShell("$GLIDERCC build --target ts780" + mission).err,
              HasSubstr("hint: did you mean `ts7800`?\n"));
  EXPECT_THAT(runShell("$GLIDERCC build --target vax" + mission).err,
              HasSubstr("hint: the targets are cm4, host, "));
}

TEST(Usage, ColourOfMessagesAndColourOfTheTrackAreNotConfused) {
  EXPECT_THAT(runShell("$GLIDERCC sim m --color chlorophyll").err,
              HasSubstr("the colour of the track is `--colour-by`"));
  EXPECT_THAT(runShell("$GLIDERCC sim m --picture p --colour always").err,
              HasSubstr("the colour of messages is `--color`"));
  EXPECT_THAT(runShell("$GLIDERCC sim --help").out, Not(HasSubstr("--colour ")));
}

TEST(Usage, ColourIsAsAskedFor) {
  const TemporaryFolder folder;
  const auto mission = folder.write("m.mission", "mission m\nstate s begin end\n");
  const std::string check = "$GLIDERCC check " + mission.string();
  EXPECT_THAT(runShell(check + " --color=always").err, HasSubstr("\x1b["));
  EXPECT_THAT(runShell("NO_COLOR=1 " + check + " --color always").err, HasSubstr("\x1b["));
  EXPECT_THAT(runShell(check).err, Not(HasSubstr("\x1b[")));
  const std::string terminal = "script -qec '" + check;
  EXPECT_THAT(runShell(terminal + "' /dev/null").out, HasSubstr("\x1b["));
  EXPECT_THAT(runShell(terminal + " --color=never' /dev/null").out, Not(HasSubstr("\x1b[1")));
}

TEST(Usage, QuietLeavesErrorsAndWhatWasAskedFor) {
  const TemporaryFolder folder;
  const std::string here = "cd " + folder.path().string() + "; $GLIDERCC ";
  for (const std::string words : {"check -q ", "sim --quiet -o f ", "graph -q "}) {
    const Outcome outcome = runShell(here + words + kTwoStates);
    EXPECT_EQ(outcome.status, 0) << words << outcome.err;
    EXPECT_EQ(outcome.out + outcome.err, "") << words;
  }
  EXPECT_THAT(runShell(here + "params -q " + kTwoStates).out, HasSubstr("no parameters"));
  EXPECT_THAT(runShell(here + "check -q /nonexistent").err, HasSubstr("[GL9001 "));
}

TEST(Usage, HelpOfACommandIsTheSameEitherWay) {
  const auto names = commands();
  ASSERT_GE(names.size(), 18U);
  for (const std::string& name : names) {
    const Outcome help = runShell("$GLIDERCC help " + name);
    EXPECT_EQ(help.status, 0) << name;
    EXPECT_EQ(help.out, runShell("$GLIDERCC " + name + " --help").out) << name;
  }
  EXPECT_EQ(runShell("$GLIDERCC help").out, runShell("$GLIDERCC --help").out);
}

TEST(Usage, WithoutArgumentsTheHelpIsShownAsAnError) {
  const Outcome outcome = runShell("$GLIDERCC");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, runShell("$GLIDERCC --help").out);
}

TEST(Usage, HelpListsTheChoices) {
  EXPECT_THAT(runShell("$GLIDERCC sim --help").out,
              testing::AllOf(HasSubstr("one of bloom, default, figure5"),
                             HasSubstr("one of cm4, host, pizero2, ts5500, ts7800"),
                             HasSubstr("[MISSION-flight in the current folder]")));
  EXPECT_THAT(runShell("$GLIDERCC campaign --help").out, HasSubstr("low_battery"));
  EXPECT_THAT(runShell("$GLIDERCC build --help").out,
              HasSubstr("one of cm4, host, pizero2, ts5500, ts7800"));
}

/// The examples at the end of the help of a command.
std::vector<std::string> examplesOf(const std::string& command) {
  const std::string help = runShell("$GLIDERCC help " + command).out;
  const size_t begin = help.find("\nExamples:\n");
  std::vector<std::string> lines;
  std::istringstream rest(begin == std::string::npos ? "" : help.substr(begin + 11));
  for (std::string line; std::getline(rest, line);) {
    lines.push_back(line.substr(line.find("glidercc") + 8));
  }
  return lines;
}

TEST(Usage, TheExamplesOfEachCommandWork) {
  const TemporaryFolder folder;
  const std::string here = "cd " + folder.path().string() + "; ";
  const std::string share = "$(dirname $GLIDERCC)/../share/glidercc/";
  (void)folder.write("steeper", "");
  const Outcome prepared = runShell(
      here +
      "$GLIDERCC new budget > /dev/null && $GLIDERCC new transect > /dev/null && sed 's/26 deg, 26 "
      "deg/26 deg, 20 deg/' "
      "transect.mission > steeper.mission && cp " +
      share +
      "scenarios/skeleton.mi "
      "survey.mi && printf '\nbehavior: yo\n  b_arg: d_target_depth(m) 20\n' >> survey.mi && "
      "$GLIDERCC build transect.mission --dialect extctl -o transect-port && "
      "$GLIDERCC sim transect.mission --board host -o logged > /dev/null && "
      "find logged -name '*.log' -exec cp {} transect.log ';' && test -s transect.log && "
      "cp " GLIDER_SOURCE_DIR
      "/missions/fleet/finder.mission . && $GLIDERCC messages finder.mission "
      "--send 'top=42 m' > modem.log");
  ASSERT_EQ(prepared.status, 0) << prepared.err;
  for (const std::string& command : commands()) {
    const auto examples = examplesOf(command);
    EXPECT_EQ(examples.size(), 2U) << command;
    for (const std::string& words : examples) {
      const Outcome outcome = runShell(here + "$GLIDERCC" + words);
      // The two missions of diff differ; the device of dock is not there.
      const int expected = command == "diff" ? 1 : command == "dock" ? 2 : 0;
      EXPECT_EQ(outcome.status, expected) << words << "\n" << outcome.err;
      EXPECT_EQ(outcome.err.find("GL9100") != std::string::npos, command == "dock") << outcome.err;
    }
  }
}

TEST(Usage, AReaderThatLeavesEndsTheCommandSilently) {
  for (const std::string& words :
       std::vector<std::string>{"explain", "platform --json", "--man", "check --help",
                                "build " + kTwoStates + " --emit=asm -o -", "completion bash",
                                "params --format json " + kTwoStates}) {
    const Outcome outcome =
        runShell("{ sleep 0.1; $GLIDERCC " + words + "; echo $? >&2; } | true; sleep 0.5");
    EXPECT_EQ(outcome.err, "141\n") << words << ": as of a program that SIGPIPE ends";
  }
}

TEST(Usage, AFlightIsWrittenEvenIfNobodyReadsItsSummary) {
  const TemporaryFolder folder;
  const Outcome outcome =
      runShell("cd " + folder.path().string() + "; { sleep 0.1; $GLIDERCC sim " + kTwoStates +
               " -o f; echo $? >&2; } | true; until [ -s f/flight.json ]; do sleep 0.1; done");
  EXPECT_EQ(outcome.err, "141\n");
}

TEST(Usage, TheVersionSaysWhatWasBuilt) {
  const std::string version = runShell("$GLIDERCC --version").out;
  EXPECT_THAT(version, testing::ContainsRegex("^glidercc [0-9.]+ \\(commit ([0-9a-f]+|unknown)\\)\n"
                                              "LLVM [0-9.]+\nhook protocol [0-9]+\n"
                                              "dictionary of slocum: [0-9a-f]+\n$"));
}

TEST(Usage, StartsFast) {
  const Outcome outcome = runShell("time -p $GLIDERCC --help > /dev/null");
  const double took = std::stod(outcome.err.substr(outcome.err.find("user") + 5));
  EXPECT_LE(took, 0.04) << "of a processor; a shell that completes runs it at each key";
}

}  // namespace
}  // namespace glider::tests
