// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/certify/judge.h"

#include "tests/support/command.h"
#include "tests/unit/frontend/compile.h"
#include "tests/unit/ir/slocum.h"

#include <set>
#include <sstream>

namespace glider::ir::certify {

bool haveCvc5() {
  static const bool there = tests::runShell("cvc5 --version").status == 0;
  return there;
}

std::vector<std::string> answersTo(const std::string& script) {
  const tests::TemporaryFolder folder;
  const auto file = folder.write("script.smt2", script);
  std::istringstream out(tests::runShell("cvc5 --lang smt2 --incremental " + file.string()).out);
  std::vector<std::string> answers;
  for (std::string line; std::getline(out, line);) {
    if (line.starts_with("(error")) {
      return {line};
    }
    answers.push_back(line);
  }
  return answers;
}

std::vector<std::string> refused(const std::vector<Script>& scripts) {
  std::vector<std::string> refused;
  for (const Script& script : scripts) {
    const std::vector<std::string> answers = answersTo(script.text);
    for (size_t i = 0; i < script.obligations.size(); ++i) {
      if (i >= answers.size() || answers[i] != "unsat") {
        refused.push_back(script.obligations[i] + ": " +
                          (i < answers.size() ? answers[i] : "no answer"));
      }
    }
  }
  return refused;
}

Mission compiled(const std::string& text) {
  frontend::testing_support::FrontendRun run(text);
  auto mission = run.compile();
  EXPECT_TRUE(mission.has_value()) << run.said();
  return mission.value_or(Mission());
}

std::vector<Configuration> configurationsOf(const Mission& mission) {
  const Facts facts = factsOf(mission);
  const Setting setting{mission, slocum(), mission.requirements.at(0), facts};
  std::set<Configuration> found;
  std::vector<Configuration> all;
  const auto add = [&](const Step& step) {
    for (const Ending& e : step.endings) {
      if (e.to && found.insert(*e.to).second) {
        all.push_back(*e.to);
      }
    }
  };
  add(startOf(setting));
  for (size_t i = 0; i < all.size(); ++i) {
    add(stepOf(setting, all[i], longestGap(mission, slocum())));
  }
  return all;
}

std::vector<Invariant> invariantsOf(const Mission& mission, const Formula& formula) {
  std::vector<Invariant> invariants;
  for (const Configuration& at : configurationsOf(mission)) {
    if (std::string text = formula(wordsOf(mission, at)); !text.empty()) {
      invariants.push_back({at, std::move(text)});
    }
  }
  return invariants;
}

std::vector<std::string> judged(const Mission& mission, const Formula& formula) {
  return refused(obligationsOf(mission, slocum(), mission.requirements.at(0),
                               invariantsOf(mission, formula), longestGap(mission, slocum())));
}

}  // namespace glider::ir::certify
