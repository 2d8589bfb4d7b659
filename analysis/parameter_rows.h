// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "flights/launch_choice.h"
#include "support/result.h"

#include <string>
#include <vector>

namespace glider::analysis {

/// A parameter as people read it.
struct ParameterRow {
  std::string name;
  std::string type;
  std::string initial;  ///< "1800 s"
  std::string range;    ///< "600 s to 3600 s"
  std::string set_to;   ///< empty: the default
};

/// The parameters of a mission, with the pilot's settings. Fails as flights::chooseParameters.
support::Result<std::vector<ParameterRow>> parameterRows(const compiler::Optimised& mission,
                                                         const flights::LaunchChoice& choice);

}  // namespace glider::analysis
