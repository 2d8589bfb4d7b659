// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace glider::support {

/// "41.5 s", "3 h 30 min", "365 days": a time as people say it, from a minute on to a second, with
/// five digits below. What is not finite or longer than any clock counts stays in seconds.
std::string durationText(double seconds);

/// The same as an option of the command line: "2days", "20h", "1240min", "90s", to a second.
std::string durationArgument(double seconds);

}  // namespace glider::support
