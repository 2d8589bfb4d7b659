// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

namespace glider::ir::prove {

/// What a sensor reports of the position of the vehicle.
enum class PlaceRead : uint8_t { Nothing, Latitude, Longitude };

PlaceRead placeReadBy(const Sensor& sensor, const platforms::Platform& platform);

/// Whether `requirement` is an `always` about the vehicle's place that is not a geofence: its truth
/// is computed from the latitude and the longitude, in its condition (except for comparisons that
/// are false nowhere), in its monitor, or in what the mission sets a variable to that it reads.
/// What the readings of a trace say of them may be the places of no vehicle, so only a flight from
/// a start that the mission allows violates it.
bool isAboutPlace(const Requirement& requirement, const ProofContext& proof_context);

}  // namespace glider::ir::prove
