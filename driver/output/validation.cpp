// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/validation.h"

#include "driver/terminal.h"
#include "support/diagnostics/ids/target.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::driver {

using codegen::Validated;
using codegen::Verdict;

support::Result<void> reportValidation(const codegen::Validation& validation,
                                       const std::string& target, bool strict) {
  const auto differs = std::ranges::find(validation, Verdict::Differs, &Validated::verdict);
  if (differs != validation.end()) {
    return support::fail(support::diagnostics::codeDiffers, differs->what, differs->words);
  }
  for (const Validated& one : validation) {
    if (one.verdict != Verdict::Undecided) {
      continue;
    }
    const auto unknown = support::fail(support::diagnostics::codeNotCompared, one.what, one.words);
    if (strict) {
      return unknown;
    }
    reportWarning(unknown.error());
  }
  return printSuccess(
      fmt::format("{} of {} parts of the code for {} are proved to do what the mission says.\n",
                  std::ranges::count(validation, Verdict::Same, &Validated::verdict),
                  validation.size(), target));
}

}  // namespace glider::driver
