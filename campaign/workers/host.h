// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <chrono>
#include <string>
#include <unistd.h>

namespace glider::campaign {

/// How long a rank sleeps before it looks for messages again: much less than a flight lasts.
inline constexpr std::chrono::milliseconds kRanksPause{5};

/// The name of this machine.
inline std::string hostName() {
  constexpr size_t kLongest = 256;
  std::string name(kLongest, '\0');
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.c_str() : "a machine";
}

}  // namespace glider::campaign
