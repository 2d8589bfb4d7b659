// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/diagnostic.h"

#include <string>
#include <vector>

namespace glider::golden {

/// What one stage of the compiler said about a golden's input.
struct Outcome {
  std::string
      text;  ///< diagnostics as a pilot reads them, then the product ("ast", "ir") if there is one
  bool warned = false;   ///< there was a diagnostic
  bool refused = false;  ///< there was an error
  std::vector<support::Diagnostic> diagnostics = {};
};

/// Runs the compiler up to `stage` ("parse", "sema", "verify", "prove") on `input`, called `name`
/// in messages. "errors": all of it; the product is what `fix` writes.
Outcome run(const std::string& stage, const std::string& name, const std::string& input);

}  // namespace glider::golden
