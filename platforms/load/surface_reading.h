// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::platforms {

/// m; the least depth reading of which a program waits to see the surface: waves hide less.
inline constexpr double kSurfaceReadingM = 0.25;

}  // namespace glider::platforms
