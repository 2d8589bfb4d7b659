// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <string>
#include <string_view>

namespace glider::ir {

/// The structure of a valid mission as a model for SPIN, written only from ir/README.md and
/// independently of the checks: the states, the call stack, `always` with its limits. Any case may
/// fire at any tick, except those that are always false or hidden by one that is always true. A
/// `return` with an empty stack and a call of a state that is already on it violate an assertion:
///
///     spin -run -m1000000 mission.pml
///
/// What precedes the process is `promelaPrelude`. If EMPTY_RETURN, CALLED_TWICE, REACHED or CALLED
/// are defined before it, those definitions are used instead: tests/spin counts them.
std::string promela(const Mission& mission);

/// The macros that the processes use.
std::string_view promelaPrelude();
/// The process alone, named `process`; `active`: it starts automatically.
std::string promelaProcess(const Mission& mission, std::string_view process, bool active);

}  // namespace glider::ir
