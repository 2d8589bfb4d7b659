// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

/// Positions in messages and events: degrees and minutes, as pilots write them and missions read
/// them.
namespace glider::support {

/// "39 10.500 N", of degrees.
std::string latitudeText(double degrees);
/// "73 50.101 W".
std::string longitudeText(double degrees);
/// "39 10.500 N 73 50.101 W".
std::string positionText(double latitude, double longitude);

/// "640 m", "2.849 km": a distance over ground, to a metre.
std::string lengthText(double metres);

}  // namespace glider::support
