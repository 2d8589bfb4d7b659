// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/spin/spin.h"

#include "ir/verify/promela.h"
#include "tests/support/command.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace glider::tests {
namespace {

/// Tells once each thing that happens to a mission: `what mission number`. The process of mission 7
/// is m7; its states are fewer than 256.
constexpr const char* kObserver = R"(
c_decl {
\#include <stdio.h>
\#include <stdlib.h>
static void tell(const char* what, const char* mission, int number) {
  static char told[128][256][256];
  char* before = &told[what[0]][atoi(mission + 1)][number];
  if (!*before) {
    printf("%s %d %d\n", what, atoi(mission + 1), number);
  }
  *before = 1;
}
}
#define REACHED(mission, state) c_code { tell("reached", #mission, state); }
#define EMPTY_RETURN(mission, state) c_code { tell("empty", #mission, P##mission->state); }
#define CALLED_TWICE(mission, state, target) c_code { tell("twice", #mission, state); }
#define CALLED(mission) c_code { tell("depth", #mission, P##mission->depth); }
)";

std::string modelOf(const std::vector<ir::Mission>& missions) {
  std::string text = kObserver + std::string(ir::promelaPrelude());
  std::string start = "\ninit {\n  if\n";
  for (size_t i = 0; i < missions.size(); ++i) {
    text += "\n" + ir::promelaProcess(missions[i], fmt::format("m{}", i), false);
    start += fmt::format("  :: run m{}()\n", i);
  }
  return text + start + "  fi\n}\n";
}

void take(const std::string& line, std::vector<SpinFindings>& findings) {
  std::istringstream words(line);
  std::string what;
  size_t mission = 0;
  uint32_t number = 0;
  if (!(words >> what >> mission >> number) || mission >= findings.size()) {
    return;
  }
  SpinFindings& of = findings[mission];
  if (what == "reached") {
    of.reached.insert(number);
  } else if (what == "empty") {
    of.empty_returns.insert(number);
  } else if (what == "depth") {
    of.depth = std::max(of.depth, number);
  }
  of.recursive |= what == "twice";
}

}  // namespace

std::vector<SpinFindings> searchWithSpin(const std::vector<ir::Mission>& missions) {
  const TemporaryFolder folder;
  const std::string model = folder.write("model.pml", modelOf(missions)).string();
  const Outcome outcome = runShell("cd " + folder.path().string() + " && spin -a " + model +
                                   " >spin.txt && gcc -w -DSAFETY -DVECTORSZ=8192 -o pan pan.c && "
                                   "./pan -m1000000 -w22 >found.txt && cat spin.txt");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  std::vector<SpinFindings> findings(missions.size());
  const std::string found = slurp(folder.path() / "found.txt");
  EXPECT_NE(found.find("errors: 0"), std::string::npos) << found;
  EXPECT_EQ(found.find("max search depth too small"), std::string::npos);
  std::istringstream lines(found);
  for (std::string line; std::getline(lines, line);) {
    take(line, findings);
  }
  return findings;
}

}  // namespace glider::tests
