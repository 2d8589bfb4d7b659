// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/diagnostics/fixes.h"

#include <algorithm>

namespace glider::support {
namespace {

/// Insertions at one place touch, for which of them comes first would be a guess.
bool touch(const FixIt& a, const FixIt& b) {
  return a.range.begin <= b.range.end && b.range.begin <= a.range.end;
}

bool fits(const std::vector<FixIt>& chosen, const FixIt& fix, std::string_view text,
          uint32_t file) {
  return fix.range.file == file && fix.range.begin <= fix.range.end &&
         fix.range.end <= text.size() &&
         std::ranges::none_of(chosen, [&fix](const FixIt& other) { return touch(fix, other); });
}

}  // namespace

FixedText applyFixes(std::string_view text, uint32_t file,
                     const std::vector<Diagnostic>& diagnostics) {
  FixedText result{std::string(text), {}};
  std::vector<FixIt> chosen;
  for (const Diagnostic& diagnostic : diagnostics) {
    const bool fitting =
        !diagnostic.fixes.empty() && std::ranges::all_of(diagnostic.fixes, [&](const FixIt& fix) {
          return fits(chosen, fix, text, file);
        });
    if (fitting) {
      chosen.insert(chosen.end(), diagnostic.fixes.begin(), diagnostic.fixes.end());
      result.fixed.push_back(diagnostic);
    }
  }
  std::ranges::sort(chosen, {}, [](const FixIt& fix) { return fix.range.begin; });
  for (auto fix = chosen.rbegin(); fix != chosen.rend(); ++fix) {
    result.text.replace(fix->range.begin, fix->range.end - fix->range.begin, fix->replacement);
  }
  return result;
}

}  // namespace glider::support
