// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <string>
#include <utility>
#include <vector>

namespace glider::analysis {

/// Which states of two versions of a mission belong together.
struct MatchedStates {
  std::vector<std::pair<ir::StateId, ir::StateId>> pairs;    ///< in the order of the new version
  std::vector<std::pair<ir::StateId, ir::StateId>> renamed;  ///< those of them with another name
  std::vector<ir::StateId> removed, added;
  /// By number: states that belong together have the same name, that of the old version.
  std::vector<std::string> old_names, new_names;
};

/// States belong together if they have the same name, or if nothing else differs in them and this
/// is so for no other state.
MatchedStates matchStates(const ir::Mission& before, const ir::Mission& after);

}  // namespace glider::analysis
