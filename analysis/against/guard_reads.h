// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/eval/interpreter.h"
#include "report/findings/against.h"
#include "support/source_manager.h"

#include <string>
#include <vector>

namespace glider::analysis {

/// Something that a guard depends on.
struct GuardRead {
  std::string name;
  ir::ExprId value;
  std::string unit;  ///< to show it in
  double to_si = 1;
};

/// What a guard depends on, in the order of the text: its sensors, windows, variables and C
/// functions, also those in `became` and `held`.
struct GuardReads {
  std::vector<GuardRead> shown;
  std::vector<ir::SensorId> sensors;  ///< also those in windows
  std::vector<ir::VariableId> variables;
  std::vector<ir::FunctionId> functions;
};

/// Numbers are shown in the unit in which `guard` has constants of the same dimension, angles
/// otherwise in degrees.
GuardReads readsOf(const ir::Mission& mission, const support::SourceManager& sources,
                   ir::ExprId guard);

/// Their values after the latest step of `interpreter`.
std::vector<report::LoggedValue> valuesOf(const GuardReads& reads,
                                          const ir::Interpreter& interpreter);

/// The unit to show values of `type` in if no guard says another.
GuardRead usualUnit(ir::Type type);

}  // namespace glider::analysis
