// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <functional>
#include <span>
#include <string_view>

/// Makes missions smaller and faster without changing what they do: the same transitions at the
/// same ticks, commands, notes and values, bit for bit. States and temporals may be renumbered,
/// cases are not.
namespace glider::ir {

struct OptPass {
  std::string_view name;     ///< "fold-constants"
  std::string_view purpose;  ///< for `--help`
  void (*run)(Mission& mission);
};

/// All of them, in order (opt_passes.def).
std::span<const OptPass> optPasses();

/// A valid mission after all passes, without its requirements; `after`, if given, is called with
/// the mission after each pass.
Mission optimise(Mission mission,
                 const std::function<void(const OptPass&, const Mission&)>& after = {});

}  // namespace glider::ir
