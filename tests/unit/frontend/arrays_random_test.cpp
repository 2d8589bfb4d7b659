// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Random programs with arrays and loops: what the compiled mission computes is compared with a
// model that runs each program as it reads, with real loops and real arrays.

#include "ir/core/mission_writer.h"
#include "ir/eval/interpreter.h"
#include "ir/text/print.h"
#include "ir/text/read.h"
#include "support/diagnostics/ids/meaning.h"
#include "tests/random_missions/random_arrays.h"
#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;

std::string missionOf(const random_missions::RandomArrays& program) {
  return "mission random_arrays\n" + program.declarations +
         "state s begin flightprofile surfaced sensors missiontime entry do\n" +
         program.statements + "end events case missiontime > 1 h exit end\n";
}

/// Each variable of the program as the mission holds it.
std::map<std::string, double> heldBy(ir::Mission mission) {
  std::map<std::string, ir::ExprId> reads;
  for (uint32_t i = 0; i < mission.variables.size(); ++i) {
    const std::string name = mission.variables[i].name;
    reads[name] = ir::MissionWriter(mission).read(ir::VariableId{i});
  }
  ir::Interpreter interpreter(mission, 0);
  interpreter.start();
  std::map<std::string, double> held;
  for (const auto& [name, id] : reads) {
    if (mission[id].type == ir::plainNumber()) {
      held[name] = interpreter.number(id);
    }
  }
  return held;
}

bool isSame(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

TEST(ArraysRandom, LoweredProgramsComputeWhatTheySay) {
  size_t changed = 0;
  size_t unknown = 0;
  size_t too_long = 0;
  for (uint64_t seed = 0; seed < 600; ++seed) {
    const auto program = random_missions::randomArrays(seed);
    const std::string text = missionOf(program);
    FrontendRun run(text);
    const auto mission = run.compile();
    if (run.says(support::diagnostics::loopTooLong)) {
      ++too_long;
      continue;
    }
    ASSERT_TRUE(mission.has_value()) << seed << "\n" << run.said() << text;
    random_missions::Memory memory = program.memory;
    program.run(memory);
    const auto held = heldBy(*mission);
    for (const auto& [name, value] : memory.numbers) {
      ASSERT_TRUE(isSame(held.at(name), value))
          << seed << " " << name << ": " << held.at(name) << " is not " << value << "\n"
          << text;
      changed += isSame(value, program.memory.numbers.at(name)) ? 0U : 1U;
    }
    for (const auto& [name, values] : memory.arrays) {
      for (size_t i = 0; i < values.size(); ++i) {
        const std::string element = fmt::format("{}[{}]", name, i);
        ASSERT_TRUE(isSame(held.at(element), values[i]))
            << seed << " " << element << ": " << held.at(element) << " is not " << values[i] << "\n"
            << text;
        changed += isSame(values[i], program.memory.arrays.at(name)[i]) ? 0U : 1U;
        unknown += std::isnan(values[i]) ? 1U : 0U;
      }
    }
  }
  EXPECT_GT(changed, 2000u);  // otherwise the programs do too little to be worth comparing
  EXPECT_GT(unknown, 200u);
  EXPECT_LT(too_long, 60u);
}

TEST(ArraysRandom, TheTextOfTheIrReadsBack) {
  for (uint64_t seed = 0; seed < 100; ++seed) {
    FrontendRun run(missionOf(random_missions::randomArrays(seed)));
    const auto mission = run.compile();
    if (run.says(support::diagnostics::loopTooLong)) {
      continue;
    }
    ASSERT_TRUE(mission.has_value()) << run.said();
    const std::string text = ir::print(*mission);
    support::SourceManager sources;
    support::DiagnosticEngine diagnostics;
    const auto read = ir::read(sources, sources.add("m.ir", text), diagnostics);
    ASSERT_TRUE(read.has_value()) << seed << support::render(diagnostics, sources, false);
    ASSERT_EQ(ir::print(*read), text) << seed;
  }
}

}  // namespace
}  // namespace glider::frontend
