// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/whole/whole.h"
#include "ir/prove/context/duration_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace glider::analysis {
namespace {

std::string sumOf(const Ending& ending) {
  std::vector<std::string> parts;
  for (const Part& part : ending.parts) {
    parts.push_back(fmt::format("{} {:.0f} s", part.what, part.seconds));
  }
  return fmt::format("{}", fmt::join(parts, " + "));
}

}  // namespace

/// Endings that end alike have one line.
std::vector<std::string> wholeLines(const Whole& whole) {
  std::vector<std::pair<std::string, std::vector<std::string>>> lines;
  for (const Ending& ending : whole.endings) {
    if (!ending.proved()) {
      continue;
    }
    const std::string rest =
        fmt::format("the vehicle is at the surface within {}, by {}: {}",
                    ir::prove::durationOf(ending.seconds()), ending.by, sumOf(ending));
    if (lines.empty() || lines.back().first != rest) {
      lines.push_back({rest, {}});
    }
    lines.back().second.push_back(ending.after);
  }
  std::vector<std::string> text;
  for (const auto& [rest, after] : lines) {
    text.push_back(fmt::format("after {} {}", fmt::join(after, ", "), rest));
  }
  return text;
}

}  // namespace glider::analysis
