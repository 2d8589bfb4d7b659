// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The passes of ir/opt, each alone and all together, change nothing that a mission does.

#include "ir/core/validate.h"
#include "ir/opt/optimise.h"
#include "ir/opt/passes.h"
#include "ir/verify/verify.h"
#include "tests/random_missions/random_mission.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>

namespace glider::random_missions {
namespace {

constexpr uint64_t kOptimisedMissions = 120;
constexpr size_t kOptimisedTicks = 120;

std::string bits(double value) {
  return fmt::format("{:x}", std::bit_cast<uint64_t>(value));
}

std::string numbers(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) {
    text += " " + bits(value);
  }
  return text;
}

std::string actionText(const ir::Mission& mission, const ir::Action& action) {
  if (const auto* command = std::get_if<ir::CommandRun>(&action)) {
    return fmt::format("command {}{}{}\n", static_cast<int>(command->command),
                       command->refused ? " refused" : "", numbers(command->arguments));
  }
  const auto& run = std::get<ir::ActivityRun>(action);
  return fmt::format("{} {}{}\n", mission[run.behaviour].name, static_cast<int>(run.phase),
                     numbers(run.arguments));
}

/// All that a tick did, states by their names, for their numbers may differ.
std::string story(const ir::Mission& mission, const ir::TickResult& tick) {
  std::string text = fmt::format("{} {} {}", mission[tick.state].name, tick.finished, tick.limit);
  for (const auto& fired : tick.fired) {
    text += fmt::format(" {}", fired ? static_cast<int>(*fired) : -1);
  }
  for (const ir::Frame& frame : tick.stack) {
    text +=
        fmt::format(" on {} {} {}", mission[frame.state].name, bits(frame.entered), frame.limit);
  }
  text += "\n";
  for (const ir::Action& action : tick.actions) {
    text += actionText(mission, action);
  }
  for (const ir::Note& note : tick.notes) {
    text += note.text + numbers(note.values) + "\n";
  }
  return text + fmt::format("lost {}\n", tick.lost_notes);
}

std::map<std::string, std::string> variablesOf(const ir::Mission& mission,
                                               const ir::TickResult& tick) {
  std::map<std::string, std::string> values;
  for (size_t i = 0; i < mission.variables.size(); ++i) {
    values[mission.variables[i].name] = bits(tick.variables[i]);
  }
  return values;
}

ir::MissionFacts factsOf(const ir::Mission& mission) {
  support::DiagnosticEngine diagnostics;
  return ir::verify(mission, diagnostics);
}

void compare(uint64_t seed, const ir::Mission& plain, const ir::Mission& optimised) {
  ASSERT_TRUE(ir::validate(optimised).empty()) << ir::validate(optimised).front().message;
  ir::Interpreter before(plain, factsOf(plain).stack_depth, randomExternals());
  ir::Interpreter after(optimised, factsOf(optimised).stack_depth, randomExternals());
  const auto stream = randomStream(plain, seed, kOptimisedTicks);
  const auto parameters = randomParameters(plain, seed);
  for (size_t i = 0; i < stream.size(); ++i) {
    const auto& [time, frame] = stream[i];
    const ir::TickResult a = i == 0 ? before.start(frame, parameters) : before.tick(time, frame);
    const ir::TickResult b = i == 0 ? after.start(frame, parameters) : after.tick(time, frame);
    ASSERT_EQ(story(plain, a), story(optimised, b)) << "tick " << i;
    const auto all = variablesOf(plain, a);
    for (const auto& [name, value] : variablesOf(optimised, b)) {
      ASSERT_EQ(value, all.at(name)) << name << " at tick " << i;
    }
    if (a.finished) {
      return;
    }
  }
}

class Optimised : public testing::TestWithParam<const ir::OptPass*> {};

TEST_P(Optimised, DoesTheSame) {
  size_t smaller = 0;
  for (uint64_t seed = 1; seed <= kOptimisedMissions; ++seed) {
    SCOPED_TRACE(seed);
    const ir::Mission plain = flownMission(seed);
    ir::Mission optimised = plain;
    if (GetParam() == nullptr) {
      optimised = ir::optimise(plain);
    } else {
      GetParam()->run(optimised);
    }
    smaller += optimised.exprs.size() < plain.exprs.size();
    compare(seed, plain, optimised);
    if (HasFatalFailure()) {
      return;
    }
  }
  if (GetParam() == nullptr) {
    EXPECT_GT(smaller, kOptimisedMissions / 2) << "the passes find nothing to do";
  }
}

/// With a twin of everything that is watched over time, which every other use reads instead.
ir::Mission withTwins(ir::Mission mission) {
  std::vector<ir::Temporal> pairs;
  for (const ir::Temporal& temporal : mission.temporals) {
    pairs.insert(pairs.end(), 2, temporal);
  }
  mission.temporals = std::move(pairs);
  uint32_t twin = 0;
  for (ir::Expr& expr : mission.exprs) {
    if (expr.temporal.valid()) {
      expr.temporal.index = 2 * expr.temporal.index + twin;
      twin = 1 - twin;
    }
  }
  return mission;
}

TEST(Sharing, OfTwoThatWatchTheSameOneIsLeft) {
  size_t windows = 0;
  for (uint64_t seed = 1; seed <= kOptimisedMissions; ++seed) {
    SCOPED_TRACE(seed);
    const ir::Mission plain = flownMission(seed);
    const ir::Mission doubled = withTwins(plain);
    ASSERT_TRUE(ir::validate(doubled).empty()) << ir::validate(doubled).front().message;
    ir::Mission shared = doubled;
    ir::opt::shareExpressions(shared);
    ir::Mission best = plain;
    ir::opt::shareExpressions(best);
    EXPECT_EQ(shared.temporals.size(), best.temporals.size());
    windows += shared.temporals.size();
    compare(seed, doubled, shared);
    if (HasFatalFailure()) {
      return;
    }
  }
  EXPECT_GT(windows, kOptimisedMissions) << "the missions watch too little";
}

std::vector<const ir::OptPass*> eachAndAll() {
  std::vector<const ir::OptPass*> passes = {nullptr};
  for (const ir::OptPass& pass : ir::optPasses()) {
    passes.push_back(&pass);
  }
  return passes;
}

INSTANTIATE_TEST_SUITE_P(Passes, Optimised, testing::ValuesIn(eachAndAll()),
                         [](const auto& tested) {
                           std::string name(tested.param == nullptr ? "all" : tested.param->name);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace glider::random_missions
