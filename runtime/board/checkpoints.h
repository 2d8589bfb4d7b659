// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/runtime.h"

/// Checkpoints in a file of the board, and which program they belong to.
namespace glider::runtime {

/// Opens or creates the file, for a mission with a context of `context_bytes`. `path` may be null,
/// which gives a store without functions; otherwise it outlives the store. If the file cannot be
/// opened, prints a warning; each write then tries again, and fails like a write to a full card.
GliderStore openCheckpoints(const char* path, uint32_t context_bytes);

/// Waits until no other process holds the file of `checkpoints`, and holds it as long as this
/// process lives: the process of the previous program may still be writing. Then makes room in the
/// file for all checkpoints, which takes some seconds for a new file.
void holdCheckpoints(const GliderStore& checkpoints);

/// A number that identifies this executable: CRC-32C over its code and constants as they are in
/// memory.
uint32_t programNumber();

}  // namespace glider::runtime
