// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/diagnostics/fixes.h"

#include "support/diagnostics/ids/files.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"

#include <gtest/gtest.h>

namespace glider::support {
namespace {

/// A warning: the fix of an error may depend on those before it.
Diagnostic withFixes(std::vector<FixIt> fixes) {
  return {support::diagnostics::semicolon, Severity::Warning, {}, "", "", {}, std::move(fixes)};
}

/// Each digit is a part of the text, and two are an item.
Constructs digits(const std::string& text) {
  Constructs found;
  for (uint32_t i = 0; i < text.size(); ++i) {
    found.parts.push_back(i);
    if (i % 2 == 0) {
      found.items.push_back(i);
    }
  }
  found.structure = {"begin"};
  return found;
}

TEST(Fixes, ReplaceInsertAndDelete) {
  const FixedText result =
      applyFixes("0123456789", 0,
                 {withFixes({{{0, 1, 3}, "AB!"}}), withFixes({{{0, 5, 5}, "new"}}),
                  withFixes({{{0, 8, 10}, ""}})},
                 Constructs{});
  EXPECT_EQ(result.text, "0AB!34new567");
  EXPECT_EQ(result.fixed.size(), 3U);
}

TEST(Fixes, TheFirstOfTwoThatTouchWins) {
  const FixedText result =
      applyFixes("0123456789", 0,
                 {withFixes({{{0, 2, 4}, "a"}}), withFixes({{{0, 4, 4}, "b"}}),
                  withFixes({{{0, 3, 6}, "c"}}), withFixes({{{0, 5, 6}, "d"}})},
                 Constructs{});
  EXPECT_EQ(result.text, "01a4d6789");
  EXPECT_EQ(result.fixed.size(), 2U);
}

TEST(Fixes, AllOfADiagnosticOrNone) {
  const FixedText result =
      applyFixes("0123456789", 0,
                 {withFixes({{{0, 2, 3}, "a"}}), withFixes({{{0, 7, 8}, "x"}, {{0, 2, 2}, "y"}}),
                  withFixes({{{0, 5, 6}, "b"}, {{0, 8, 9}, "c"}})},
                 Constructs{});
  EXPECT_EQ(result.text, "01a34b67c9");
}

TEST(Fixes, NothingOutsideTheText) {
  const FixedText result =
      applyFixes("01", 0,
                 {withFixes({{{0, 1, 3}, "a"}}), withFixes({{{1, 0, 1}, "b"}}),
                  withFixes({{{}, "c"}}), withFixes({{{0, 2, 1}, "d"}}), withFixes({})},
                 Constructs{});
  EXPECT_EQ(result.text, "01");
  EXPECT_TRUE(result.fixed.empty());
}

/// Diagnostics of a text of digits: each 1 is to be a 2, each 2 a 3, each 8 a 99 and each 9 an
/// error; 1 is two errors.
Result<std::vector<Diagnostic>> checkDigits(const std::string& text) {
  std::vector<Diagnostic> found;
  for (uint32_t i = 0; i < text.size(); ++i) {
    const SourceRange range{0, i, i + 1};
    const char* fix = text[i] == '1' ? "2" : text[i] == '2' ? "3" : text[i] == '8' ? "99" : nullptr;
    if (fix != nullptr || text[i] == '9') {
      found.push_back({support::diagnostics::semicolon, Severity::Error, range, "", "", {}, {}});
    }
    if (text[i] == '1') {
      found.push_back(found.back());
    }
    if (fix != nullptr) {
      found.back().fixes.push_back({range, fix});
    }
  }
  return found;
}

// accepts: GL9311
TEST(Fixes, GoOnUntilNoneIsLeft) {
  const auto fixing = fixAll("1x2", 0, {checkDigits, digits});
  ASSERT_TRUE(fixing.has_value());
  EXPECT_EQ(fixing->text, "3x3");
  ASSERT_EQ(fixing->rounds.size(), 2U);
  EXPECT_EQ(fixing->rounds[0].before, "1x2");
  EXPECT_EQ(fixing->rounds[0].fixed.size(), 2U);
  EXPECT_EQ(fixing->rounds[1].before, "2x3");
  EXPECT_FALSE(fixing->refused);
}

/// GL9311 in the command.
TEST(Fixes, WhatLeavesAsManyErrorsIsNotKept) {
  const auto worse = fixAll("8", 0, {checkDigits, digits});
  EXPECT_EQ(worse->text, "8");
  EXPECT_TRUE(worse->refused);
  EXPECT_TRUE(worse->rounds.empty());
  EXPECT_FALSE(fixAll("3", 0, {checkDigits, digits})->refused) << "there is nothing to fix";
}

TEST(Fixes, ABadOneDoesNotKeepAGoodOneAway) {
  const auto both = fixAll("2x8", 0, {checkDigits, digits});
  EXPECT_EQ(both->text, "3x8");
  EXPECT_TRUE(both->refused);
}

/// The second of two errors may follow from the first.
TEST(Fixes, OfAnErrorAfterAnotherAreNotApplied) {
  const Diagnostic without{
      support::diagnostics::semicolon, Severity::Error, {0, 2, 3}, "", "", {}, {}};
  const auto at = [](uint32_t place, const std::string& text) {
    Diagnostic one = withFixes({{{0, place, place + 1}, text}});
    one.severity = Severity::Error;
    one.range = {0, place, place + 1};
    return one;
  };
  Constructs constructs;
  constructs.items = {0, 6};
  constructs.parts = {0, 2, 4, 6, 8};
  constructs.structure = {"begin"};
  const std::string text = "0123456789";
  EXPECT_EQ(applyFixes(text, 0, {without, at(3, "x")}, constructs).text, text) << "the same part";
  EXPECT_EQ(applyFixes(text, 0, {without, at(5, "x")}, constructs).text, "01234x6789")
      << "another part";
  EXPECT_EQ(applyFixes(text, 0, {without, at(5, "begin ")}, constructs).text, text)
      << "what changes the structure follows from any error of its item";
  EXPECT_EQ(applyFixes(text, 0, {without, at(7, "begin ")}, constructs).text, "0123456begin 89")
      << "another item";
  constructs.words = {{5, 6}};
  EXPECT_EQ(applyFixes(text, 0, {without, at(5, "")}, constructs).text, text)
      << "a word of the structure is deleted";
  Diagnostic header = without;
  header.range = {0, 0, 1};
  EXPECT_EQ(applyFixes(text, 0, {header, at(3, "x")}, constructs).text, text)
      << "a wrong header makes the rest doubtful";
  Diagnostic warning = at(9, "x");
  warning.severity = Severity::Warning;
  EXPECT_EQ(applyFixes(text, 0, {without, warning}, constructs).text, text);
  EXPECT_EQ(applyFixes(text, 0, {warning}, constructs).text, "012345678x");
}

/// A unit is not fixed beside something in the same part that could not be read.
TEST(Fixes, WhatIsHalfReadIsNotFixed) {
  const std::string text = "0123456789";
  Diagnostic unit = withFixes({{{0, 1, 2}, "x"}});
  unit.id = support::diagnostics::bareAngle;
  unit.severity = Severity::Error;
  unit.range = {0, 1, 2};
  Diagnostic syntax = withFixes({});
  syntax.severity = Severity::Error;
  syntax.id = support::diagnostics::unknownUnit;
  syntax.range = {0, 3, 4};
  const Constructs apart{{0}, {0, 3}, {}};
  const Constructs together{{0}, {0, 5}, {}};
  EXPECT_EQ(applyFixes(text, 0, {unit, syntax}, apart).text, "0x23456789");
  EXPECT_EQ(applyFixes(text, 0, {unit, syntax}, together).text, text);
}

TEST(Fixes, AnErrorThatWasHiddenIsNotWorse) {
  const auto hidden = [](const std::string& text) -> Result<std::vector<Diagnostic>> {
    std::vector<Diagnostic> found = {{support::diagnostics::semicolon,
                                      Severity::Error,
                                      {0, 0, 1},
                                      "",
                                      "",
                                      {},
                                      {{{0, 0, 1}, "a"}}}};
    if (text == "a") {
      const Diagnostic unknown{
          support::diagnostics::unknownName, Severity::Error, {}, "", "", {}, {}};
      found = {unknown, unknown};
    }
    return found;
  };
  EXPECT_EQ(fixAll(";", 0, {hidden, digits})->text, "a");
}

TEST(Fixes, ThoseThatUndoEachOtherEnd) {
  const auto fixing = fixAll("a", 0,
                             {[](const std::string& text) -> Result<std::vector<Diagnostic>> {
                                Diagnostic one = withFixes({{{0, 0, 1}, text == "a" ? "b" : "a"}});
                                one.severity = Severity::Warning;
                                return std::vector{one};
                              },
                              digits});
  EXPECT_EQ(fixing->rounds.size(), 100U);
}

TEST(Fixes, ASystemErrorIsPassedOn) {
  const auto fixing = fixAll("a", 0,
                             {[](const std::string&) -> Result<std::vector<Diagnostic>> {
                                return fail(support::diagnostics::cannotRead, "platform", "gone");
                              },
                              digits});
  EXPECT_FALSE(fixing.has_value());
}

}  // namespace
}  // namespace glider::support
