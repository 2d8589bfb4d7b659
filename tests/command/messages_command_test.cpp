// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `glidercc messages`: a fleet's acoustic messages at a ship.

#include "tests/support/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

const std::string kOnlyState = R"(state only
begin
  flightprofile yo(5 m, 20 m)
  sensors       missiontime
  events
    case missiontime >= 40 min exit
end
)";

const std::string kSurveyMission = R"(mission survey
vehicles ada, bob
share level: temperature in -2 degC .. 34 degC precision 0.1 degC every 5 min
share top: length in 0 m .. 200 m precision 0.05 m every 2 min
share found: bool every 2 min
)" + kOnlyState;

class MessagesCommand : public testing::Test {
 protected:
  Outcome messages(const std::string& options) {
    return runShell("$GLIDERCC messages " + mission_.string() + " " + options);
  }

  TemporaryFolder folder_;
  std::filesystem::path mission_ = folder_.write("survey.mission", kSurveyMission);
};

TEST_F(MessagesCommand, ListsWhatCarriesThem) {
  const Outcome told = messages("");
  EXPECT_EQ(told.err, "");
  EXPECT_EQ(told.out,
            "every 120 s: found, top\n"
            "  from vehicles  a frame, 3 of 32 bytes\n"
            "  as JANUS       22 of 34 bits\n"
            "every 300 s: level\n"
            "  from vehicles  a mini packet, 12 of 13 bits\n"
            "  as JANUS       17 of 34 bits\n");
}

TEST_F(MessagesCommand, WhatIsWrittenIsRead) {
  const Outcome told = messages("--send 'top = 42.07 m' --send found=true --send level=-1.5degC");
  EXPECT_EQ(told.status, 0) << told.err;  // accepts: GL9396
  EXPECT_THAT(told.out, HasSubstr("found true, top 42.05 m\n  frame        $CCTXD,15,0,0,"));
  EXPECT_THAT(told.out, HasSubstr("level -1.5 degC\n  mini packet  $CCMUC,15,0,"));
  const auto log = folder_.write("modem.log", "10:15 boat " + told.out + "\n$CAREV,1*00\n");
  const Outcome read = messages("--read " + log.string());
  EXPECT_EQ(read.status, 0);  // accepts: GL9397
  EXPECT_EQ(read.out,
            "vehicle 15: found true, top 42.05 m (frame)\n"
            "vehicle 15: found true, top 42.05 m (JANUS)\n"
            "vehicle 15: level -1.5 degC (mini packet)\n"
            "vehicle 15: level -1.5 degC (JANUS)\n");
  EXPECT_EQ(read.err, "glidercc: note: 3 lines without a message of mission survey\n");
}

/// Made by hand from the rules of hooks/share/README.md, with a sum that was computed apart.
TEST_F(MessagesCommand, ReadsWhatAModemSays) {
  const Outcome sent = messages("--send level=12degC --from 2 --format json");
  const std::string mini = json::parse(sent.out)["messages"][0]["mini_packet"];
  std::string body = mini.substr(1, mini.size() - 4);
  body.replace(0, 5, "CAMUA");
  unsigned sum = 0;
  for (const char c : body) {
    sum ^= static_cast<unsigned char>(c);
  }
  char end[8];
  std::snprintf(end, sizeof end, "*%02X", sum);
  const auto log = folder_.write("modem.log", "\xFF$" + body + end + "\r\n");
  const Outcome read = messages("--read " + log.string());
  EXPECT_EQ(read.out, "bob: level 12 degC (mini packet)\n") << read.err;
}

/// What differs from a right packet, `3a103c00002b647d` of `top=42 m`, in one thing each.
TEST_F(MessagesCommand, WhatIsNoMessageOfTheMissionIsNotShown) {
  const std::string finder = GLIDER_SOURCE_DIR "/missions/fleet/finder.mission";
  for (const char* line : {
           "3a103fffff2b6421",        // a number above the greatest
           "3a033c00002b6498",        // another class of user
           "3e103c00002b6408",        // it begins with a reservation
           "3a103c00002b647e",        // another check
           "3a103c00002b647d00",      // longer
           "$CAMUA,0,0,015C*00",      // no vehicle's address
           "$CARXD,0,0,0,1,642B*13",  //
           "$CARXD,3,0,0,1,642B*10",  // a frame of what is sent as a mini packet
           "$CAMUA,3,0,115C*02",      // above the greatest
       }) {
    const auto log = folder_.write("one.log", std::string(line) + "\n");
    const Outcome read = runShell("$GLIDERCC messages " + finder + " --read " + log.string());
    EXPECT_EQ(read.status, 2) << line << read.out;
    EXPECT_EQ(read.out, "") << line;
  }
  const auto log = folder_.write("one.log", "3a103c00002b647d\n3a033c00002b6498\n");
  EXPECT_EQ(runShell("$GLIDERCC messages " + finder + " --read " + log.string()).out,
            "vehicle 15: top 42 m (JANUS)\n");
  EXPECT_EQ(
      runShell("$GLIDERCC messages " + finder + " --janus-class 3 --read " + log.string()).out,
      "vehicle 15: top 42 m (JANUS)\n");
}

TEST_F(MessagesCommand, WhatCannotBeSentIsRefused) {  // rejects: GL9396
  for (const auto& [setting, why] :
       {std::pair{"top=200.1 m", "`top` has values from 0 m to 200 m"},
        {"top=5 degC", "`top` has values from 0 m to 200 m"},
        {"level=-3 degC", "`level` has values from -2 degC to 34 degC"},
        {"deep=3 m", "the mission shares `found`, `top`, `level`"},
        {"top", "the mission shares `found`, `top`, `level`"}}) {
    const Outcome told = messages(std::string("--send '") + setting + "'");
    EXPECT_EQ(told.status, 2);
    EXPECT_EQ(told.out, "");
    EXPECT_THAT(told.err, HasSubstr(std::string("cannot send `") + setting + "`: " + why));
  }
}

/// A packet of another mission, whose 34 bits are fewer than a message of this one has.
TEST_F(MessagesCommand, AMessageLongerThanAJanusPacketIsNotInOne) {
  const auto mission = folder_.write("long.mission", R"(mission long
vehicles ada, bob
share wide: length in 0 m .. 10000 m precision 0.0001 m every 2 min
share deep: length in 0 m .. 10000 m precision 0.0001 m every 2 min
)" + kOnlyState);
  const auto log = folder_.write("one.log", "3a103c00002b647d\n");
  const Outcome read =
      runShell("$GLIDERCC messages " + mission.string() + " --read " + log.string());
  EXPECT_EQ(read.status, 2) << read.out;
  EXPECT_EQ(read.out, "");
  EXPECT_THAT(runShell("$GLIDERCC messages " + mission.string() + " --send wide=3m").out,
              Not(HasSubstr("JANUS")));
}

TEST_F(MessagesCommand, WithoutAMessageItFails) {  // rejects: GL9397
  const Outcome told = messages("--read - </dev/null");
  EXPECT_EQ(told.status, 2);
  EXPECT_THAT(told.err, HasSubstr("standard input` has no message of mission survey"));
  EXPECT_EQ(messages("--read /nowhere").status, 2);
  EXPECT_EQ(messages("--read x --send top=1m").status, 2);
  EXPECT_EQ(messages("--from 3").status, 2);
}

}  // namespace
}  // namespace glider::tests
