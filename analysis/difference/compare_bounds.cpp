// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/difference/compare_bounds.h"

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/context/proof_context.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace glider::analysis {
namespace {

using ir::prove::durationOf;

constexpr const char* kNone = "no bound is known";

std::string endOf(const compiler::Checked& checked) {
  const ir::prove::ProofContext context(checked.mission(), checked.platform());
  const auto end = ir::prove::boundOf(context.withoutPowerCuts(), ir::prove::kLongestMission,
                                      ir::prove::Goal::Exit);
  return end.by ? durationOf(*end.by) : kNone;
}

std::string deepestOf(const compiler::Checked& checked) {
  const ir::prove::ProofContext context(checked.mission(), checked.platform());
  const double deepest = std::ranges::max(ir::prove::deepestByState(context));
  return std::isfinite(deepest) ? fmt::format("{:.4g} m", deepest) : kNone;
}

std::string stackOf(const compiler::Checked& checked) {
  return fmt::format("{}", checked.facts.stack_depth);
}

}  // namespace

std::vector<std::string> compareBounds(const compiler::Checked& before,
                                       const compiler::Checked& after) {
  std::vector<std::string> lines;
  for (const auto& [what, of] : {std::pair("the mission ends after at most", &endOf),
                                 std::pair("commands lead at most this deep", &deepestOf),
                                 std::pair("greatest call depth", &stackOf)}) {
    const std::string was = of(before);
    const std::string is = of(after);
    if (was != is) {
      lines.push_back(fmt::format("{}: {} → {}", what, was, is));
    }
  }
  return lines;
}

}  // namespace glider::analysis
