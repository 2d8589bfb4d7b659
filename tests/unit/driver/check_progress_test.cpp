// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The line of a long check on terminals of several widths: one that were longer than the terminal
// would not be written over.

#include "driver/output/check_progress.h"

#include "driver/terminal.h"

#include <gtest/gtest.h>

#include <functional>
#include <gmock/gmock.h>
#include <pty.h>
#include <string>
#include <sys/ioctl.h>
#include <unistd.h>

namespace glider::driver {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

/// What is written to standard error while that is a terminal of so many columns; 0: unknown width.
std::string toldOn(unsigned short columns, const std::string& work,
                   const std::function<void(CheckProgress&)>& then = {}, double limit_s = 0) {
  int master = -1, slave = -1;
  const winsize size = {24, columns, 0, 0};
  EXPECT_EQ(::openpty(&master, &slave, nullptr, nullptr, &size), 0);
  const int usual = ::dup(STDERR_FILENO);
  ::dup2(slave, STDERR_FILENO);
  {
    CheckProgress progress("survey.mission", limit_s);
    progress.at(work);
    std::this_thread::sleep_for(std::chrono::milliseconds(1150));
    if (then) {
      then(progress);
    }
  }
  ::dup2(usual, STDERR_FILENO);
  ::close(usual);
  ::close(slave);
  std::string told;
  char bytes[256];
  for (ssize_t count = 0; (count = ::read(master, bytes, sizeof bytes)) > 0;) {
    told.append(bytes, static_cast<size_t>(count));
  }
  ::close(master);
  return told;
}

const std::string kBegin = "\r\x1b[K", kSixty(60, 'x');

TEST(CheckProgress, IsAsLongAsThereIsRoomAndGoneAtTheEnd) {
  const std::string told = toldOn(200, "proving 1 of 2:\nexit");
  EXPECT_THAT(told, StartsWith(kBegin + "survey.mission: proving 1 of 2: exit, 1 s" + kBegin));
  EXPECT_THAT(told, EndsWith(kBegin));
}

TEST(CheckProgress, SaysHowLongProofsMayTake) {
  const std::string told = toldOn(200, "proving 1 of 2: exit", {}, 120);
  EXPECT_THAT(told, HasSubstr(kBegin + "survey.mission: proving 1 of 2: exit, 1 s (proofs: at most "
                                       "120 s)"));
}

TEST(CheckProgress, IsRemovedForWhatElseIsPrinted) {
  const std::string told = toldOn(200, "proving", [](CheckProgress& progress) {
    progress.clear();
    tell("warning");
  });
  EXPECT_THAT(told, HasSubstr(", 1 s" + kBegin + "warning"));
}

TEST(CheckProgress, IsOneShorterThanTheTerminal) {
  EXPECT_THAT(toldOn(30, kSixty), StartsWith(kBegin + "survey.mission: xxxxxxxx, 1 s" + kBegin));
}

TEST(CheckProgress, IsCutBetweenCharacters) {
  EXPECT_THAT(toldOn(30,
                     "gr\xC3\xB6\xC3\x9F"
                     "er \xC3\xB6"),
              StartsWith(kBegin +
                         "survey.mission: gr\xC3\xB6\xC3\x9F"
                         "er, 1 s" +
                         kBegin));
  EXPECT_THAT(toldOn(30, "1234567\xC3\xB6"),
              StartsWith(kBegin + "survey.mission: 1234567, 1 s" + kBegin));
}

TEST(CheckProgress, OfATerminalThatDoesNotSayHowWideItIsTakesEighty) {
  EXPECT_THAT(
      toldOn(0, kSixty + kSixty),
      StartsWith(kBegin + "survey.mission: " + std::string(79 - 16 - 5, 'x') + ", 1 s" + kBegin));
}

TEST(CheckProgress, OfAVeryNarrowOneTheTimeIsLeft) {
  EXPECT_THAT(toldOn(3, kSixty), StartsWith(kBegin + ", 1 s" + kBegin));
}

}  // namespace
}  // namespace glider::driver
