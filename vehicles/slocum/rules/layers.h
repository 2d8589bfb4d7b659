// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "vehicles/slocum/mission_files/mission_file.h"

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace glider::slocum::rules {

/// What a behaviour of the vehicle's mission file may do with pitch and pump without the SBC.
enum class Role : uint8_t {
  Quiet,     ///< it commands neither, or never starts
  Hookbeh,   ///< the SBC's
  Surfaces,  ///< from its start until the vehicle is at the surface, it climbs
  Flies,     ///< it commands them otherwise, or in a way that is not known
};

/// When a behaviour that surfaces starts for certain.
enum class Start : uint8_t {
  Idle,       ///< as soon as no behaviour below commands pitch and pump
  InTime,     ///< at the latest `starts_within_s` after it was last active or at the surface
  Uncertain,  ///< perhaps never
};

/// Whether an argument has one of these values.
bool isOneOf(double code, std::initializer_list<double> codes);

/// One behaviour of the mission file.
struct Layer {
  size_t number = 0;  ///< its place in the file, from 1: the vehicle's number of it
  std::string name;
  support::SourceRange range;
  Role role = Role::Quiet;
  // One that surfaces:
  Start start = Start::Uncertain;
  double starts_within_s = 0;
  std::string start_text;  ///< "start_when 12, when_secs 3600"
  // One that flies:
  std::optional<double> deepest_m;  ///< where it dives to by its arguments; none: anywhere
  std::optional<int> legs;          ///< dives and climbs, after which it is over; none: no end
  double stalled_s = 0;             ///< a leg that gains no depth ends after this time
  double waits_s = 0;               ///< how long it flies otherwise
  std::string argument;             ///< why it is as it is: "num_half_cycles_to_do -1"
  std::string change;               ///< what to change

  /// "behaviour 3 `surface`".
  [[nodiscard]] std::string label() const;
};

/// The behaviours of `mission`, the highest priority first.
std::vector<Layer> layersOf(const slocum::MissionFile& mission,
                            const platforms::Platform& platform);

}  // namespace glider::slocum::rules
