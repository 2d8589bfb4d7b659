// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/board.h"

#include "support/diagnostics/ids/files.h"
#include "support/diagnostics/ids/vehicle.h"
#include "tests/support/command.h"
#include "tests/support/replaced.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::platforms {
namespace {

const std::string kGood = R"(name = "b"
description = "d"
triple = "i486-unknown-linux-musl"
cpu = "i486"
features = "+x87"
float_abi = "hard"
relocation = "static"
clang_flags = []
system_flags = []
system_passes = []
max_executable_bytes = 65536
max_memory_bytes = 1000000
max_stack_bytes = 16384
max_tick_instructions = 2000000
[kernel]
release = "2.4.23"
system_calls = "calls"
[emulator]
command = ["qemu-i386", "-cpu", "486"]
debugger = ["qemu-i386", "-g", "{port}"]
[link]
dynamic_linker = ""
options = ["--gc-sections"]
before = ["crt1.o"]
after = ["libc.a"]
)";

support::Result<Board> load(const std::string& text) {
  const tests::TemporaryFolder folder;
  return loadBoard(folder.write("board.toml", text));
}

std::string with(const std::string& from, const std::string& to) {
  return tests::replaced(kGood, from, to);
}

TEST(Board, OursLoad) {
  for (const char* name : {"host", "ts7800", "ts5500", "pizero2", "cm4"}) {
    const auto board =
        loadBoard(fmt::format("{}/platforms/boards/{}.toml", GLIDER_SOURCE_DIR, name));
    ASSERT_TRUE(board) << board.error().message;
    EXPECT_EQ(board->name, name);
    EXPECT_EQ(board->folder, GLIDER_SOURCE_DIR "/platforms/boards");
    EXPECT_EQ(board->max_executable_bytes, board->name == "host" ? 0u : 131072u);
    EXPECT_EQ(board->relocation,
              board->name == "host" ? Relocation::PositionIndependent : Relocation::Static);
    EXPECT_EQ(board->float_abi, board->name == "ts7800" ? FloatAbi::Soft : FloatAbi::Hard);
  }
}

TEST(Board, WhatTheFileSaysIsReadOut) {
  const auto board = load(kGood);
  ASSERT_TRUE(board) << board.error().message;
  EXPECT_EQ(board->triple, "i486-unknown-linux-musl");
  EXPECT_EQ(board->kernel.release, "2.4.23");
  EXPECT_THAT(board->emulator, testing::ElementsAre("qemu-i386", "-cpu", "486"));
  EXPECT_THAT(board->link.options, testing::ElementsAre("--gc-sections"));
  EXPECT_THAT(board->link.before, testing::ElementsAre("crt1.o"));
  EXPECT_THAT(board->link.after, testing::ElementsAre("libc.a"));
}

TEST(Board, MaySleep) {
  const std::string power = "[power]\nrunning_W = 1.5\nspread = 0.2\nsource = \"x\"\n";
  const auto of = [&](const std::string& more) {
    return load(with("[link]", power + more + "[link]"));
  };
  const auto awake = of("");
  ASSERT_TRUE(awake && awake->power);
  EXPECT_FALSE(awake->power->sleep);
  const auto sleeps = of("asleep_W = 0.25\nwake_s = 2\n");
  ASSERT_TRUE(sleeps && sleeps->power && sleeps->power->sleep);
  EXPECT_EQ(sleeps->power->sleep->asleep_W, 0.25);
  EXPECT_EQ(sleeps->power->sleep->wake_s, 2);
  EXPECT_TRUE(of("asleep_W = 1.5\nwake_s = 10\n"));
  for (const char* wrong : {"asleep_W = 0.25\n", "wake_s = 2\n", "asleep_W = 1.6\nwake_s = 2\n",
                            "asleep_W = -1\nwake_s = 2\n", "asleep_W = 0.25\nwake_s = 10.5\n"}) {
    EXPECT_FALSE(of(wrong)) << wrong;
  }
}

// accepts: GL5001; refused: GL5001
TEST(Board, ErrorsAreReportedWithTheirLine) {
  const std::pair<std::string, std::string> bad[] = {
      {with("cpu = \"i486\"", "cpu = 486"), ":4"},
      {with("cpu = \"i486\"", "cpus = \"i486\""), ":4"},
      {with("float_abi = \"hard\"", "float_abi = \"medium\""), ":6"},
      {with("relocation = \"static\"", "relocation = \"\""), ":7"},
      {with("clang_flags = []", "clang_flags = [1]"), ":8"},
      {with("system_flags = []", "system_flags = \"-mthumb\""), ":9"},
      {with("system_passes = []", "system_passes = 1"), ":10"},
      {with("65536", "-1"), ":11"},
      {with("65536", "64.5"), ":11"},
      {with("release = \"2.4.23\"", "release = 2"), ":16"},
      {with("\"calls\"", "\"../calls\""), ":17"},
      {with("[\"qemu-i386\", \"-cpu\", \"486\"]", "\"qemu-i386\""), ":19"},
      {with("[\"qemu-i386\", \"-g\", \"{port}\"]", "3"), ":20"},
      {with("[\"crt1.o\"]", "[\"/etc/crt1.o\"]"), ":24"},
      {with("[\"libc.a\"]", "[\"--script=x\"]"), ":25"},
      {with("[\"--gc-sections\"]", "[\"-T\", \"script\"]"), ":23"},
      {with("[\"--gc-sections\"]", "[\"--a,--b\"]"), ":23"},
      {with("[\"--gc-sections\"]", "\"\""), ":23"},
      {with("[link]", "[linking]"), ":21"},
      {kGood + "[more]\n", ":26"},
      {"kernel = 3\n" + with("[kernel]", "[kernels]"), ""},
      {"not toml", ":1"},
      {"", ""},
  };
  for (const auto& [text, line] : bad) {
    const auto board = load(text);
    ASSERT_FALSE(board) << text;
    EXPECT_EQ(board.error().id, support::diagnostics::badDataFile);
    EXPECT_THAT(board.error().message, testing::HasSubstr("board.toml" + line));
  }
}

TEST(Board, AMissingFileIsNamed) {
  const auto board = loadBoard("/nonexistent/board.toml");
  ASSERT_FALSE(board);
  EXPECT_EQ(board.error().id, support::diagnostics::cannotRead);
}

}  // namespace
}  // namespace glider::platforms
