// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/verify.h"

#include "ir/core/validate.h"
#include "ir/verify/passes.h"
#include "support/check.h"

namespace glider::ir {
namespace {

constexpr VerifyPass kPasses[] = {
#define PASS(name, purpose) {#name, purpose},
#include "ir/verify/verify_passes.def"
#undef PASS
};

}  // namespace

std::span<const VerifyPass> verifyPasses() {
  return kPasses;
}

MissionFacts verify(const Mission& mission, support::DiagnosticEngine& diagnostics) {
  CHECK(validate(mission).empty(), "a mission that does not hold together");
  const Structure structure(mission);
  Verification verification{structure, diagnostics, {}};
#define PASS(name, purpose) passes::name(verification);
#include "ir/verify/verify_passes.def"
#undef PASS
  return verification.facts;
}

}  // namespace glider::ir
