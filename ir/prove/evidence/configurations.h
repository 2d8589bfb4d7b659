// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/control.h"

#include <optional>
#include <vector>

namespace glider::ir::prove {

/// A configuration, and whether a state that a question asks about has been entered on the way.
struct Reached {
  Control control;
  bool after = false;
  auto operator<=>(const Reached&) const = default;
};

/// Every configuration that the live cases of the mission lead to, with whether `after` (invalid:
/// no state) has been entered; none if there are more than 5,000, as a second check of one takes
/// some milliseconds.
std::optional<std::vector<Reached>> configurations(const Mission& mission, StateId after = {});

}  // namespace glider::ir::prove
