// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// verify_bench FILE.ir... - for each mission: its states, the errors and warnings found, the
// greatest depth of its call stack, and the least time that ir::verify took, in ms. Reading the
// file is not measured.

#include "ir/text/read.h"
#include "ir/verify/verify.h"
#include "support/diagnostics/render.h"
#include "support/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
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

/// Runs for about a second, at least three times.
void measure(const ir::Mission& mission) {
  constexpr int kLeastRuns = 3;
  constexpr double kEnough_s = 1;
  double least_s = std::numeric_limits<double>::infinity();
  const auto begin = Clock::now();
  for (int run = 0;; ++run) {
    support::DiagnosticEngine diagnostics;
    const auto from = Clock::now();
    const ir::MissionFacts facts = ir::verify(mission, diagnostics);
    const auto now = Clock::now();
    least_s = std::min(least_s, std::chrono::duration<double>(now - from).count());
    if (run + 1 >= kLeastRuns && std::chrono::duration<double>(now - begin).count() > kEnough_s) {
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
