// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The session of docs/debugging.md on every board: gdb shows there what the page says.

#include "tests/support/command.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <regex>
#include <sstream>
#include <string>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

namespace glider::tests {
namespace {

/// What is between three backticks with `kind` and the next three on the page.
std::string blockOf(const std::string& page, const std::string& kind) {
  const std::string opening = "```" + kind + "\n";
  const size_t begin = page.find(opening) + opening.size();
  return page.substr(begin, page.find("```", begin) - begin);
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    lines.push_back(std::regex_replace(line, std::regex(" at 0x[0-9a-f]+"), " at 0x…"));
  }
  return lines;
}

/// One that is free now.
int freePort() {
  const int handle = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  EXPECT_EQ(bind(handle, reinterpret_cast<sockaddr*>(&address), size), 0);
  EXPECT_EQ(getsockname(handle, reinterpret_cast<sockaddr*>(&address), &size), 0);
  close(handle);
  return ntohs(address.sin_port);
}

/// Each command, after a line that repeats it.
std::string scriptOf(const std::vector<std::string>& session, int port) {
  std::string script = fmt::format("target remote :{}\n", port);
  for (const std::string& line : session) {
    if (line.starts_with("(gdb) ")) {
      script += fmt::format("echo {}\\n\n{}\n", line, line.substr(6));
    }
  }
  return script + "kill\n";
}

class Debugger : public ::testing::TestWithParam<const char*> {};

TEST_P(Debugger, ShowsWhatThePageSays) {
  if (runShell("command -v gdb-multiarch").status != 0) {
    GTEST_SKIP() << "gdb-multiarch is not installed";
  }
  const std::string page = slurp(GLIDER_SOURCE_DIR "/docs/debugging.md");
  const std::vector<std::string> session = linesOf(blockOf(page, "session"));
  const int port = freePort();
  const TemporaryFolder folder;
  (void)folder.write("warm.mission", blockOf(page, "mission"));
  (void)folder.write("commands", scriptOf(session, port));
  // The program, the script and the file of what the note says to type.
  const Outcome shown = runShell(fmt::format(
      "cd {} && ($GLIDERCC sim warm.mission --board {} --debugger {} --duration 1h > flown 2>&1 &) "
      "&& for i in $(seq 400); do grep -q gdb-multiarch flown && break; sleep 0.05; done; "
      "set -- $(grep gdb-multiarch flown); timeout 60 $1 -q -batch -ex 'set pagination off' "
      "-ex 'set confirm off' $2 $3 -x commands $8",
      folder.path().string(), GetParam(), port));
  const std::vector<std::string> output = linesOf(shown.out);
  size_t at = 0;
  for (const std::string& expected : session) {
    while (at < output.size() && output[at] != expected) {
      ++at;
    }
    ASSERT_LT(at, output.size()) << "not shown: " << expected << "\n" << shown.out << shown.err;
    ++at;
  }
}

INSTANTIATE_TEST_SUITE_P(Boards, Debugger,
                         ::testing::Values("host", "ts7800", "ts5500", "pizero2", "cm4"),
                         [](const auto& board) { return std::string(board.param); });

}  // namespace
}  // namespace glider::tests
