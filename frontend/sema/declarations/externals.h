// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

namespace glider::frontend {

/// How missions see a sensor that is not the vehicle's.
platforms::SensorKind kindOf(const ir::Type& type);

/// Enter the names of C functions and of the SBC's own sensors, so that they may be used before
/// they are declared.
void enterExternal(const ast::ExternFunction& node, Scope& scope);
void enterExternal(const ast::ExternSensor& node, Scope& scope);

/// Complete the entries: types, ranges.
void declareExternal(const ast::ExternFunction& node, Scope& scope);
void declareExternal(const ast::ExternSensor& node, Scope& scope);

/// The declaration of an `extern flightprofile` or `extern flightroute`; sensors must be declared
/// before.
BehaviourDeclaration externalBehaviour(const ast::ExternBehaviour& node, Scope& scope);

}  // namespace glider::frontend
