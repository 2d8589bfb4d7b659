// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What calls through pointers reach, in a program that has a function of every kind.

#include "codegen/llvm/budget/callees.h"

#include "tests/unit/codegen/small_program.h"

#include <gtest/gtest.h>

#include <set>

namespace glider::codegen {
namespace {

using codegen_tests::Small;
using Names = std::set<std::string>;

const Names kMission = {"act.a",    "advance.a", "begin",  "enter.a",
                        "guards.a", "profile.a", "route.a"};
const Names kHolds = {"holds.a"};

/// All of them but `pollTemp` are in a pointer.
const char* const kTaken[] = {"_start",
                              "main",
                              "libc_start_main_stage2",
                              "_init",
                              "_fini",
                              "__a_barrier_v7",
                              "__a_cas_v7",
                              "__a_get_tp",
                              "__restore_rt",
                              "cgt_init",
                              "cgt_time32_wrap",
                              "act.a",
                              "advance.a",
                              "enter.a",
                              "guards.a",
                              "profile.a",
                              "route.a",
                              "holds.a",
                              "begin",
                              "other"};

Names with(Names names, const std::string& one) {
  names.insert(one);
  return names;
}

class CalleesOfSmall : public testing::Test {
 protected:
  CalleesOfSmall() : small_("ts5500", program()), callees_(small_.image(), mission()) {}

  Names inProgram(const std::string& caller) const {
    return namesOf(callees_.inProgram(*small_.image().function(caller), 0));
  }
  Names inTick(const std::vector<Frame>& frames) const { return namesOf(callees_.inTick(frames)); }

  static const std::vector<std::pair<std::string, Names>>& callers();

 private:
  static std::string program() {
    std::string text, data = ".data\n";
    for (const char* name : kTaken) {
      text += codegen_tests::function(name, "ret");
      data += std::string(".long ") + name + "\n";
    }
    for (const auto& [caller, reached] : callers()) {
      if (caller.find("cgt_") != 0) {
        text += codegen_tests::function(caller, "ret");
      }
    }
    return text + codegen_tests::function("pollTemp", "ret") + data;
  }
  static ir::Mission mission() {
    ir::Mission mission;
    mission.sensors.resize(2);
    mission.sensors[1].symbol = "pollTemp";
    return mission;
  }
  [[nodiscard]] Names namesOf(const std::vector<uint64_t>& addresses) const {
    Names names;
    for (const uint64_t address : addresses) {
      names.insert(small_.image().symbolAt(address));
    }
    EXPECT_EQ(names.size(), addresses.size()) << "each once";
    return names;
  }

