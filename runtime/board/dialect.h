// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"

namespace glider::runtime {

/// What the vehicle at the other end of the line speaks is chosen when the program is linked:
/// dialect_hooks.cpp here, or
/// runtime/extctl/program.cpp. Returns the stream of the hook protocol's frames over
/// `line`. `may_resume`: the program has found a checkpoint. Once per program.
GliderByteStream framesOver(const GliderByteStream& line, bool may_resume);

}  // namespace glider::runtime
