// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "flights/requirement_watch.h"
#include "support/trace/trace.h"

#include <string>
#include <vector>

namespace glider::flights {

/// The sensors that the mission lists with `sensors`, by the vehicle's names, in the order of the
/// text.
std::vector<std::string> listedSensors(const ir::Mission& mission);

/// What the text of a mission says about a flight with these values of its parameters; without
/// `logged` and `promises`.
support::MissionFacts missionFacts(const compiler::Optimised& mission,
                                   const std::vector<double>& parameters);

/// The requirements and then the assumptions of a watched mission, and what the flight of `found`
/// did. A requirement that speaks of all flights (`can reach`) is not checked.
std::vector<support::FlownPromise> flownPromises(const RequirementWatch& watch,
                                                 const compiler::Checked& mission,
                                                 const FlownOutcome& found);

}  // namespace glider::flights
