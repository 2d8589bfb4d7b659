// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a program on a board is started with: its command line, its parameters, its port.

#include "hooks/protocol/crc.h"
#include "hooks/transport/host/pty.h"
#include "runtime/board/checkpoints.h"
#include "runtime/board/files.h"
#include "runtime/board/line.h"
#include "runtime/board/parameters.h"
#include "tests/unit/runtime/bench_mission.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <elf.h>
#include <errno.h>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <limits>
#include <link.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace glider::runtime::testing {
namespace {

using ::testing::HasSubstr;
using Wish = Options::Wish;

Options optionsOf(std::vector<std::string> words) {
  static std::vector<std::string> kept;  // the options point into it
  kept = std::move(words);
  kept.insert(kept.begin(), "program");
  std::vector<char*> arguments;
  for (std::string& word : kept) {
    arguments.push_back(word.data());
  }
  const int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  return readOptions(count, arguments.data());
}

/// What `what` says on standard error.
template <typename What>
std::string said(What what) {
  ::testing::internal::CaptureStderr();
  what();
  return ::testing::internal::GetCapturedStderr();
}

TEST(Options, HaveDefaults) {
  const Options none = optionsOf({});
  EXPECT_EQ(none.wish, Wish::Fly);
  EXPECT_EQ(none.port, nullptr);
  EXPECT_EQ(none.baud, 115200U);
  EXPECT_FALSE(none.stdio);
  EXPECT_EQ(none.log, nullptr);
  EXPECT_EQ(none.log_limit, 33554432U);
  EXPECT_EQ(none.checkpoints, nullptr);
  EXPECT_EQ(none.parameters, nullptr);
  EXPECT_EQ(none.setting_count, 0U);
}

TEST(Options, AreTakenInAnyOrder) {
  const Options all =
      optionsOf({"--set", "a=1", "--port", "P", "--baud", "9600", "--log", "L", "--log-limit",
                 "4096", "--stdio", "--checkpoint", "C", "--parameters", "F", "--set", "b=2"});
  EXPECT_EQ(all.wish, Wish::Fly);
  EXPECT_STREQ(all.port, "P");
  EXPECT_EQ(all.baud, 9600U);
  EXPECT_STREQ(all.log, "L");
  EXPECT_EQ(all.log_limit, 4096U);
  EXPECT_TRUE(all.stdio);
  EXPECT_STREQ(all.checkpoints, "C");
  EXPECT_STREQ(all.parameters, "F");
  ASSERT_EQ(all.setting_count, 2U);
  EXPECT_STREQ(all.settings[0], "a=1");
  EXPECT_STREQ(all.settings[1], "b=2");
}

TEST(Options, SettingsAreReported) {
  EXPECT_EQ(optionsOf({"--help"}).wish, Wish::Help);
  EXPECT_EQ(optionsOf({"-h"}).wish, Wish::Help);
  EXPECT_EQ(optionsOf({"--version"}).wish, Wish::Version);
  const Options help = optionsOf({"--help"});
  const Options version = optionsOf({"--version"});
  int status = -1;
  EXPECT_THAT(said([&] { status = tellWish(help, "m"); }), HasSubstr("--checkpoint FILE"));
  EXPECT_EQ(status, kDone);
  EXPECT_EQ(said([&] { status = tellWish(version, "m"); }),
            "mission m, glidercc runtime, ABI " + std::to_string(GLIDER_ABI_VERSION) + "\n");
  EXPECT_EQ(status, kDone);
}

TEST(Options, WhatIsWrongIsNamed) {
  const std::pair<std::vector<std::string>, const char*> table[] = {
      {{"x", "y"}, "x"},
      {{"--stdio", "--mute", "y"}, "--mute y"},
      {{"--port"}, "--port"},
      {{"--baud", "0"}, "--baud 0"},
      {{"--baud", ""}, "--baud "},
      {{"--baud", "96x"}, "--baud 96x"},
      {{"--baud", "96/"}, "--baud 96/"},
      {{"--baud", "96:"}, "--baud 96:"},
      {{"--baud", "4000000010"}, "--baud 4000000010"},
      {{"--log-limit", "4095"}, "--log-limit 4095"},
      {{"--log-limit", "many"}, "--log-limit many"}};
  for (const auto& [words, wrong] : table) {
    const Options options = optionsOf(words);
    EXPECT_EQ(options.wish, Wish::Wrong) << wrong;
    int status = -1;
    std::string expected = std::string("error: cannot make sense of `") + wrong;
    if (expected.back() == ' ') {
      expected.pop_back();  // an empty value is not told
    }
    EXPECT_EQ(said([&] { status = tellWish(options, "m"); }), expected + "`; see --help\n");
    EXPECT_EQ(status, kWrongUse);
  }
  EXPECT_EQ(optionsOf({"--baud", "4000000009"}).baud, 4000000009U) << "the greatest number";
}

TEST(Options, ThereAreAsManySettingsAsParameters) {
  std::vector<std::string> words;
  for (uint32_t i = 0; i < GLIDER_MOST_PARAMETERS; ++i) {
    words.insert(words.end(), {"--set", "a=1"});
  }
  EXPECT_EQ(optionsOf(words).setting_count, GLIDER_MOST_PARAMETERS);
  words.insert(words.end(), {"--set", "b=1"});
  const Options more = optionsOf(words);
  EXPECT_EQ(more.wish, Wish::Wrong);
  EXPECT_STREQ(more.wrong_value, "b=1");
}

TEST(Options, TwoThingsAreNotWrittenIntoOneFile) {
  const auto apart = [](const std::vector<std::string>& words) {
    const Options options = optionsOf(words);
    bool good = false;
    const std::string words_said = said([&] { good = areFilesApart(options); });
    EXPECT_EQ(words_said, good ? "" : "error: --log and --checkpoint name the same file `f`\n");
    return good;
  };
  EXPECT_TRUE(apart({}));
  EXPECT_TRUE(apart({"--log", "f"}));
  EXPECT_TRUE(apart({"--checkpoint", "f"}));
  EXPECT_TRUE(apart({"--log", "f", "--checkpoint", "g"}));
  EXPECT_FALSE(apart({"--log", "f", "--checkpoint", "f"}));
}

class Folder : public ::testing::Test {
 protected:
  Folder() {
    char name[] = "/tmp/glider-start-XXXXXX";
    folder_ = mkdtemp(name);
  }
  ~Folder() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string file(const std::string& content) const {
    std::ofstream(folder_ + "/file") << content;
    return folder_ + "/file";
  }
  std::string folder_;
};

class Parameters : public Folder {
 protected:
  Parameters() {
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    constexpr const char* kLength = "m=3ff0000000000000 km=408f400000000000";
    bench_.states = {benchState("a")};
    bench_.parameters = {
        {"a_long_name_of_a_depth", 25.5, 10, 30, kLength},
        {"top", 5, 1, kEndless, kLength},
        {"low", 5, -kEndless, 9, kLength},
        {"deep", 0, 0, 1, "bool"},
        {"gain", 0.5, -kEndless, kEndless, "=3ff0000000000000"},
        {"home.latitude", 39.175, -90, 90, "N=3ff0000000000000 S=bff0000000000000"},
        {"home.longitude", -73.83, -180, 180, "E=3ff0000000000000 W=bff0000000000000"}};
    bench_.condition = [](const GliderContext& c) {
      return c.variables[0] > c.variables[1] ? GLIDER_NO_CASE : 0U;
    };
    bench_.finish(0);
  }
  /// What is said of the options; empty if they are good.
  std::string set(const std::vector<std::string>& words, Launch& launch) {
    const Options options = optionsOf(words);
    EXPECT_EQ(options.wish, Wish::Fly);
    bool good = false;
    std::string error = said([&] { good = setParameters(options, launch); });
    EXPECT_EQ(good, error.empty());
    return error;
  }
  BenchMission bench_;
};

TEST_F(Parameters, AreListedWithTheirRanges) {
  EXPECT_EQ(said([&] { tellParameters(bench_.mission); }),
            "parameters:\n"
            "  a_long_name_of_a_depth = 25.5 m, 10 m to 30 m\n"
            "  top = 5 m, at least 1 m\n"
            "  low = 5 m, at most 9 m\n"
            "  deep = false\n"
            "  gain = 0.5\n"
            "  home = 39.175 N 73.83 W\n");
}

TEST_F(Parameters, OfALongNameAreListedUpToTheEndOfALine) {
  const std::string name(200, 'x');
  bench_.parameters[0].name = name.c_str();
  bench_.finish(0);
  const std::string told = said([&] { tellParameters(bench_.mission); });
  EXPECT_EQ(told.find('\n', 12), 12 + 119 - std::string("parameters:\n").size());
}

TEST_F(Parameters, TheCommandLineGoesBeforeTheFile) {
  Launch launch(bench_.mission);
  const std::string path = file("top = 2 m\ngain = 3\n");
  EXPECT_EQ(set({"--set", "gain=4", "--parameters", path, "--set", "gain=5"}, launch), "");
  EXPECT_EQ(launch.values()[1], 2);
  EXPECT_EQ(launch.values()[4], 5);
}

TEST_F(Parameters, WhatIsWrongIsSaid) {
  Launch launch(bench_.mission);
  EXPECT_EQ(set({"--parameters", folder_ + "/none"}, launch),
            "error: cannot read the parameters `" + folder_ + "/none`: there is no such file\n");
  EXPECT_EQ(set({"--parameters", folder_}, launch),
            "error: cannot read the parameters `" + folder_ + "`: it cannot be read\n");
  const std::string path = file("top = 0\n");
  EXPECT_EQ(set({"--parameters", path}, launch),
            "error: " + path + ":1: `top` cannot be `0`: outside its range, at least 1 m\n");
  EXPECT_EQ(set({"--set", "top=0"}, launch),
            "error: `top` cannot be `0`: outside its range, at least 1 m\n");
  EXPECT_EQ(set({"--set", "top=26"}, launch),
            "error: the parameters do not satisfy `where` number 1\n");
}

TEST_F(Folder, AFileIsReadWhole) {
  char bytes[8] = {};
  uint32_t size = 99;
  EXPECT_EQ(readFile(file("").c_str(), bytes, 8, size), nullptr);
  EXPECT_EQ(size, 0U);
  EXPECT_EQ(readFile(file("seven b").c_str(), bytes, 8, size), nullptr);
  EXPECT_EQ(std::string(bytes, size), "seven b");
  EXPECT_STREQ(readFile(file("eight by").c_str(), bytes, 8, size), "it is too long");
  EXPECT_STREQ(readFile(file("more than eight").c_str(), bytes, 8, size), "it is too long");
  EXPECT_STREQ(readFile("", bytes, 8, size), "there is no such file");
  EXPECT_STREQ(readFile((file("") + "/x").c_str(), bytes, 8, size), "it cannot be opened");
}

TEST_F(Folder, AFileMayComeInPieces) {
  const std::string path = folder_ + "/pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  std::thread writer([&] {
    const int end = open(path.c_str(), O_WRONLY);
    (void)!write(end, "one ", 4);
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    (void)!write(end, "two", 3);
    close(end);
  });
  char bytes[100] = {};
  uint32_t size = 0;
  EXPECT_EQ(readFile(path.c_str(), bytes, sizeof bytes, size), nullptr);
  writer.join();
  EXPECT_EQ(std::string(bytes, size), "one two");
}

