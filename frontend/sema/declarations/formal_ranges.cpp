// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/formal_ranges.h"

#include "frontend/sema/declarations/declared_value.h"

namespace glider::frontend {

void settleRanges(Signature& signature, Scope& scope) {
  for (Signature::Formal& formal : signature.formals) {
    if (formal.range == nullptr) {
      continue;
    }
    DeclaredValue value(*formal.name, formal.type, scope);
    const auto bounds = value.bounds(*formal.range);
    signature.valid = signature.valid && bounds.has_value();
    if (!bounds) {
      continue;
    }
    formal.lowest = bounds->lowest;
    formal.highest = bounds->highest;
    if (formal.usual != nullptr) {
      const auto usual = value.constant(*formal.usual, "a usual argument");
      signature.valid = signature.valid && usual &&
                        value.inside(usual->first, *bounds, *formal.usual, *formal.range);
    }
  }
}

}  // namespace glider::frontend
