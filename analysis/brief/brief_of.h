// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/parameter_rows.h"
#include "compiler/compilation.h"
#include "ir/prove/prove.h"
#include "report/brief/brief.h"
#include "vehicles/own_mission.h"

#include <string>
#include <vector>

namespace glider::analysis {

/// What a brief is made from, all of it computed before: nothing is proved or built here.
struct BriefSource {
  const compiler::Compilation& compilation;  ///< without errors, except violated requirements
  const ir::prove::Findings& proved;
  const report::CheckedMission& found;  ///< with its remarks and budgets
  const vehicles::OwnMission* own;      ///< null: none is known
  std::vector<ParameterRow> parameters;
  report::BriefHash binary;
  std::string version;  ///< of glidercc
};

/// The brief of a mission that was checked.
report::Brief briefOf(const BriefSource& source);

}  // namespace glider::analysis
