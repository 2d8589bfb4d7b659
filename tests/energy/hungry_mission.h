// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/falsification/rng.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Missions that a search breeds: states whose profiles command depths at depths, pitches and
/// times, and that follow one another by clocks and depths.
namespace glider::tests {

enum class Asked : uint8_t { Deeper, Shallower, PitchAbove, PitchBelow, Since, StateTime };

/// "depth >= 12 m".
struct Comparison {
  Asked asked = Asked::Deeper;
  int value = 0;  ///< m, deg or s
};

/// All of them hold.
using Guard = std::vector<Comparison>;

struct DepthCommand {
  enum class Kind : uint8_t { Descend, Ascend, Hover, Surface };
  Kind kind = Kind::Descend;
  int depth_m = 0, pitch_deg = 0;
};

/// A case of a profile. One that asks for the time since another sets that time.
struct ProfileTurn {
  Guard guard;
  DepthCommand command;
};

/// A case of a state.
struct StateLead {
  Guard guard;
  size_t to = 0;
};

/// The library's.
struct LibraryYo {
  int top_m = 0, bottom_m = 0, pitch_deg = 0;
};

struct HungryState {
  std::optional<LibraryYo> yo;  ///< none: the profile is its own, of the two below
  DepthCommand entry;
  std::vector<ProfileTurn> turns;
  std::vector<StateLead> leads;
};

/// It begins with the first state, and ends after an hour and a half.
using HungryMission = std::vector<HungryState>;

std::string textOf(const HungryMission& mission);

/// One of the kinds that are known to take much, with depths, pitches and times by `dice`. They
/// take turns: the kind is that of `number`.
HungryMission dangerousMission(size_t number, ir::prove::Rng& dice);

HungryMission drawHungryMission(ir::prove::Rng& dice);

/// With a few changes.
HungryMission mutated(HungryMission mission, ir::prove::Rng& dice);

}  // namespace glider::tests