TEST_F(Folder, ReadingAFileLeavesNothingOpen) {
  const auto next = [] {
    const int descriptor = dup(STDERR_FILENO);
    close(descriptor);
    return descriptor;
  };
  const int before = next();
  char bytes[8];
  uint32_t size = 0;
  EXPECT_EQ(readFile(file("x").c_str(), bytes, 8, size), nullptr);
  EXPECT_NE(readFile(file("123456789").c_str(), bytes, 8, size), nullptr);
  EXPECT_NE(readFile(folder_.c_str(), bytes, 8, size), nullptr);
  EXPECT_EQ(next(), before);
}

/// Does `what` in a process of its own, whose exit status is 0 if it is true.
template <typename What>
bool alone(What what) {
  const pid_t child = fork();
  if (child == 0) {
    _exit(what() ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(StandardFiles, AreAStreamThatNeverBlocks) {
  int in[2];
  int out[2];
  ASSERT_TRUE(pipe(in) == 0 && pipe(out) == 0);
  EXPECT_TRUE(alone([&] {
    alarm(10);
    dup2(in[0], 0);
    dup2(out[1], 1);
    Options options;
    options.stdio = true;
    const OpenPort port = openLine(options);
    uint8_t bytes[4] = {};
    const GliderByteStream& stream = port.stream;
    const bool empty = stream.read(stream.self, bytes, 4) == 0;
    (void)!write(in[1], "ab", 2);
    const bool two = stream.read(stream.self, bytes, 4) == 2 && bytes[0] == 'a';
    const bool written = stream.write(stream.self, bytes, 2) == 2;
    for (int i = 0; i < 1000000 && stream.write(stream.self, bytes, 4) > 0; ++i) {
    }
    return empty && two && written && port.descriptor == 0 && port.problem == nullptr &&
           stream.write(stream.self, bytes, 4) == 0;
  }));
  char got[2];
  EXPECT_EQ(read(out[0], got, 2), 2);
  EXPECT_EQ(std::string(got, 2), "ab");
  for (const int end : {in[0], in[1], out[0], out[1]}) {
    close(end);
  }
}

TEST_F(Folder, TheBoardSleepsByAFile) {
  Options options;
  sleepBoard(options);  // it stays on
  const std::string state = file("");
  options.sleep = state.c_str();
  sleepBoard(options);
  std::ifstream in(state);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "mem\n");
  options.sleep = "/nowhere/state";
  ::testing::internal::CaptureStderr();
  sleepBoard(options);
  sleepBoard(options);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "warning: cannot sleep by `/nowhere/state`\n")
      << "once";
}

TEST(Line, IsWaitedForUntilAByteComes) {
  int line[2];
  ASSERT_EQ(pipe(line), 0);
  const auto seconds = [&] {
    const auto began = std::chrono::steady_clock::now();
    waitForLine(line[0]);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  };
  const double silent = seconds();
  EXPECT_GE(silent, 0.9);
  EXPECT_LT(silent, 1.9);
  (void)!write(line[1], "x", 1);
  EXPECT_LT(seconds(), 0.5);
  close(line[0]);
  close(line[1]);
}

TEST(Line, SaysWhyAPortCannotBeOpened) {
  const std::pair<int, const char*> table[] = {
      {ENOENT, "there is no such device"},     {ENXIO, "there is no such device"},
      {ENODEV, "there is no such device"},     {EACCES, "no permission to open it"},
      {EPERM, "no permission to open it"},     {EBUSY, "another program has it"},
      {ENOTTY, "it is not a serial port"},     {EISDIR, "it is not a serial port"},
      {EINVAL, "it cannot run at that speed"}, {EIO, "the device failed"}};
  for (const auto& [error, words] : table) {
    EXPECT_STREQ(portProblem(error), words);
  }
  const auto refused = [](const std::vector<std::string>& words) {
    const Options options = optionsOf(words);
    OpenPort port;
    std::string error = said([&] { port = openLine(options); });
    EXPECT_EQ(port.descriptor, -1);
    EXPECT_NE(port.problem, nullptr);
    return error;
  };
  EXPECT_EQ(refused({"--port", "/nowhere"}),
            "error: cannot open `/nowhere`: there is no such device\n");
  EXPECT_EQ(refused({"--port", "/dev/null"}),
            "error: cannot open `/dev/null`: it is not a serial port\n");
  EXPECT_EQ(refused({"--port", "/tmp"}), "error: cannot open `/tmp`: it is not a serial port\n");
  EXPECT_THAT(refused({"--port", ""}), HasSubstr("there is no such device"));
}

TEST_F(Folder, ALinkToATerminalIsThatTerminal) {
  auto pty = hooks::Pty::open();
  ASSERT_TRUE(pty.has_value());
  const std::string link = folder_ + "/port";
  std::filesystem::create_symlink(pty->name(), link);
  const OpenPort port = openPort(link.c_str(), 115200);
  ASSERT_EQ(port.problem, nullptr) << port.problem;
  EXPECT_TRUE(isatty(port.descriptor));
  const auto* word = reinterpret_cast<const uint8_t*>("word");
  EXPECT_EQ(port.stream.write(port.stream.self, word, 4), 4);
  uint8_t got[4] = {};
  const GliderByteStream far = pty->stream();
  EXPECT_EQ(far.read(far.self, got, 4), 4);
  EXPECT_EQ(got[3], 'd');
}

TEST(Program, NumberIsThatOfItsCodeAndConstants) {
  std::ifstream in("/proc/self/exe", std::ios::binary);
  const std::string image{std::istreambuf_iterator<char>(in), {}};
  ElfW(Ehdr) head;
  memcpy(&head, image.data(), sizeof head);
  uint32_t expected = 0;
  size_t bytes = 0;
  for (uint32_t i = 0; i < head.e_phnum; ++i) {
    ElfW(Phdr) segment;
    memcpy(&segment, image.data() + head.e_phoff + i * sizeof segment, sizeof segment);
    if (segment.p_type == PT_LOAD && (segment.p_flags & PF_W) == 0) {
      const auto* from = reinterpret_cast<const uint8_t*>(image.data() + segment.p_offset);
      expected = hooks::crc32c(from, static_cast<uint32_t>(segment.p_filesz), expected);
      bytes += segment.p_filesz;
    }
  }
  EXPECT_GT(bytes, 100000U);
  EXPECT_EQ(programNumber(), expected);
}

}  // namespace
}  // namespace glider::runtime::testing
