// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// verify_bench FILE.ir... - for each mission: its states, the errors and warnings found, the
// greatest depth of its call stack, and the least processor time of ir::verify, in ms. Reading the
// file is not measured.

#include "ir/text/read.h"
#include "ir/verify/verify.h"
#include "support/diagnostics/render.h"
#include "support/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <limits>
#include <optional>

namespace glider {
namespace {

using Clock = std::chrono::steady_clock;

std::optional<ir::Mission> missionAt(const char* path) {
  const auto text = support::readFile(path);
  if (!text) {
    fmt::print(stderr, "{}: cannot be read\n", path);
    return std::nullopt;
  }
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  auto mission = ir::read(sources, sources.add(path, *text), diagnostics);
  fmt::print(stderr, "{}", support::render(diagnostics, sources, false));
  return mission;
}

/// A busy machine changes this less than elapsed time.
double processorTime_s() {
  timespec now = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Processor time of ir::verify, s: of so many runs that a clock that ticks coarsely does not show.
double secondsOf(const ir::Mission& mission, ir::MissionFacts& facts,
                 support::DiagnosticEngine& diagnostics) {
  constexpr double kEnough_s = 0.02;
  for (int runs = 1;; runs *= 2) {
    const double from = processorTime_s();
    for (int run = 0; run < runs; ++run) {
      diagnostics = support::DiagnosticEngine();
      facts = ir::verify(mission, diagnostics);
    }
    if (const double passed = processorTime_s() - from; passed > kEnough_s) {
      return passed / runs;
    }
  }
}

/// Runs for about a second, at least three times.
void measure(const ir::Mission& mission) {
  constexpr int kLeastRuns = 3;
  constexpr double kEnough_s = 1;
  double least_s = std::numeric_limits<double>::infinity();
  const auto begin = Clock::now();
  for (int run = 0;; ++run) {
    support::DiagnosticEngine diagnostics;
    ir::MissionFacts facts;
    least_s = std::min(least_s, secondsOf(mission, facts, diagnostics));
    const std::chrono::duration<double> passed = Clock::now() - begin;
    if (run + 1 >= kLeastRuns && passed.count() > kEnough_s) {
      fmt::print("{} {} {} {} {:.6f}\n", mission.states.size(), diagnostics.errorCount(),
                 diagnostics.warningCount(), facts.stack_depth, 1e3 * least_s);
      return;
    }
  }
}

}  // namespace
}  // namespace glider

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const auto mission = glider::missionAt(argv[i]);
    if (!mission) {
      return 1;
    }
    glider::measure(*mission);
  }
  return 0;
}
