// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::hooks {

/// A position as the vehicle's sensors give it, in ddmm.mmmm; NaN for unknown.
struct Position {
  double latitude_ddmm = __builtin_nan("");
  double longitude_ddmm = __builtin_nan("");
};

/// False if it is unknown or not on Earth.
bool isKnown(const Position& at);
/// How far apart two positions are, m: the greater of the distances along the meridian and along
/// the parallel, so at most three tenths too little and never too much. 0 if either is unknown or
/// not on Earth: an unknown position counts as near.
double distanceBetween(const Position& a, const Position& b);

}  // namespace glider::hooks
