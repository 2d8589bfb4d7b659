// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/vehicle_premise.h"

#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/context/proof_context.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace glider::slocum::rules {
namespace {

using support::DiagnosticId;

/// Findings after which the vehicle may fly otherwise than the mission commands.
constexpr auto kDoubts = std::to_array<DiagnosticId>(
    {support::diagnostics::vehicleRefuses, support::diagnostics::vehicleAborts,
     support::diagnostics::mayStayBelow, support::diagnostics::hookbehOverrides,
     support::diagnostics::mayNotFollow, support::diagnostics::commandsMasked,
     support::diagnostics::controlPrevented, support::diagnostics::sensorUnread});

std::vector<std::string> doubtsIn(const support::DiagnosticEngine& diagnostics) {
  std::vector<std::string> codes;
  for (const support::Diagnostic& one : diagnostics.sorted()) {
    const std::string code = support::code(one.id);
    if (std::ranges::find(kDoubts, one.id) != kDoubts.end() &&
        std::ranges::find(codes, code) == codes.end()) {
      codes.push_back(code);
    }
  }
  return codes;
}

}  // namespace

std::string premiseWith(const ir::WidestWorld& world, const VehicleFile& file,
                        const support::DiagnosticEngine& diagnostics) {
  std::string text = "with " + file.name;
  if (file.guards.least_altitude_m >= 0) {
    const platforms::Platform& platform = world.platform;
    const double deepest =
        std::min(std::ranges::max(ir::prove::deepestByState(ir::prove::ProofContext(world))),
                 std::min(file.guards.greatest_depth_m, platform.envelope.greatest_depth_m) +
                     platform.envelope.inflection_overshoot_m);
    constexpr double kLeastAltitude_m = 2;  // of hookbeh (hooks/hookbeh/hull.c)
    const double altitude = std::max(file.guards.least_altitude_m, kLeastAltitude_m);
    text += fmt::format(", in water of {:.0f} m or more", std::ceil(deepest + altitude));
  }
  return text + onlyWhile("hookbeh's commands fly", diagnostics);
}

std::string onlyWhile(const char* what, const support::DiagnosticEngine& diagnostics) {
  const auto doubts = doubtsIn(diagnostics);
  return doubts.empty() ? ""
                        : fmt::format(", and only while {}: see {}", what, fmt::join(doubts, ", "));
}

}  // namespace glider::slocum::rules
