// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <fcntl.h>
#include <signal.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

/// Replacements for functions of the C library that would need much more code on a board.
namespace glider::runtime {

/// From now on the signal is ignored.
inline void ignoreSignal(int number) {
  // The kernel's struct sigaction begins with the handler on every board; its mask is 8 bytes long.
  constexpr uintptr_t kIgnore = 1;  // SIG_IGN
  const uintptr_t action[8] = {kIgnore};
  constexpr long kMaskBytes = 8;
  (void)syscall(SYS_rt_sigaction, number, action, nullptr, kMaskBytes);
}

/// fork for a program without threads, handlers of signals and a heap, which the C library's
/// handles too. The number of the new process, in that 0; -1 with errno.
inline pid_t copyProcess() {
  return static_cast<pid_t>(syscall(SYS_clone, long{SIGCHLD}, nullptr, nullptr, nullptr, nullptr));
}

/// strlen, a byte at a time.
inline size_t lengthOf(const char* text) {
  const char* end = text;
  while (*end != '\0') {
    ++end;
  }
  return static_cast<size_t>(end - text);
}

/// fcntl for a number, with its result.
inline int controlFile(int descriptor, int command, long argument) {
  return static_cast<int>(syscall(SYS_fcntl, descriptor, command, argument));
}

/// Waits for a lock on a whole file. 0, or -1 with errno.
inline int lockWhole(int descriptor) {
  struct flock whole{};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
#ifdef SYS_fcntl64
  return static_cast<int>(syscall(SYS_fcntl64, descriptor, F_SETLKW, &whole));
#else
  return static_cast<int>(syscall(SYS_fcntl, descriptor, F_SETLKW, &whole));
#endif
}

}  // namespace glider::runtime
