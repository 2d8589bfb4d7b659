// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"
#include "runtime/checkpoint/checkpoint.h"

namespace glider::runtime {

/// What the vehicle at the other end of the line speaks is chosen when the program is linked:
/// dialect_hooks.cpp here, or runtime/extctl/program.cpp.
struct FrameLine {
  GliderByteStream stream;  ///< of the hook protocol's frames
  /// Counts what arrives damaged; null: that are frames of the stream.
  const uint32_t* damaged = nullptr;
  /// For how long the vehicle has been brought to the surface before the mission may begin, s; NaN:
  /// it is not. Null: it never is.
  const double* comes_up_for_s = nullptr;
};

/// The frames over `line`. `checkpoint`: the one that the program has found; null: none. Once per
/// program.
FrameLine framesOver(const GliderByteStream& line, const LinkFacts* checkpoint);

}  // namespace glider::runtime