  Small small_;
  Callees callees_;
};

const std::vector<std::pair<std::string, Names>>& CalleesOfSmall::callers() {
  static const Names tick = with(kMission, "pollTemp"), kernel = {"__a_get_tp"};
  static const std::vector<std::pair<std::string, Names>> all = {
      {"of_no_row", {"other"}},
      {"__libc_start_main", {"libc_start_main_stage2"}},
      {"libc_start_init", {"_init", "_fini", "other"}},
      {"libc_exit_fini", {"_init", "_fini", "other"}},
      {"__clock_gettime", {"cgt_init", "cgt_time32_wrap"}},
      {"__clock_gettime64", {"cgt_init", "cgt_time32_wrap"}},
      {"__clock_gettim", {"other"}},
      {"cgt_init", {"cgt_time32_wrap"}},
      {"cgt_time32_wrap", {}},
      {"__init_ssp", kernel},
      {"__errno_location", kernel},
      {"___errno_location", kernel},
      {"__init_tp", kernel},
      {"__libc_sigaction", kernel},
      {"__lock", kernel},
      {"__unlock", kernel},
      {"__a_barrier_oldkuser", {}},
      {"raise", kernel},
      {"gliderStart", tick},
      {"gliderStep", tick},
      {"advance", tick},
      {"enter", tick},
      {"fire", tick},
      {"firstTrue", tick},
      {"gliderFirstTrue", kHolds},
      {"firstTrueRow", kHolds},
      {"fly", tick},
      {"tryAlways", tick},
      {"tryState", tick},
      {"tryActivity", tick},
      {"pollSensors", {"pollTemp"}},
  };
  return all;
}

TEST_F(CalleesOfSmall, AreThoseOfTheCallersRows) {
  for (const auto& [caller, reached] : callers()) {
    EXPECT_EQ(inProgram(caller), reached) << caller;
  }
  EXPECT_EQ(inProgram("libc_start_main_stage2"), Names{"main"});
}

TEST_F(CalleesOfSmall, OfATickAreThoseOfTheFrame) {
  const std::pair<Frame, Names> cases[] = {
      {{"readings.cpp", "pollSensors", 1}, {"pollTemp"}},
      {{"step.cpp", "advance", 1}, {"advance.a"}},
      {{"step.cpp", "firstTrue", 7}, {"guards.a"}},
      {{"step.cpp", "fire", 1}, {"act.a"}},
      {{"step.cpp", "enter", 1}, {"enter.a"}},
      {{"step.cpp", "fly", 1}, {"profile.a", "route.a"}},
      {{"guard_table.cpp", "firstTrue", 1}, {"holds.a"}},
  };
  for (const auto& [frame, reached] : cases) {
    EXPECT_EQ(inTick({frame}), reached) << frame.function;
    EXPECT_EQ(inTick({frame, {"step.cpp", "fire", 3}}), reached) << "the innermost decides";
  }
}

TEST_F(CalleesOfSmall, OfATickMayBeAnyWhereTheLineTablesAreSilent) {
  const Names any = {"pollTemp", "act.a",     "advance.a", "enter.a",
                     "guards.a", "profile.a", "route.a",   "holds.a"};
  const Frame cases[] = {
      {"readings.cpp", "pollSensors", 0}, {"step.cpp", "pollSensors", 1},
      {"readings.cpp", "find", 1},        {"step.cpp", "fire", 0},
      {"stack.cpp", "fire", 1},           {"step.cpp", "tryState", 1},
  };
  for (const Frame& frame : cases) {
    EXPECT_EQ(inTick({frame}), any) << frame.file << ' ' << frame.function << ' ' << frame.line;
  }
}

/// The seat within a program, by the names that the compiler gives its functions.
TEST(CalleesInASeat, AreNotThoseThatAreExcluded) {
  const std::pair<std::string, std::string> taken[] = {
      {"read", "_ZN6glider7runtime9InnerSeat4readEPvPhj"},
      {"write", "_ZN6glider7runtime9InnerSeat5writeEPvPKhj"},
      {"receive", "_ZN6glider7runtime5recon8Backseat4hearEPv"},
      {"answer", "_ZN6glider7runtime3imc8Backseat6answerEPv"},
      {"reading", "_ZN6glider7runtime9InnerSeat7readingEPvtPd"},
      {"line", "_ZN6glider7runtime5recon7UdpLine4readEPvPhj"},
      {"renew", "_ZN6glider7runtime12_GLOBAL__N_18renewTcpEPv"},
      {"other", "_ZN6glider7runtime4Card8writeLogEPvPKhj"},
  };
  std::string text = codegen_tests::function("_start", "ret"), data = ".data\n";
  for (const auto& [name, symbol] : taken) {
    text += codegen_tests::function(symbol, "ret");
    data += ".long " + symbol + "\n";
  }
  const Small small("ts5500", text + data);
  const ir::Mission mission;
  const Callees callees(small.image(), mission);
  const auto within = [&](const std::string& active) {
    uint32_t excluded = 0;
    for (const auto& [name, symbol] : taken) {
      excluded |= name == active ? callees.excludedBy(*small.image().function(symbol)) : 0;
    }
    Names names;
    for (const uint64_t address : callees.inProgram(small.image().entry(), excluded)) {
      for (const auto& [name, symbol] : taken) {
        if (small.image().symbolAt(address) == symbol) {
          names.insert(name);
        }
      }
    }
    return names;
  };
  const Names all = {"read", "write", "receive", "answer", "reading", "line", "renew", "other"};
  EXPECT_EQ(within("nothing"), all);
  EXPECT_EQ(within("other"), all) << "it has no row";
  EXPECT_EQ(within("read"), (Names{"receive", "reading", "line", "renew", "other"}));
  EXPECT_EQ(within("write"), (Names{"answer", "reading", "line", "renew", "other"}));
  EXPECT_EQ(within("receive"), (Names{"reading", "line", "renew", "other"}));
  EXPECT_EQ(within("answer"), (Names{"line", "renew", "other"}));
  for (const char* last : {"reading", "line", "renew"}) {
    EXPECT_EQ(within(last), Names{"other"}) << last;
  }
}

TEST(CallsAtOnce, AreOneWithoutARow) {
  EXPECT_EQ(callsAtOnce("convert_ioctl_struct"), 2u);
  EXPECT_EQ(callsAtOnce("gliderStep"), 1u);
}

}  // namespace
}  // namespace glider::codegen
