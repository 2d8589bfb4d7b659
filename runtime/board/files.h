// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"
#include "runtime/abi/runtime.h"

/// The operating system's files. A board needs three: messages, standard input and output as a
/// stream, and the log.
namespace glider::runtime {

/// Opens /dev/null for those of standard input, output and error that are closed: otherwise the
/// first files that a program opens would get their numbers, and would be closed or written in
/// place of the standard ones.
void holdStandardFiles();

/// Writes the pieces of a message to standard error; a null piece ends it.
void say(const char* const* pieces);

/// Prints `pieces` (C strings) as one line on standard error.
template <typename... Pieces>
void tell(Pieces... pieces) {
  const char* const list[] = {pieces..., "\n", nullptr};
  say(list);
}

/// Standard input and output as a byte stream that never blocks.
GliderByteStream standardStream();

/// Reads a file into `bytes`, and its size in bytes into `size`. Returns null, or why it cannot be
/// read; a file of `capacity` bytes or more cannot.
const char* readFile(const char* path, char* bytes, uint32_t capacity, uint32_t& size);

/// Opens the log and returns a sink that appends to it: a program that the board restarts must not
/// erase the records of the previous one. When the log has `limit` bytes it is renamed to
/// `path`.old, and a new one begins. `path` outlives the sink. If the log cannot be opened, prints
/// a warning; each write then tries again, and fails like a write to a full card.
GliderLogSink openLog(const char* path, uint32_t limit);

/// Opens the log that openLog returned again, by its path.
void reopenLog(const GliderLogSink& log);

}  // namespace glider::runtime
