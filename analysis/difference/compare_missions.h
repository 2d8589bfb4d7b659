// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"

#include <string>
#include <vector>

namespace glider::analysis {

/// What differs in one part of two versions of a mission.
struct DifferentPart {
  std::string title;  ///< "state `look`"
  std::vector<std::string> lines;
};

/// What differs between two versions of a mission.
struct MissionDifference {
  std::vector<DifferentPart> parts;  ///< empty: they do the same; names may differ
  std::vector<std::string>
      renamed;  ///< "`a` is now `look`": states that differ in their names only
  /// Of the states of each version, by number: the same name for the same state.
  std::vector<std::string> old_names, new_names;
};

/// Compares what two versions do: their states, cases, profiles, routes, variables and parameters.
/// States belong together if they have the same name, or if they differ in nothing but their names.
/// Formatting, comments, names of constants and requirements do not count.
MissionDifference compareMissions(const compiler::Checked& before, const compiler::Checked& after);

}  // namespace glider::analysis
