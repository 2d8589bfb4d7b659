// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/files.h"

#include "hooks/transport/descriptor.h"
#include "runtime/board/kernel.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
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

/// The log's file, and the file that it is renamed to when it is full.
struct LogFile {
  const char* path;
  char older[256];
  uint64_t limit;
  uint64_t size;
  int descriptor;
};

bool openFile(LogFile& file, int flags) {
  file.descriptor = open(file.path, O_WRONLY | O_CREAT | O_APPEND | flags, 0644);
  const off_t end = lseek(file.descriptor, 0, SEEK_END);
  file.size = end > 0 ? static_cast<uint64_t>(end) : 0U;
  return file.descriptor >= 0;
}

/// Writes to the log on a full card fail at once; there is no wait for space.
int32_t writeLog(void* self, const uint8_t* bytes, uint32_t count) {
  auto& file = *static_cast<LogFile*>(self);
  if (file.descriptor < 0 && !openFile(file, 0)) {
    return -1;  // the card had no room for a new file
  }
  uint32_t written = 0;
  while (written < count) {
    const ssize_t taken = write(file.descriptor, bytes + written, count - written);
    if (taken <= 0 && !(taken < 0 && errno == EINTR)) {
      break;
    }
    written += taken > 0 ? static_cast<uint32_t>(taken) : 0U;
  }
  file.size += written;
  return static_cast<int32_t>(written);
}

int32_t syncLog(void* self) {
  return fdatasync(static_cast<const LogFile*>(self)->descriptor);
}

/// Renames a full log to the older one, which it replaces. If that fails, the log may grow to the
/// size of both files together and only then starts again from empty.
int32_t renewLog(void* self) {
  auto& file = *static_cast<LogFile*>(self);
  if (file.size < file.limit ||
      (rename(file.path, file.older) != 0 && errno != ENOENT && file.size < 2 * file.limit)) {
    return 0;
  }
  close(file.descriptor);
  (void)openFile(file, O_TRUNC);
  return 1;
}

void dontBlock(int descriptor) {
  const int flags = controlFile(descriptor, F_GETFL, 0);
  if (flags >= 0) {
    (void)controlFile(descriptor, F_SETFL, flags | O_NONBLOCK);
  }
}

}  // namespace

void holdStandardFiles() {
  int descriptor = 0;
  do {
    descriptor = open("/dev/null", O_RDWR);
  } while (descriptor >= 0 && descriptor <= STDERR_FILENO);
  if (descriptor > STDERR_FILENO) {
    close(descriptor);
  }
}

void say(const char* const* pieces) {
  for (; *pieces != nullptr; ++pieces) {
    // On a vehicle standard error may not be connected.
    (void)!write(STDERR_FILENO, *pieces, lengthOf(*pieces));
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

GliderLogSink openLog(const char* path, uint32_t limit) {
  static LogFile file;
  static constexpr char kOlder[] = ".old";
  const size_t length = lengthOf(path);
  if (length + sizeof kOlder > sizeof file.older) {
    tell("warning: the name of the log `", path, "` is too long; the mission flies without");
    return {};
  }
  memcpy(file.older, path, length);
  memcpy(file.older + length, kOlder, sizeof kOlder);
  file.path = path;
  file.limit = limit;
  if (!openFile(file, 0)) {
    tell("warning: cannot write the log `", path, "`; the mission flies without until it can");
  }
  return {&file, writeLog, syncLog, renewLog};
}

void reopenLog(const GliderLogSink& log) {
  auto& file = *static_cast<LogFile*>(log.self);
  close(file.descriptor);
  (void)openFile(file, 0);
}

}  // namespace glider::runtime
