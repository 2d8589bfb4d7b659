// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"
#include "runtime/checkpoint/checkpoint.h"

namespace glider::runtime {

/// What the vehicle at the other end of the line speaks is chosen when the program is linked:
/// dialect_hooks.cpp here, or
/// runtime/extctl/program.cpp. Returns the stream of the hook protocol's frames over
/// `line`. `checkpoint`: the one that the program has found; null: none. Once per program.
GliderByteStream framesOver(const GliderByteStream& line, const LinkFacts* checkpoint);

}  // namespace glider::runtime
