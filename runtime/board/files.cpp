// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/files.h"

#include "hooks/transport/descriptor.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

namespace glider::runtime {
namespace {

int32_t readInput(void*, uint8_t* bytes, uint32_t capacity) {
  return hooks::readDescriptor(STDIN_FILENO, bytes, capacity);
}

int32_t writeOutput(void*, const uint8_t* bytes, uint32_t count) {
  return hooks::writeDescriptor(STDOUT_FILENO, bytes, count);
}

/// The log of a full card is given up at once, never waited for.
int32_t writeLog(void* self, const uint8_t* bytes, uint32_t count) {
  const int descriptor = *static_cast<const int*>(self);
  uint32_t written = 0;
  while (written < count) {
    const ssize_t taken = write(descriptor, bytes + written, count - written);
    if (taken <= 0 && !(taken < 0 && errno == EINTR)) {
      break;
    }
    written += taken > 0 ? static_cast<uint32_t>(taken) : 0U;
  }
  return static_cast<int32_t>(written);
}

/// The power may have been cut in the middle of the last flight's last line.
void endLine(int descriptor) {
  char last = '\n';
  if (descriptor >= 0 && lseek(descriptor, -1, SEEK_END) >= 0 && read(descriptor, &last, 1) == 1 &&
      last != '\n') {
    (void)!write(descriptor, "\n", 1);
  }
}

void dontBlock(int descriptor) {
  const int flags = fcntl(descriptor, F_GETFL);
  if (flags >= 0) {
    (void)fcntl(descriptor, F_SETFL, flags | O_NONBLOCK);
  }
}

}  // namespace

void say(const char* const* pieces) {
  for (; *pieces != nullptr; ++pieces) {
    // Nobody may be listening on a vehicle.
    (void)!write(STDERR_FILENO, *pieces, strlen(*pieces));
  }
}

GliderByteStream standardStream() {
  dontBlock(STDIN_FILENO);
  dontBlock(STDOUT_FILENO);
  return {nullptr, readInput, writeOutput};
}

const char* readFile(const char* path, char* bytes, uint32_t capacity, uint32_t& size) {
  const int descriptor = open(path, O_RDONLY);
  if (descriptor < 0) {
    return errno == ENOENT ? "there is no such file" : "it cannot be opened";
  }
  size = 0;
  ssize_t taken = 1;
  while (taken != 0 && size < capacity) {
    taken = read(descriptor, bytes + size, capacity - size);
    if (taken < 0 && errno != EINTR) {
      close(descriptor);
      return "it cannot be read";
    }
    size += taken > 0 ? static_cast<uint32_t>(taken) : 0U;
  }
  close(descriptor);
  return taken == 0 ? nullptr : "it is too long";
}

GliderLogSink openLog(const char* path) {
  static int descriptor = -1;
  descriptor = open(path, O_RDWR | O_CREAT | O_APPEND, 0644);
  endLine(descriptor);
  return {&descriptor, descriptor >= 0 ? writeLog : nullptr};
}

}  // namespace glider::runtime
