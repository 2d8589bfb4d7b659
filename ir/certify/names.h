// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/certify/certificate.h"

/// The symbols that certificate.h lists, one by one.
namespace glider::ir::certify {

/// Of the k-th waiting state, outermost first, or of the current one.
std::string enteredName(size_t k);
/// `what`: "" or " known" of a number, " true" or " false" of a truth value.
std::string variableName(const Variable& v, const char* what);
/// `what`: "was" or "since".
std::string temporalName(const char* what, uint32_t temporal);

/// Whether the variable has a value in `at`: its state is current or waits.
bool hasStarted(const Variable& v, const Configuration& at);
/// Whether the temporal is a `became` or `held` whose memory counts while `state` is current.
bool isRemembered(const Temporal& t, StateId state);

}  // namespace glider::ir::certify
