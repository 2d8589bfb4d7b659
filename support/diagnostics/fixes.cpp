// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/diagnostics/fixes.h"

#include <algorithm>
#include <array>

namespace glider::support {
namespace {

/// Insertions at the same place touch, because their order would be a guess.
bool touch(const FixIt& a, const FixIt& b) {
  return a.range.begin <= b.range.end && b.range.begin <= a.range.end;
}

bool fits(const std::vector<FixIt>& chosen, const FixIt& fix, std::string_view text,
          uint32_t file) {
  return fix.range.file == file && fix.range.begin <= fix.range.end &&
         fix.range.end <= text.size() &&
         std::ranges::none_of(chosen, [&fix](const FixIt& other) { return touch(fix, other); });
}

/// The number of errors of each stage.
using Errors = std::array<size_t, 3>;

Errors errorsOf(const std::vector<Diagnostic>& diagnostics) {
  constexpr size_t kPerStage = 1000;
  Errors errors{};
  for (const Diagnostic& diagnostic : diagnostics) {
    const size_t stage = static_cast<size_t>(diagnostic.id) / kPerStage;  // GL1xxx is syntax
    errors[std::clamp<size_t>(stage, 1, errors.size()) - 1] +=
        diagnostic.severity == Severity::Error ? 1U : 0U;
  }
  return errors;
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

Result<Fixing> fixAll(
    std::string text, uint32_t file,
    const std::function<Result<std::vector<Diagnostic>>(const std::string&)>& check) {
  constexpr size_t kMostRounds = 100;
  Fixing fixing;
  fixing.text = std::move(text);
  auto diagnostics = check(fixing.text);
  const Errors at_first = diagnostics ? errorsOf(*diagnostics) : Errors{};
  while (diagnostics && fixing.rounds.size() < kMostRounds) {
    FixedText next = applyFixes(fixing.text, file, *diagnostics);
    if (next.fixed.empty()) {
      break;
    }
    fixing.rounds.push_back({std::move(fixing.text), std::move(next.fixed)});
    fixing.text = std::move(next.text);
    diagnostics = check(fixing.text);
  }
  if (!diagnostics) {
    return std::unexpected(diagnostics.error());
  }
  fixing.worse = errorsOf(*diagnostics) > at_first;
  return fixing;
}

}  // namespace glider::support
