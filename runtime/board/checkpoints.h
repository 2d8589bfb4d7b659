// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/runtime.h"

/// Checkpoints in a file of the board, and which program they belong to.
namespace glider::runtime {

/// Opens the file, or makes it, for a mission with a context of so many bytes; `path` may be null:
/// no functions then, else it outlives the store.
/// One that cannot be opened earns a warning; each write then tries again, and fails as one to a
/// full card does.
GliderStore openCheckpoints(const char* path, uint32_t context_bytes);

/// Waits until no other process holds the file of `checkpoints`, and holds it as long as this
/// process lives: that of a program before this one may still be writing. Then makes room in it for
/// all checkpoints, which takes a new one some seconds.
void holdCheckpoints(const GliderStore& checkpoints);

/// A number of this very executable: CRC-32C over its code and constants as they lie in memory.
uint32_t programNumber();

}  // namespace glider::runtime
