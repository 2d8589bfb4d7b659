// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What `build --validate` says of what the comparison found.

#include "driver/output/validation.h"

#include "driver/terminal.h"
#include "support/diagnostics/ids/target.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::driver {
namespace {

using codegen::Verdict;
using testing::HasSubstr;

TEST(ReportValidation, ADifferenceEndsTheBuild) {  // GL4018; accepts: GL4018 in Validated
  const codegen::Validation found = {{"the cases of `dive`", Verdict::Undecided, "a loop"},
                                     {"the entry of `dive`", Verdict::Differs, "`n` differs"}};
  const auto reported = reportValidation(found, "ts7800", false);
  ASSERT_FALSE(reported);
  EXPECT_EQ(reported.error().id, support::diagnostics::codeDiffers);
  EXPECT_THAT(reported.error().message, HasSubstr("the entry of `dive`"));
  EXPECT_THAT(reported.error().message, HasSubstr("`n` differs"));
}

TEST(ReportValidation, WhatIsNotDecidedIsAWarningOrByStrictAnError) {  // GL4019; accepts: GL4019
  const codegen::Validation found = {{"the cases of `dive`", Verdict::Undecided, "a loop"}};
  const auto strict = reportValidation(found, "ts7800", true);
  ASSERT_FALSE(strict);
  EXPECT_EQ(strict.error().id, support::diagnostics::codeNotCompared);
  const KeptMessages kept;
  EXPECT_TRUE(reportValidation(found, "ts7800", false));
  EXPECT_THAT(kept.text(), HasSubstr("a loop"));
}

}  // namespace
}  // namespace glider::driver
