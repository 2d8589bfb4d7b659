// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Flown by scripts/build_sysroots to try a new sysroot: the C library's start and end, output, the
// serial line's header, and the arithmetic that these processors leave to support routines.
#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <termios.h>
#include <time.h>

int main(int argc, char** argv) {
  (void)argv;
  volatile int64_t dividend = -1000000007LL * 1000003LL * argc;
  volatile int64_t divisor = 998244353LL;
  volatile double metres = 12.75 * argc;
  volatile float feet = (float)metres / 0.3048f;
  struct timespec now;
  struct termios line;
  if (clock_gettime(CLOCK_REALTIME, &now) != 0 || now.tv_sec < 1) {
    return 2;
  }
  if (tcgetattr(-1, &line) == 0 || errno != EBADF) {
    return 3;
  }
  void* block = malloc(100000);
  if (block == NULL) {
    return 4;
  }
  free(block);
  printf("%lld %lld %llu %.3f %.3f %lld %.1f\n", (long long)(dividend / divisor),
         (long long)(dividend % divisor), (unsigned long long)((uint64_t)dividend / 10u), metres,
         (double)feet, (long long)(metres * 1e9), (double)divisor);
  return 0;
}
