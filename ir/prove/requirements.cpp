// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/passes.h"
#include "ir/prove/relevance.h"
#include "ir/prove/watches.h"

#include <fmt/format.h>

#include <chrono>

namespace glider::ir::prove {

void passes::requirements(Proof& proof) {
  for (const Requirement& requirement : proof.ground.mission.requirements) {
    const bool vehicle = reckonsWithDepth(requirement, proof.ground);
    std::vector<ExprId> asked;
    if (requirement.condition.valid()) asked.push_back(requirement.condition);
    const Relevance relevance = relevanceFor(proof.ground.mission, asked, vehicle);
    const Watch watch = watchFor(requirement, proof.context, proof.ground);
    const auto t = std::chrono::steady_clock::now();
    const RunsAnswer answer =
        askAboutRuns(proof.context, proof.ground, relevance, watch, 50000000);
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - t).count();
    std::string text = fmt::format("kind {}: {} {} {:.0f} ms", int(requirement.kind), int(answer.bad), answer.trouble, ms);
    if (answer.run) {
      for (const Step& s : answer.run->steps) {
        text += fmt::format("\n   {:.3f} s -> {}", s.mission_time, describe(s.after, proof.ground.mission));
        if (s.depth) text += fmt::format(" depth {:.2f}", *s.depth);
        for (size_t i = 0; i < s.readings.size(); ++i) text += fmt::format(" {}={:.4g}", proof.ground.mission.sensors[i].name, s.readings[i]);
      }
    }
    proof.findings.lines.push_back({requirement.range, text});
  }
}

}  // namespace glider::ir::prove
