// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/files.h"
#include "runtime/board/line.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace glider::runtime {

void sleepBoard(const Options& options) {
  if (options.sleep == nullptr) {
    return;
  }
  (void)poll(nullptr, 0, kSentMs);
  static bool told = false;
  const int file = open(options.sleep, O_WRONLY);
  static constexpr char kToRam[] = {'m', 'e', 'm', '\n'};
  if ((file < 0 || write(file, kToRam, sizeof kToRam) != sizeof kToRam) && !told) {
    tell("warning: cannot sleep by `", options.sleep, "`");
    told = true;
  }
  if (file >= 0) {
    (void)close(file);
  }
}

}  // namespace glider::runtime
