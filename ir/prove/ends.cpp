// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/duration_text.h"
#include "ir/prove/end_bound.h"
#include "ir/prove/passes.h"

#include <fmt/format.h>

namespace glider::ir::prove {
namespace {

/// A year: no mission is meant to be as long.
constexpr double kLongest = 365 * 86400.0;

}  // namespace

void passes::ends(Proof& proof) {
  if (!proof.options.report) {
    return;
  }
  const auto tell = [&](std::string text) {
    proof.findings.lines.push_back({{}, std::move(text)});
  };
  const EndBound end = boundOf(proof.ground, kLongest, Goal::Exit);
  if (end.by) {
    tell(fmt::format("the mission has ended after {} at the latest", durationOf(*end.by)));
  } else if (end.stays.valid()) {
    tell(fmt::format("no clock alone ends the mission: it may stay in `{}`",
                     proof.ground.mission[end.stays].name));
  } else {
    tell("no bound for the mission's end is known");
  }
  const EndBound home = boundOf(proof.ground, kLongest, Goal::ExitOrSurface);
  if (home.by && (!end.by || *home.by < *end.by)) {
    tell(fmt::format("it has ended, or ordered the surface, after {} at the latest",
                     durationOf(*home.by)));
  }
}

}  // namespace glider::ir::prove
