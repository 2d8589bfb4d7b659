/* SPDX-FileCopyrightText: 2026 The glidercc authors
   SPDX-License-Identifier: Apache-2.0 */

/* An oxygen optode on a serial port of the payload computer. It sends a line about every second:
   O2 231.40, in micromole per litre. OPTODE_PORT names the port; /dev/ttyS2 if it is not set.

   A tick asks once and must have its answer at once: nothing here waits, and what has not come is
   for the next tick. Without a heap or a lock, for the runtime has neither. */

#include "optode.h"

#include <fcntl.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

enum { LINE = 32, AT_ONCE = 256 };

static int port = -1;
static char line[LINE];
static size_t length;

/* 9600 baud, 8N1, raw lines. A file that is not a terminal (a recording) is used unchanged. */
static int openPort(void) {
  const char* const named = getenv("OPTODE_PORT");
  const int opened = open(named ? named : "/dev/ttyS2", O_RDONLY | O_NOCTTY | O_NONBLOCK);
  struct termios as;
  if (opened >= 0 && tcgetattr(opened, &as) == 0) {
    as.c_iflag = 0;
    as.c_oflag = 0;
    as.c_lflag = 0;
    as.c_cflag = CS8 | CREAD | CLOCAL;
    cfsetispeed(&as, B9600);
    cfsetospeed(&as, B9600);
    tcsetattr(opened, TCSANOW, &as);
  }
  return opened;
}

/* The number of a line "O2 231.40"; NaN if it is not such a line. */
static double numberOf(const char* text, size_t size) {
  if (size < 4 || text[0] != 'O' || text[1] != '2' || text[2] != ' ') {
    return NAN;
  }
  double number = 0;
  double scale = 0; /* of the next digit; 0 before the point */
  for (size_t i = 3; i < size; ++i) {
    if (text[i] == '.' && scale == 0) {
      scale = 0.1;
    } else if (text[i] < '0' || text[i] > '9') {
      return NAN;
    } else if (scale == 0) {
      number = number * 10 + (text[i] - '0');
    } else {
      number += (text[i] - '0') * scale;
      scale /= 10;
    }
  }
  return number;
}

/* Takes one byte; returns the number of the line that it ends, else NaN. Ignores overlong lines. */
static double takeByte(char byte) {
  double number = NAN;
  if (byte == '\n') {
    number = length <= LINE ? numberOf(line, length) : NAN;
    length = 0;
  } else if (byte != '\r' && length <= LINE) {
    if (length < LINE) {
      line[length] = byte;
    }
    ++length;
  }
  return number;
}

/* `extern sensor optode_o2`: the newest reading since the last tick, NaN if there is none. The
   mission treats a reading that is older than its `stale after` as unknown. */
double sensor_optode_o2(double missiontime) {
  (void)missiontime;
  if (port < 0) {
    port = openPort(); /* the cable may be plugged in later */
  }
  char bytes[AT_ONCE];
  const ssize_t got = port < 0 ? 0 : read(port, bytes, sizeof bytes);
  double newest = NAN;
  for (ssize_t i = 0; i < got; ++i) {
    const double number = takeByte(bytes[i]);
    newest = isnan(number) ? newest : number;
  }
  return newest;
}
