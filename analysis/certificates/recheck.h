// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/certificate_file.h"
#include "compiler/compilation.h"
#include "support/result.h"

#include <cstdint>
#include <string>
#include <vector>

namespace glider::analysis {

/// The result of a second check.
struct Rechecked {
  bool accepted = false;
  size_t obligations = 0;  ///< questions that cvc5 answered, or ticks that were replayed
  std::string reason;      ///< why it is not accepted
  std::vector<uint32_t> assumptions = {};  ///< numbers of the mission's, on which it rests
};

/// The solver of the second check: a program of its own.
inline constexpr const char* kSolver = "cvc5";

/// Checks a certificate of a requirement of `mission` without the prover: its invariants by cvc5,
/// under the rules of ir/certify; its run on the compiled mission. GL9380 if cvc5 is missing,
/// GL9382 if it fails.
support::Result<Rechecked> recheck(const compiler::Certificate& certificate,
                                   const compiler::Optimised& mission, uint32_t requirement);

}  // namespace glider::analysis
