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

namespace glider::analysis {
namespace {

using ir::prove::durationOf;

constexpr const char* kNone = "no bound is known";

std::string endOf(const ir::WrittenWorld& world) {
  const ir::prove::ProofContext context(world);
  const auto end = ir::prove::boundOf(context.withoutPowerCuts(), ir::prove::kLongestMission,
                                      ir::prove::Goal::Exit);
  return end.by ? durationOf(*end.by) : kNone;
}

std::string deepestOf(const ir::WrittenWorld& world) {
  const double deepest =
      std::ranges::max(ir::prove::deepestByState(ir::prove::ProofContext(world)));
  return std::isfinite(deepest) ? fmt::format("{:.4g} m", deepest) : kNone;
}

/// "the mission ends after at most: 1 h → 2 h", if they differ.
void compare(const char* what, const std::string& before, const std::string& after,
             std::vector<std::string>& lines) {
  if (before != after) {
    lines.push_back(fmt::format("{}: {} → {}", what, before, after));
  }
}

}  // namespace

std::vector<std::string> compareBounds(const compiler::Checked& before,
                                       const compiler::Checked& after) {
  std::vector<std::string> lines;
  const ir::WrittenWorld& was = before.worlds.written;
  const ir::WrittenWorld& is = after.worlds.written;
  compare("the mission ends after at most", endOf(was), endOf(is), lines);
  compare("commands lead at most this deep", deepestOf(was), deepestOf(is), lines);
  compare("greatest call depth", fmt::format("{}", before.facts.stack_depth),
          fmt::format("{}", after.facts.stack_depth), lines);
  return lines;
}

}  // namespace glider::analysis
