// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"
#include "runtime/abi/runtime.h"

/// The operating system's files, of which a board needs three: messages, standard input and output
/// as a stream, the log.
namespace glider::runtime {

/// Opens what is closed of standard input, output and error, to nothing: the first files that a
/// program opens would else get their numbers, and be closed or written as what they are not.
void holdStandardFiles();

/// Writes the pieces of a message to standard error; a null piece ends it.
void say(const char* const* pieces);

/// Says `pieces` (C strings) as one line on standard error.
template <typename... Pieces>
void tell(Pieces... pieces) {
  const char* const list[] = {pieces..., "\n", nullptr};
  say(list);
}

/// Standard input and output as a byte stream that never blocks.
GliderByteStream standardStream();

/// Reads a file into `bytes`, and how many bytes it has into `size`. Null, or why it cannot be
/// read; one that has `capacity` bytes or more cannot.
const char* readFile(const char* path, char* bytes, uint32_t capacity, uint32_t& size);

/// Opens the log and makes a sink of it that writes after what is there: a program that the board
/// starts again must not wipe what the one before has seen. Once it has `limit` bytes it becomes
/// `path`.old, and a new one begins. `path` outlives the sink. One that cannot be opened earns a
/// warning; each write then tries again, and fails as one to a full card does.
GliderLogSink openLog(const char* path, uint32_t limit);

/// What openLog gave, opened again by its path.
void reopenLog(const GliderLogSink& log);

}  // namespace glider::runtime
