// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/opt/optimise.h"

#include "ir/core/validate.h"
#include "ir/opt/passes.h"
#include "ir/opt/prepare_for_flight.h"
#include "support/check.h"

namespace glider::ir {

std::span<const OptPass> optPasses() {
  static constexpr OptPass kPasses[] = {
#define PASS(function, name, purpose) {name, purpose, opt::function},
#include "ir/opt/opt_passes.def"
#undef PASS
  };
  return kPasses;
}

Mission optimise(Mission mission,
                 const std::function<void(const OptPass&, const Mission&)>& after) {
  prepareForFlight(mission);
  for (const OptPass& pass : optPasses()) {
    pass.run(mission);
    if (after) {
      after(pass, mission);
    }
  }
  CHECK(validate(mission).empty(), "a pass has broken the mission");
  return mission;
}

}  // namespace glider::ir
