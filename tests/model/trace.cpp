// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/model/trace.h"

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <sstream>
#include <utility>

namespace glider::tests {

std::vector<ModelRound> flyModel(int seed) {
  const TemporaryFolder folder;  // where spin leaves its own files
  const Outcome run =
      runShell("cd " + folder.path().string() +
               " && " GLIDER_SPIN " -DREPLAY -DFAULTS=40 -DCOMMANDS=60 -T -n" +
               std::to_string(seed) + " " GLIDER_SOURCE_DIR "/hooks/protocol/model/control.pml");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out.find("assertion violated"), std::string::npos) << run.out;
  std::vector<ModelRound> rounds;
  std::string decision;  // of the tick that is reported next
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "round") {
      rounds.emplace_back();
    } else if (word == "frame") {
      size_t direction = 0;
      ModelFrame frame;
      words >> direction >> frame.type >> frame.link >> frame.session >> frame.sequence >>
          frame.copies;
      rounds.back().frames.at(direction).push_back(frame);
    } else if (word == "record") {
      size_t direction = 0;
      words >> direction;
      rounds.back().frames.at(direction).back().recorded = true;
    } else if (word == "mission") {
      words >> word;
      rounds.back().ticks.push_back({std::exchange(decision, ""), word});
    } else if (word == "decides") {
      words >> decision;
    } else if (word == "dies") {
      rounds.back().ticks.back().dies = true;
    } else if (word == "state") {
      ModelState& state = rounds.back().state;
      words >> state.state >> state.session >> state.sequence >> state.answer;
    } else if (word == "full") {
      rounds.pop_back();  // more under way than the model looks at
      return rounds;
    } else if (word == "hold" || word == "sbc" || word == "stuck" || word == "restart" ||
               word == "replay") {
      rounds.back().after.push_back(line.substr(line.find(word)));
    }
  }
  return rounds;
}

}  // namespace glider::tests
