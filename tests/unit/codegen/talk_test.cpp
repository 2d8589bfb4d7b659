// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The program of a mission that shares values: what it knows of them, and its line to the modem.

#include "codegen/load/loaded_mission.h"
#include "hooks/protocol/tick.h"
#include "hooks/transport/descriptor.h"
#include "platforms/load/load_platform.h"
#include "runtime/talk/talker.h"
#include "support/files.h"
#include "tests/slocum.h"
#include "tests/unit/codegen/compiled_mission.h"
#include "tests/unit/runtime/scripted_modem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <tuple>
#include <unistd.h>

namespace glider::codegen_tests {
namespace {

namespace fs = std::filesystem;
using runtime::testing::ScriptedModem;
using testing::HasSubstr;
using testing::Not;

/// Figure 2 with three shares, and with headings if asked.
Checked talking(bool headings = false) {
  std::string text =
      support::readFile(GLIDER_SOURCE_DIR "/tests/golden/verify/ok_figure2.ir").value_or("");
  const auto add = [&](const std::string& before, const std::string& lines) {
    text.insert(text.find(before), lines);
  };
  add("behaviour profile yo",
      R"(sensor clock: time vehicle m_present_time id 0 encoding linear to_si 1 lowest 0 highest 4e9 stale_after 20
sensor "peer.top": length received id 65024 encoding linear to_si 1 lowest 0 highest 200 stale_after 600
sensor heading: angle vehicle m_heading id 9 encoding linear to_si 1 lowest 0 highest 6.3 stale_after 20
)");
  add("\nstate s1", R"(variable found: bool mission
initial found true
utc clock
share top of sensor depth received "peer.top" lowest 0 step 0.5 values 401 every 60
share found of variable found lowest 0 step 1 values 2 every 60
share warm of sensor temp lowest -2 step 0.05 values 841 every 600
)");
  if (headings) {
    add("behaviour profile yo", "compass declination 0.25\n");
  }
  return checkedMission(text);
}

codegen::LoadedMission load(const Checked& checked, int level) {
  codegen::CodegenOptions options;
  options.optimisation_level = level;
  const auto shared = codegen::linkShared(checked.input(), board("host"), options);
  EXPECT_TRUE(shared.has_value()) << shared.error().message;
  auto loaded = codegen::LoadedMission::load(*shared);
  EXPECT_TRUE(loaded.has_value()) << loaded.error().message;
  return std::move(*loaded);
}

class TalkShared : public testing::TestWithParam<int> {};

TEST_P(TalkShared, KnowsItsShares) {
  const codegen::LoadedMission loaded = load(talking(), GetParam());
  ASSERT_NE(loaded.talk(), nullptr);
  const GliderTalk& talk = *loaded.talk();
  EXPECT_EQ(talk.slot_s, 19);
  EXPECT_EQ(talk.begin_within_ms, 4000U);
  EXPECT_EQ(talk.utc, 2U);
  ASSERT_EQ(talk.share_count, 3U);
  EXPECT_EQ(talk.shares[0].step, 0.5);
  EXPECT_EQ(talk.shares[0].values, 401U);
  EXPECT_EQ(talk.shares[0].reading, 0U);
  EXPECT_EQ(talk.shares[0].variable, GLIDER_NO_PLACE);
  EXPECT_EQ(talk.shares[0].peer, 3U);
  EXPECT_EQ(talk.shares[1].reading, GLIDER_NO_PLACE);
  EXPECT_EQ(talk.shares[1].variable, 0U);
  EXPECT_EQ(talk.shares[1].peer, GLIDER_NO_PLACE);
  EXPECT_EQ(talk.shares[2].lowest, -2);
  ASSERT_EQ(talk.message_count, 2U);
  EXPECT_EQ(talk.messages[0].period, 60);
  EXPECT_EQ(talk.messages[0].count, 2U);
  EXPECT_EQ(talk.messages[0].bytes, 3U);
  EXPECT_EQ(talk.messages[1].first, 2U);
  EXPECT_EQ(talk.messages[1].signature, 75U);
  EXPECT_STREQ(loaded.mission().sensors[3].name, "peer.top");
  EXPECT_TRUE(std::isnan(loaded.mission().sensors[3].poll(0)));
}

/// The same with the top of two of three vehicles, whose names come last.
Checked talkingByName() {
  Checked checked = talking();
  ir::Mission& mission = checked.mission;
  mission.vehicles = {"ada", "bob", "carl"};
  for (const uint32_t address : {1U, 3U}) {
    ir::Sensor heard = mission[mission.shares[0].peer];
    heard.id = static_cast<uint16_t>(ir::kFirstHeardSensor + ir::kMostShares + address);
    heard.name = heard.vehicle_name = mission.vehicles[address - 1] + ".top";
    mission.shares[0].named.push_back({address, {static_cast<uint32_t>(mission.sensors.size())}});
    mission.sensors.push_back(heard);
  }
  return checked;
}

TEST_P(TalkShared, KnowsWhomItReceivesBy) {
  const codegen::LoadedMission none = load(talking(), GetParam());
  EXPECT_EQ(none.talk()->named_count, 0U);
  EXPECT_EQ(none.talk()->vehicle_count, 0U);
  const codegen::LoadedMission loaded = load(talkingByName(), GetParam());
  const GliderTalk& talk = *loaded.talk();
  EXPECT_EQ(talk.vehicle_count, 3U);
  ASSERT_EQ(talk.named_count, 2U);
  for (uint32_t i = 0; i < 2; ++i) {
    EXPECT_EQ(talk.named[i].reading, 5 + i);
    EXPECT_EQ(talk.named[i].share, 0U);
    EXPECT_EQ(talk.named[i].source, i == 0 ? 1U : 3U);
  }
  EXPECT_EQ(talk.named[2].reading, 0U) << "no more";
  EXPECT_STREQ(loaded.mission().sensors[6].name, "carl.top");
  EXPECT_TRUE(std::isnan(loaded.mission().sensors[6].poll(0)));
}

TEST_P(TalkShared, SendsAndReceives) {
  const codegen::LoadedMission loaded = load(talking(), GetParam());
  const GliderMission& mission = loaded.mission();
  runtime::talk::Talker talker(*loaded.talk(), 1, 1);
  ScriptedModem modem;
  std::vector<double> memory(mission.context_bytes / sizeof(double));
  GliderContext* context = nullptr;
  double variation = NAN;
  for (double time = 0; time < 60; ++time) {
    std::vector<GliderUpdate> frame{{8.3, 2, 0}, {47222220.0 * 36 + time, 0, 0}};
    frame.resize(hooks::kMostSubscriptions);
    const uint32_t count = mission.compass->convert(&mission, context, &variation, frame.data(), 2);
    if (context == nullptr) {
      context = loaded.start(memory.data(), nullptr, frame.data(), count);
    } else {
      loaded.step(context, time, frame.data(), count);
    }
    mission.compass->convert(&mission, context, &variation, nullptr, 0);
    talker.poll(modem.stream(), context, time);
    if (time == 40) {
      modem.say("CARXD,2,0,0,1," + modem.heardOf("CCTXD")[0].substr(12));
    }
  }
  EXPECT_EQ(talker.counts().received, 1U);
  EXPECT_EQ(context->readings[3].value, 8.5);
}

TEST_P(TalkShared, HeadingsAreConvertedIfThereAreAny) {
  for (const bool headings : {false, true}) {
    Checked checked = talking(headings);
    checked.mission.sensors[4].encoding = headings ? ir::Encoding::Magnetic : ir::Encoding::Linear;
    const codegen::LoadedMission loaded = load(checked, GetParam());
    const GliderCompass* compass = loaded.mission().compass;
    ASSERT_NE(compass, nullptr);
    EXPECT_EQ(compass->variation, GLIDER_NO_SENSOR);
    EXPECT_EQ(std::isnan(compass->declination), !headings);
    double variation = NAN;
    GliderUpdate frame[hooks::kMostSubscriptions] = {{1, 9, 0}};
    EXPECT_EQ(compass->convert(&loaded.mission(), nullptr, &variation, frame, 1), 1U);
    EXPECT_EQ(frame[0].value, headings ? 1.25 : 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, TalkShared, testing::Values(0, 2, 3));

TEST(TalkShared, OthersHaveNothingOfIt) {
  const codegen::LoadedMission loaded = load(figure2(), 2);
  EXPECT_EQ(loaded.talk(), nullptr);
  EXPECT_EQ(loaded.mission().compass, nullptr);
}

fs::path programOf(const Checked& checked, const std::string& name, int level) {
  fs::path output = testFolder() / "talking";
  codegen::CodegenOptions options;
  options.optimisation_level = level;
  const auto built = codegen::linkExecutable(checked.input(), board(name), options, output);
  EXPECT_TRUE(built.has_value()) << built.error().message;
  return output;
}

/// How a board's program is started here.
std::vector<std::string> commandOf(const std::string& name, const fs::path& program) {
  std::vector<std::string> command = board(name).emulator;
  command.push_back(program);
  return command;
}

/// Its exit status, and what it says, if the vehicle's line has ended.
std::pair<int, std::string> runOn(const std::string& name, const fs::path& program,
                                  const std::string& arguments) {
  std::string command;
  for (const std::string& word : commandOf(name, program)) {
    command += word + " ";
  }
  const std::string said = program.string() + ".said";
  const int status =
      std::system((command + arguments + " < /dev/null > " + said + " 2>&1").c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, support::readFile(said).value_or("")};
}

class TalkOnBoard : public testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(TalkOnBoard, TakesTheOptionsOfAModem) {
  const auto [name, level] = GetParam();
  const fs::path program = programOf(talking(), name, level);
  const auto run = [&, on = std::string(name)](const std::string& arguments) {
    return runOn(on, program, arguments);
  };
  EXPECT_THAT(run("--help").second, HasSubstr("\n  --modem PATH  "));
  for (const auto& [arguments, status, problem] :
       std::vector<std::tuple<const char*, int, const char*>>{
           {"", 2, "without --modem, nothing is shared"},
           {"--modem /nonexistent --address 1 --vehicles 2", 2,
            "warning: cannot open `/nonexistent`: there is no such device; nothing is shared"},
           {"--modem /dev/null --address 1 --vehicles 2", 2,
            "warning: cannot open `/dev/null`: it is not a serial port; nothing is shared"},
           {"--modem fd:77 --address 1 --vehicles 2", 2,
            "warning: cannot open `fd:77`: it is not open; nothing is shared"},
           {"--modem fd:x --address 1 --vehicles 2", 2, "it is not the number of a descriptor"},
           {"--modem fd:0 --vehicles 2", 1, "error: --modem needs --address and --vehicles"},
           {"--modem fd:0 --address 2", 1, "error: --modem needs --address and --vehicles"},
           {"--modem fd:0 --address 3 --vehicles 2", 1, "error: --address is greater"},
           {"--modem fd:0 --address 0", 1, "error: cannot make sense of `--address 0`; see --help"},
           {"--modem fd:0 --address 16", 1, "cannot make sense of `--address 16`"},
           {"--modem fd:0 --vehicles 16", 1, "cannot make sense of `--vehicles 16`"},
           {"--modem fd:0 --modem-baud x", 1, "cannot make sense of `--modem-baud x`"},
           {"--modem", 1, "cannot make sense of `--modem`"}}) {
    const auto [ended, said] = run(std::string("--stdio ") + arguments);
    EXPECT_EQ(ended, status) << arguments;
    EXPECT_THAT(said, HasSubstr(problem));
  }
}

/// The two ends of a line to a modem, the program's second: a pair of sockets, or a terminal.
std::array<int, 2> modemLine(bool terminal) {
  std::array<int, 2> ends{-1, -1};
  if (!terminal) {
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
    return ends;
  }
  ends[0] = ::posix_openpt(O_RDWR | O_NOCTTY);
  EXPECT_EQ(::grantpt(ends[0]), 0);
  EXPECT_EQ(::unlockpt(ends[0]), 0);
  ends[1] = ::open(::ptsname(ends[0]), O_RDWR | O_NOCTTY);
  EXPECT_GE(ends[1], 0);
  return ends;
}

/// A program that was started with a line to a vehicle that says nothing, and a modem, which is
/// descriptor 3.
class Started {
 public:
  explicit Started(const std::vector<std::string>& command, bool terminal = false) {
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, vehicle_), 0);
    std::ranges::copy(modemLine(terminal), modem_);
    EXPECT_EQ(::fcntl(modem_[0], F_SETFL, O_NONBLOCK), 0);
    child_ = ::fork();
    if (child_ == 0) {
      // What is opened here may be 3 itself.
      const int modem = ::fcntl(modem_[1], F_DUPFD, 10);
      const int vehicle = ::fcntl(vehicle_[1], F_DUPFD, 10);
      ::dup2(vehicle, 0);
      ::dup2(vehicle, 1);
      ::dup2(modem, 3);
      for (int other = 4; other < 32; ++other) {
        ::close(other);
      }
      std::vector<char*> arguments;
      for (const std::string& word : command) {
        arguments.push_back(const_cast<char*>(word.c_str()));
      }
      arguments.push_back(nullptr);
      ::execvp(arguments[0], arguments.data());
      ::_exit(126);
    }
    ::close(vehicle_[1]);
    ::close(modem_[1]);
  }
  ~Started() {
    ::close(vehicle_[0]);
    ::close(modem_[0]);
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
  }
  Started(const Started&) = delete;
  Started& operator=(const Started&) = delete;

  void say(const std::string& body) {
    const std::string whole = runtime::testing::sentence(body);
    EXPECT_EQ(::write(modem_[0], whole.data(), whole.size()), static_cast<ssize_t>(whole.size()));
  }
  /// The next line that the modem gets; empty: none for so long.
  std::string next(int most_ms) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(most_ms);
    for (size_t at = got_.find("\r\n");; at = got_.find("\r\n")) {
      if (at != std::string::npos) {
        std::string line = got_.substr(0, at);
        got_.erase(0, at + 2);
        return line;
      }
      if (std::chrono::steady_clock::now() > end) {
        return "";
      }
      pollfd wanted{modem_[0], POLLIN, 0};
      ::poll(&wanted, 1, 50);
      uint8_t bytes[256];
      const int32_t count = hooks::readDescriptor(modem_[0], bytes, sizeof bytes);
      got_.append(bytes, bytes + std::max(count, 0));
    }
  }
  /// Whether the program runs.
  bool runs() { return ::waitpid(child_, nullptr, WNOHANG) == 0; }
  void closeModem() {
    ::close(modem_[0]);
    modem_[0] = -1;
  }
  /// How much time of the processor it has used, s.
  [[nodiscard]] double used() const {
    const std::string stat =
        support::readFile("/proc/" + std::to_string(child_) + "/stat").value_or("");
    unsigned long user = 0, system = 0;
    std::sscanf(stat.c_str() + stat.rfind(')') + 1,
                " %*c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %lu %lu", &user, &system);
    return static_cast<double>(user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
  }

 private:
  int vehicle_[2] = {-1, -1}, modem_[2] = {-1, -1};
  pid_t child_ = -1;
  std::string got_;
};

/// The vehicle is silent all the time.
TEST_P(TalkOnBoard, ServesTheModem) {
  const auto [name, level] = GetParam();
  auto command = commandOf(name, programOf(talking(), name, level));
  for (const char* word : {"--stdio", "--modem", "fd:3", "--address", "2", "--vehicles", "3"}) {
    command.emplace_back(word);
  }
  Started program(command);
  EXPECT_EQ(program.next(5000), "$CCCFG,SRC,2*32");
  if (std::string(name) == "host") {
    EXPECT_EQ(program.next(4000), "") << "it asks each 5 s";
    EXPECT_EQ(program.next(4000), "$CCCFG,SRC,2*32");
  }
  program.say("CACFG,SRC,2");
  program.say("CADRQ,120000,2,1,0,32,1");
  EXPECT_EQ(program.next(2000), "$CCTXD,2,1,0,*7B");
  const double before = program.used();
  program.closeModem();
  ::usleep(1'200'000);
  EXPECT_TRUE(program.runs()) << "without the modem it flies on";
  EXPECT_LT(program.used() - before, 0.3) << "and does not spin";
}

/// As on board: the modem is a serial line that the program opens by its name.
TEST_P(TalkOnBoard, ServesAModemOnASerialLine) {
  const auto [name, level] = GetParam();
  auto command = commandOf(name, programOf(talking(), name, level));
  for (const char* word :
       {"--stdio", "--modem", "/dev/fd/3", "--address", "2", "--vehicles", "3"}) {
    command.emplace_back(word);
  }
  Started program(command, true);
  EXPECT_EQ(program.next(5000), "$CCCFG,SRC,2*32");
  program.say("CACFG,SRC,2");
  program.say("CADRQ,120000,2,1,0,32,1");
  EXPECT_EQ(program.next(2000), "$CCTXD,2,1,0,*7B") << "no echo, and no line end is changed";
}

INSTANTIATE_TEST_SUITE_P(Boards, TalkOnBoard,
                         testing::Combine(testing::ValuesIn(kBoards), testing::Values(2, 3)),
                         [](const auto& param) {
                           return std::string(std::get<0>(param.param)) + "_O" +
                                  std::to_string(std::get<1>(param.param));
                         });

TEST(TalkBudget, TheStackHasABound) {
  for (const bool headings : {false, true}) {
    const Checked checked = talking(headings);
    for (const char* name : {"ts7800", "ts5500"}) {
      const platforms::Board target = board(name);
      const auto budget = codegen::measureBudget(checked.input(), target, {});
      ASSERT_TRUE(budget) << budget.error().message;
      ASSERT_TRUE(budget->stack_bytes) << name << ": " << budget->stack_bytes.error();
      EXPECT_LT(*budget->stack_bytes, target.max_stack_bytes);
      ASSERT_TRUE(budget->tick_instructions) << budget->tick_instructions.error();
    }
  }
}

/// These have a seat within the program.
TEST(TalkBudget, TheStackHasABoundWithoutHooks) {
  for (const char* vehicle : {"lauv", "remus100"}) {
    Checked checked = talking();
    auto platform =
        platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/" + std::string(vehicle) + ".toml");
    ASSERT_TRUE(platform.has_value());
    checked.platform = std::move(*platform);
    for (const char* name : {"ts7800", "ts5500"}) {
      const platforms::Board target = board(name);
      const auto budget = codegen::measureBudget(checked.input(), target, {});
      ASSERT_TRUE(budget) << budget.error().message;
      ASSERT_TRUE(budget->stack_bytes)
          << vehicle << ' ' << name << ": " << budget->stack_bytes.error();
      EXPECT_LT(*budget->stack_bytes, target.max_stack_bytes);
      RecordProperty(std::string(vehicle) + "_" + name, static_cast<int>(*budget->stack_bytes));
    }
  }
}

TEST(TalkProgram, RefusesAnAddressThatNoVehicleOfTheMissionHas) {
  const fs::path program = programOf(talkingByName(), "host", 2);
  const std::string modem = "--stdio --modem fd:77 --vehicles 5 --address ";
  EXPECT_THAT(runOn("host", program, modem + "3").second, HasSubstr("it is not open"));
  const auto [status, said] = runOn("host", program, modem + "4");
  EXPECT_EQ(status, 1);
  EXPECT_THAT(said, HasSubstr("error: no vehicle of the mission has this --address"));
}

TEST(TalkProgram, OthersHaveNoOptionOfAModem) {
  const fs::path program = programOf(figure2(), "host", 2);
  EXPECT_THAT(runOn("host", program, "--help").second, Not(HasSubstr("modem")));
  EXPECT_THAT(runOn("host", program, "--modem x").second,
              HasSubstr("cannot make sense of `--modem"));
}

}  // namespace
}  // namespace glider::codegen_tests
