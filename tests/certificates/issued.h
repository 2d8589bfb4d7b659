// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/certificates/recheck.h"
#include "compiler/compilation.h"
#include "ir/prove/prove.h"

#include <memory>
#include <optional>
#include <string>

namespace glider::tests {

/// A mission, and what the prover found about it, with its evidence.
struct Issued {
  std::shared_ptr<const compiler::Optimised> mission;
  ir::prove::Findings findings;

  /// The certificate of a requirement as the file that `--certificates` writes; empty if there is
  /// none.
  [[nodiscard]] std::string file(uint32_t requirement) const;
  /// The second check of such a file; the test fails if it cannot be read.
  [[nodiscard]] analysis::Rechecked rechecked(uint32_t requirement, const std::string& file) const;
};

/// Proves the mission with this text. `options`: the effort of its proofs.
Issued issue(const std::string& text, ir::prove::Options options = {});

/// Whether the solver of the second check can be run.
bool solverIsInstalled();

}  // namespace glider::tests
