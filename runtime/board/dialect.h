// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"
#include "runtime/checkpoint/checkpoint.h"
#include "runtime/core/after_tick.h"

namespace glider::runtime {

/// What the vehicle at the other end of the line speaks is chosen when the program is linked:
/// dialect_hooks.cpp here, runtime/extctl/program.cpp,
/// runtime/imc/program.cpp or runtime/recon/program.cpp.
struct FrameLine {
  GliderByteStream stream;  ///< of the hook protocol's frames
  /// Counts what arrives damaged; null: that are frames of the stream.
  const uint32_t* damaged = nullptr;
  AfterTick after_tick = {};
};

/// The frames over `line`. `checkpoint`: the one that the program has found; null: none. Once per
/// program.
FrameLine framesOver(const GliderByteStream& line, const LinkFacts* checkpoint);

/// The mission is over: whether the program may end now. If false, it polls on until this is asked
/// again.
bool mayEnd();

}  // namespace glider::runtime
