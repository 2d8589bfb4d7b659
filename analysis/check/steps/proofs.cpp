// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/run.h"
#include "compiler/proving.h"
#include "ir/core/inside.h"
#include "support/one_line.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <utility>
#include <vector>

namespace glider::analysis::check {
namespace {

/// Where the mission assumes that it starts, or else where the scenario does; empty: unknown, so
/// less is checked.
std::vector<ir::Position> startsOf(const Run& run) {
  if (const auto area = ir::assumedStart(run.mission())) {
    return area->corners;
  }
  return run.scenario
             ? std::vector<ir::Position>{{run.scenario->latitude_deg, run.scenario->longitude_deg}}
             : std::vector<ir::Position>();
}

ir::prove::Options proverOptions(const Run& run) {
  const CheckOptions& options = run.options;
  ir::prove::Options how;
  how.report = options.report;
  how.evidence = options.evidence;
  how.known_starts = startsOf(run);
  how.raised = options.effort;
  how.effort *= options.effort;
  how.run_effort *= options.effort;
  how.total_effort *= options.effort;
  if (options.timeout_s > 0) {
    how.until = std::chrono::steady_clock::now() +
                std::chrono::milliseconds(static_cast<int64_t>(1000 * options.timeout_s));
  }
  return how;
}

}  // namespace

/// Runs the proofs.
support::Result<void> proofs(Run& run) {
  run.asked = proverOptions(run);
  run.observer.at("checking cases and commands");
  ir::prove::Options how = run.asked;
  how.before_requirement = [&](uint32_t number) {
    const auto& all = run.mission().requirements;
    run.observer.at(
        fmt::format("proving {} of {}: {}", number + 1, all.size(),
                    support::onOneLine(run.checked().sources().text(all[number].range))));
  };
  run.file.proved = compiler::prove(run.checked(), std::move(how), run.diagnostics());
  return {};
}

}  // namespace glider::analysis::check
