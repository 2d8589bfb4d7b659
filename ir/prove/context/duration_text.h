// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace glider::ir::prove {

/// "2 h 1 min 12 s", rounded up; an excess of less than a millisecond is ignored.
inline std::string durationOf(double seconds) {
  const auto whole = static_cast<int64_t>(std::ceil(seconds - 1e-3));
  std::string text = whole >= 3600 ? fmt::format("{} h ", whole / 3600) : "";
  text += whole >= 60 ? fmt::format("{} min ", whole / 60 % 60) : "";
  return text + fmt::format("{} s", whole % 60);
}

}  // namespace glider::ir::prove
