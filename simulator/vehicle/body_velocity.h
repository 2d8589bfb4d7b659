// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::simulator {

/// A velocity through the water along and about the axes of the hull, or its rate: surge ahead,
/// sway to starboard, heave down (m/s), pitch nose up, yaw to starboard (rad/s).
struct BodyVelocity {
  double surge = 0, sway = 0, heave = 0;
  double pitch = 0, yaw = 0;
};

}  // namespace glider::simulator
