// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What `glidercc fix` makes of every golden is not worse than the golden: no error of a new kind,
// except those that the errors of an earlier stage had hidden, and no condition that compares
// exactly or always has the same value.

#include "frontend/constructs.h"
#include "support/diagnostics/fixes.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/verification.h"
#include "tests/golden/golden_file.h"
#include "tests/golden/stages.h"

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace glider::golden {
namespace {

using support::Diagnostic;
using support::DiagnosticId;

/// Warnings that a fix may uncover but never cause: they tell of a condition without sense.
const std::set<DiagnosticId> kSenseless = {support::diagnostics::measuredEquality,
                                           support::diagnostics::constantAlways,
                                           support::diagnostics::comparisonDecided};

int stageOf(DiagnosticId id) {
  return static_cast<int>(id) / 1000;
}

int firstStage(const std::vector<Diagnostic>& diagnostics) {
  int stage = INT_MAX;
  for (const Diagnostic& d : diagnostics) {
    stage = d.severity == support::Severity::Error ? std::min(stage, stageOf(d.id)) : stage;
  }
  return stage;
}

bool has(const std::vector<Diagnostic>& diagnostics, DiagnosticId id) {
  return std::ranges::find(diagnostics, id, &Diagnostic::id) != diagnostics.end();
}

class FixedGoldens : public testing::Test {
 protected:
  /// Fixes a golden; returns whether anything was fixed.
  static bool fix(const std::filesystem::path& path) {
    SCOPED_TRACE(path.string());
    std::filesystem::current_path(path.parent_path());
    const auto check = [&](const std::string& text) {
      return support::Result<std::vector<Diagnostic>>(
          run("verify", path.filename(), text).diagnostics);
    };
    const std::string input = GoldenFile(path).input();
    const auto before = check(input);
    const auto fixing = support::fixAll(input, 0, {check, frontend::constructsOf});
    EXPECT_TRUE(fixing.has_value());
    const auto after = check(fixing->text);
    for (const Diagnostic& d : *after) {
      const bool is_new = !has(*before, d.id);
      const bool error = d.severity == support::Severity::Error;
      EXPECT_FALSE(is_new && error && stageOf(d.id) <= firstStage(*before))
          << support::code(d.id) << " " << d.message << "\n"
          << fixing->text;
      // Of a mission that was not analysed at first, the condition may stand as the pilot wrote it.
      EXPECT_FALSE(is_new && kSenseless.contains(d.id) && firstStage(*before) > 1)
          << support::code(d.id) << " " << d.message << "\n"
          << fixing->text;
    }
    return !fixing->rounds.empty();
  }
};

TEST_F(FixedGoldens, AreNoWorse) {
  size_t fixed = 0;
  for (const char* stage : {"parse", "sema", "verify", "errors"}) {
    for (const auto& path :
         goldensIn(std::filesystem::path(GLIDER_SOURCE_DIR) / "tests" / "golden" / stage)) {
      fixed += fix(path) ? 1U : 0U;
    }
  }
  EXPECT_GT(fixed, 15U) << "the goldens show fixes";
}

}  // namespace
}  // namespace glider::golden
