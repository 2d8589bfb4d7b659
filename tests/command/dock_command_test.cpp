// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `glidercc dock`: what it prints, and how it ends.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <string>
#include <unistd.h>

namespace glider::tests {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class DockCommand : public testing::Test {
 protected:
  DockCommand() {
    fs::copy_file(GLIDER_SOURCE_DIR "/missions/figure2.mission", path() / "figure2.mission");
    EXPECT_EQ(run("$GLIDERCC build figure2.mission --dialect extctl -o p").status, 0);
  }
  ~DockCommand() override { run("test -e pids && kill $(cat pids)"); }
  [[nodiscard]] const fs::path& path() const { return folder_.path(); }
  Outcome run(const std::string& line) const {  // NOLINT(modernize-use-nodiscard)
    return runShell("cd " + path().string() + " && " + line);
  }
  /// Two terminals, `a` and `b`, as the ends of a cable.
  void connect() const {
    const Outcome begun =
        run("{ socat pty,raw,echo=0,link=a pty,raw,echo=0,link=b & echo $! > pids; for i in $(seq "
            "200); do test -e a && test -e b && break; sleep 0.05; done; } > /dev/null 2>&1 < "
            "/dev/null");
    ASSERT_EQ(begun.status, 0);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(DockCommand, WhatIsNoFolderForThePortIsRefusedWithTheCommandForTheHooks) {
  for (const char* folder : {"figure2.mission", "p/sbc", "nothing"}) {
    const Outcome outcome = run(std::string("$GLIDERCC dock ") + folder + " --port /dev/null");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr("GL4016"), HasSubstr("glidercc sim MISSION --serial DEVICE")));
  }
}

TEST_F(DockCommand, EachFaultOfTheDeviceHasItsOwnMessage) {
  const std::pair<const char*, const char*> devices[] = {{"/dev/nothing-here", "GL9100"},
                                                         {"/dev/null", "GL9103"},
                                                         {"figure2.mission", "GL9103"},
                                                         {"p", "GL9103"}};
  for (const auto& [device, id] : devices) {
    const Outcome outcome = run(std::string("$GLIDERCC dock p --port ") + device);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, HasSubstr(id)) << device;
  }
  connect();
  const bool root = ::geteuid() == 0;
  run("chmod 755 . && chmod 000 $(readlink a) && chmod 755 p p/vehicle p/vehicle/*");
  const Outcome denied = run(std::string(root ? "setpriv --reuid=65534 --clear-groups " : "") +
                             "$GLIDERCC dock p --port $(readlink a)");
  EXPECT_EQ(denied.status, 2);
  EXPECT_THAT(denied.err, HasSubstr("GL9101"));
}

TEST_F(DockCommand, ALineThatAnotherProgramUsesIsBusy) {
  connect();
  run("$GLIDERCC dock p --port a --minutes 0.1 > /dev/null 2>&1 & sleep 3");
  const Outcome second = run("$GLIDERCC dock p --port a --minutes 0.1");
  EXPECT_EQ(second.status, 2);
  EXPECT_THAT(second.err, HasSubstr("GL9102"));
}

TEST_F(DockCommand, NobodyThereIsOneLineAndExitCode1) {
  connect();
  const Outcome outcome = run("$GLIDERCC dock p --port a --as vehicle --minutes 0.3 -o report.txt");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "") << "no progress in a pipe";
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("at the other end: not known"),
                                 HasSubstr("NOT GOOD     the other end: nothing arrived in 12 s"),
                                 HasSubstr("2 good, 1 not good, 0 not checked")));
  EXPECT_EQ(slurp(path() / "report.txt"), outcome.out);
}

TEST_F(DockCommand, IsInterruptedWithAReport) {
  connect();
  // timeout sends the signal twice: to the program, and to its group.
  const Outcome outcome =
      run("timeout -s INT 5 $GLIDERCC dock p --port a --format json -o report.txt");
  EXPECT_EQ(outcome.status, 124) << "of timeout";
  EXPECT_THAT(slurp(path() / "report.txt"), HasSubstr("interrupted before its end"));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("\"end\": \"interrupted\""),
                                 HasSubstr("\"status\": 130"), HasSubstr("\"other_end\": null")));
}

TEST_F(DockCommand, AnUnpluggedDeviceIsReported) {
  connect();
  const Outcome outcome = run(
      "{ { sleep 3; kill $(cat pids); } & } ; $GLIDERCC dock p --port a --minutes 1 -o report.txt");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.out, HasSubstr("NOT GOOD     the device: it was closed or unplugged after"));
  EXPECT_EQ(slurp(path() / "report.txt"), outcome.out);
}

TEST_F(DockCommand, ListensToASimulatedVehicle) {
  connect();
  const Outcome outcome = run(
      "{ $GLIDERCC sim p --serial b --duration 40s -o f > /dev/null 2>&1 & } ; $GLIDERCC dock p "
      "--port a --minutes 0.3 --format json");
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("\"other_end\": \"vehicle\""),
                                 HasSubstr("\"bytes_sent\": 0.0"), Not(HasSubstr("not good"))));
}

TEST_F(DockCommand, SteersOnlyWithATerminalAndAYes) {
  const Outcome piped = run("echo yes | $GLIDERCC dock p --port a --steer");
  EXPECT_EQ(piped.status, 2);
  EXPECT_THAT(piped.err, HasSubstr("--steer: needs a terminal"));
  EXPECT_EQ(run("$GLIDERCC dock p --port a --steer --as vehicle").status, 2);
  connect();
  run("{ $GLIDERCC sim p --serial b --duration 90s -o f > sim.txt 2>&1 & echo $! >> pids; } ");
  // A terminal of its own, at which a person types.
  const auto typed = [&](const std::string& answer, const std::string& seconds,
                         const std::string& more = "") {
    return run("{ sleep 2; echo " + answer + "; sleep " + seconds + more +
               "; } | timeout 40 script -qefc \"$GLIDERCC dock p --port a --as sbc --steer "
               "--minutes 0.1\" /dev/null");
  };
  const Outcome no = typed("no", "6");
  EXPECT_THAT(no.out, AllOf(HasSubstr("To be written to the vehicle on a"),
                            HasSubstr("Type yes to write this to the vehicle:"),
                            HasSubstr("nothing was written: you did not agree")));
  const Outcome yes = typed("yes", "16");
  EXPECT_THAT(yes.out, AllOf(HasSubstr("what was written is taken back: written three times"),
                             HasSubstr("report ++ sci_generic_b")));
  // Ctrl-C while it writes, and once more while it takes that back.
  const Outcome twice = typed("yes", "8", "; printf '\\003'; sleep 1; printf '\\003'; sleep 4");
  EXPECT_THAT(twice.out, AllOf(HasSubstr("what was written is taken back: written three times"),
                               HasSubstr("interrupted before its end")));
}

TEST_F(DockCommand, AListThatLacksASensorIsNotGood) {
  connect();
  run("sed -i /m_lat/d p/vehicle/config/extctl.ini");
  const Outcome outcome = run("$GLIDERCC dock p --port a --as sbc --minutes 0.05 --baud 19200");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("NOT GOOD     extctl.ini of the folder: `m_lat` (lat)"),
                                 HasSubstr("NOT GOOD     baud rate: 19200 baud, but 9600")));
}

}  // namespace
}  // namespace glider::tests
