// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/interruption.h"

#include <atomic>
#include <signal.h>

namespace glider::driver {
namespace {

std::atomic<int> came = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a handler may set it");

void note(int number) {
  came = number;
}

void handle(void (*handler)(int), int flags) {
  struct sigaction action{};
  action.sa_handler = handler;
  action.sa_flags = flags;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

Interruption::Interruption(Second second) {
  came = 0;
  handle(note, static_cast<int>(SA_RESTART | (second == Second::Ends ? SA_RESETHAND : 0U)));
}

Interruption::~Interruption() {
  handle(SIG_DFL, 0);
}

int Interruption::signal() {
  return came;
}

}  // namespace glider::driver
