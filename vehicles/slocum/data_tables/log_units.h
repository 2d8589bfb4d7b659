// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace glider::slocum {

/// A unit as the vehicle's files write it, spelled in one way: "sec" and "S" are "s". Two units
/// with the same spelling are the same.
std::string plainUnit(std::string_view unit);

/// The factor that turns values in `from` into `to`; empty if it is not known, or there is none.
std::optional<double> factorBetween(std::string_view from, std::string_view to);

}  // namespace glider::slocum
