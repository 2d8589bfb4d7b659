// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/diagnostics/fixes.h"

#include "support/diagnostics/catalogue.h"

#include <gtest/gtest.h>

namespace glider::support {
namespace {

Diagnostic withFixes(std::vector<FixIt> fixes) {
  return {DiagnosticId::semicolon, Severity::Error, {}, "", "", {}, std::move(fixes)};
}

TEST(Fixes, ReplaceInsertAndDelete) {
  const FixedText result =
      applyFixes("0123456789", 0,
                 {withFixes({{{0, 1, 3}, "AB!"}}), withFixes({{{0, 5, 5}, "new"}}),
                  withFixes({{{0, 8, 10}, ""}})});
  EXPECT_EQ(result.text, "0AB!34new567");
  EXPECT_EQ(result.fixed.size(), 3U);
}

TEST(Fixes, TheFirstOfTwoThatTouchWins) {
  const FixedText result =
      applyFixes("0123456789", 0,
                 {withFixes({{{0, 2, 4}, "a"}}), withFixes({{{0, 4, 4}, "b"}}),
                  withFixes({{{0, 3, 6}, "c"}}), withFixes({{{0, 5, 6}, "d"}})});
  EXPECT_EQ(result.text, "01a4d6789");
  EXPECT_EQ(result.fixed.size(), 2U);
}

TEST(Fixes, AllOfADiagnosticOrNone) {
  const FixedText result =
      applyFixes("0123456789", 0,
                 {withFixes({{{0, 2, 3}, "a"}}), withFixes({{{0, 7, 8}, "x"}, {{0, 2, 2}, "y"}}),
                  withFixes({{{0, 5, 6}, "b"}, {{0, 8, 9}, "c"}})});
  EXPECT_EQ(result.text, "01a34b67c9");
}

TEST(Fixes, NothingOutsideTheText) {
  const FixedText result =
      applyFixes("01", 0,
                 {withFixes({{{0, 1, 3}, "a"}}), withFixes({{{1, 0, 1}, "b"}}),
                  withFixes({{{}, "c"}}), withFixes({{{0, 2, 1}, "d"}}), withFixes({})});
  EXPECT_EQ(result.text, "01");
  EXPECT_TRUE(result.fixed.empty());
}

/// Diagnostics of a text of digits: each 1 is to be a 2, each 2 a 3, each 8 a 99 and each 9 an
/// error.
Result<std::vector<Diagnostic>> checkDigits(const std::string& text) {
  std::vector<Diagnostic> found;
  for (uint32_t i = 0; i < text.size(); ++i) {
    const SourceRange range{0, i, i + 1};
    const char* fix = text[i] == '1' ? "2" : text[i] == '2' ? "3" : text[i] == '8' ? "99" : nullptr;
    if (fix != nullptr || text[i] == '9') {
      found.push_back({DiagnosticId::semicolon, Severity::Error, range, "", "", {}, {}});
    }
    if (fix != nullptr) {
      found.back().fixes.push_back({range, fix});
    }
  }
  return found;
}

// accepts: GL9311
TEST(Fixes, GoOnUntilNoneIsLeft) {
  const auto fixing = fixAll("1x2", 0, checkDigits);
  ASSERT_TRUE(fixing.has_value());
  EXPECT_EQ(fixing->text, "3x3");
  ASSERT_EQ(fixing->rounds.size(), 2U);
  EXPECT_EQ(fixing->rounds[0].before, "1x2");
  EXPECT_EQ(fixing->rounds[0].fixed.size(), 2U);
  EXPECT_EQ(fixing->rounds[1].before, "2x3");
  EXPECT_FALSE(fixing->worse);
}

/// GL9311 in the command.
TEST(Fixes, WhatIsWorseIsNamedSo) {
  EXPECT_TRUE(fixAll("8", 0, checkDigits)->worse);
  EXPECT_FALSE(fixAll("1x8", 0, checkDigits)->worse) << "as many as before";
  EXPECT_TRUE(fixAll("3", 0, checkDigits)->rounds.empty());
}

TEST(Fixes, AnErrorThatWasHiddenIsNotWorse) {
  const auto hidden = [](const std::string& text) -> Result<std::vector<Diagnostic>> {
    std::vector<Diagnostic> found = {
        {DiagnosticId::semicolon, Severity::Error, {}, "", "", {}, {{{0, 0, 1}, "a"}}}};
    if (text == "a") {
      const Diagnostic unknown{DiagnosticId::unknownName, Severity::Error, {}, "", "", {}, {}};
      found = {unknown, unknown};
    }
    return found;
  };
  EXPECT_FALSE(fixAll(";", 0, hidden)->worse);
}

TEST(Fixes, ThoseThatUndoEachOtherEnd) {
  const auto fixing =
      fixAll("a", 0, [](const std::string& text) -> Result<std::vector<Diagnostic>> {
        return std::vector{withFixes({{{0, 0, 1}, text == "a" ? "b" : "a"}})};
      });
  EXPECT_EQ(fixing->rounds.size(), 100U);
}

TEST(Fixes, ASystemErrorIsPassedOn) {
  const auto fixing = fixAll("a", 0, [](const std::string&) -> Result<std::vector<Diagnostic>> {
    return fail(DiagnosticId::cannotRead, "platform", "gone");
  });
  EXPECT_FALSE(fixing.has_value());
}

}  // namespace
}  // namespace glider::support
