// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"

#include <cstdint>
#include <span>

/// The worlds that statements about a mission are about: who takes one takes it by its type, so
/// that nothing is proved in one and said of another.
namespace glider::ir {

/// The mission and the platform as their files say. Both outlive this.
struct WrittenWorld {
  const Mission& mission;
  const platforms::Platform& platform;
};

/// Every vehicle and sea that the platform or the mission's assumptions allow: what is proved here
/// rests on no assumption. The mission is the written one.
struct WidestWorld {
  const Mission& mission;
  platforms::Platform platform;
};

/// The mission, the vehicle and the sea under assumptions (under_assumptions.h): what is proved
/// here rests on them.
struct AssumedWorld {
  Mission mission;
  platforms::Platform platform;
};

/// Of one mission, made once.
struct Worlds {
  /// Both outlive this.
  Worlds(const Mission& mission, const platforms::Platform& platform);

  WrittenWorld written;
  WidestWorld widest;
  AssumedWorld assumed;  ///< under all assumptions of the mission
};

/// The world under the assumptions with these numbers, and no others.
AssumedWorld assuming(const WidestWorld& widest, std::span<const uint32_t> assumptions);

}  // namespace glider::ir
