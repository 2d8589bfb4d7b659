// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace glider::support {

/// "2019-08-09 15:24:50" for seconds since 1970; "unknown" for what is not a time.
std::string utcText(double time_s);
/// "2019-08-09T15:24:50Z", as missions write it; "unknown" for the same.
std::string instantText(double time_s);

}  // namespace glider::support
