// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/mission_files/mission_file.h"
#include "vehicles/slocum/rules/layers.h"

#include <span>
#include <string>
#include <vector>

namespace glider::slocum::rules {

/// What may be without a command in some cycle after hookbeh has stopped commanding: then the
/// vehicle aborts.
struct IdleSlots {
  bool heading = false;
  bool pitch_and_pump = false;
  /// Behaviours that command them, but not in every cycle: "behaviour 4 `yo` has start_when 8".
  std::vector<std::string> unsure;

  [[nodiscard]] bool any() const { return heading || pitch_and_pump; }
  /// "heading, pitch and pump".
  [[nodiscard]] std::string text() const;
};

IdleSlots idleSlots(std::span<const Layer> layers, const slocum::MissionFile& vehicle);

}  // namespace glider::slocum::rules
