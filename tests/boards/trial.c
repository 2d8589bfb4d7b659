// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a mission asks of a board, in small: C and C++ from one bitcode, 64-bit and floating-point
// arithmetic, both clocks, a file, a pause. Says one line, the same on every board.
#include "tests/boards/trial.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

// A kernel may lack the monotonic clock, but must then report an error.
static int clocksWork(void) {
  struct timespec now;
  if (clock_gettime(CLOCK_REALTIME, &now) != 0 || now.tv_sec < 1) {
    return 0;
  }
  return clock_gettime(CLOCK_MONOTONIC, &now) == 0 || errno == ENOSYS;
}

static int fileWorks(const char* name) {
  struct stat about;
  FILE* file = fopen(name, "w");
  if (file == NULL) {
    return 0;
  }
  int written = fputs("depth\n", file) >= 0;
  written = fclose(file) == 0 && written;
  int found = stat(name, &about) == 0 && about.st_size == 6;
  return unlink(name) == 0 && written && found;
}

int main(int argc, char** argv) {
  const double depths[] = {5.0, 10.25, 12.5 * argc};
  volatile int64_t cycles = 123456789012345LL * argc;
  const struct timespec pause = {0, 1000000};
  if (argc != 2 || !clocksWork() || !fileWorks(argv[1]) || nanosleep(&pause, NULL) != 0) {
    return 1;
  }
  printf("%.17g %lld %lld\n", trialMeanDepth(depths, 3), (long long)(cycles / 3600000),
         (long long)(cycles % 3600000));
  return 0;
}
