// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/card.h"

#include "runtime/board/kernel.h"
#include "runtime/log/mission_log.h"

#include <errno.h>
#include <poll.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace glider::runtime {
namespace {

Card& cardOf(void* self) {
  return *static_cast<Card*>(self);
}

/// Sends one byte, which signals that there is work to do, or that it is done.
bool nudge(int descriptor) {
  const uint8_t byte = 0;
  ssize_t sent = -1;
  do {
    sent = ::write(descriptor, &byte, 1);
  } while (sent < 0 && errno == EINTR);
  return sent == 1;
}

/// Waits for such a byte; false if the other end is closed.
bool isNudged(int descriptor) {
  uint8_t byte = 0;
  ssize_t got = -1;
  do {
    got = ::read(descriptor, &byte, 1);
  } while (got < 0 && errno == EINTR);
  return got == 1;
}

}  // namespace

bool Card::start(const CardWork& work, uint32_t most_bytes, double patience, double rest) {
  work_ = work;
  most_bytes_ = most_bytes > MissionLog::kBytes ? most_bytes : MissionLog::kBytes;
  patience_s_ = left_s_ = patience;
  rest_s_ = rest;
  if (work.log.write == nullptr && work.checkpoints.write == nullptr) {
    return false;
  }
  void* shared = mmap(nullptr, sizeof(Request) + most_bytes_, PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  request_ = shared == MAP_FAILED ? nullptr : static_cast<Request*>(shared);
  if (request_ != nullptr && spawn()) {
    return true;
  }
  request_ = nullptr;
  if (work_.hold != nullptr && work_.checkpoints.write != nullptr) {
    work_.hold(work_.checkpoints);
  }
  return false;
}

bool Card::spawn() {
  int nudges[2];
  int answers[2];
  if (pipe(nudges) != 0) {
    return false;
  }
  if (pipe(answers) != 0) {
    close(nudges[0]);
    close(nudges[1]);
    return false;
  }
  const pid_t process = copyProcess();
  if (process == 0) {
    close(nudges[1]);
    close(answers[0]);
    serve(nudges[0], answers[1]);
  }
  close(nudges[0]);
  close(answers[1]);
  if (process < 0) {
    close(nudges[1]);
    close(answers[0]);
    return false;
  }
  process_ = process;
  nudges_ = nudges[1];
  answers_ = answers[0];
  gone_ = false;
  busy_ = false;
  return true;
}

/// The process has ended: the card is left unused for a while, and then another process is started.
void Card::noteGone() {
  gone_ = true;
  close(nudges_);
  close(answers_);
  (void)waitpid(process_, nullptr, WNOHANG);
  rests_until_s_ = clock_.now() + rest_s_;
}

/// The body of the other process: carries out one task after another until the mission's process is
/// gone.
void Card::serve(int nudges, int answers) {
  // This process must not use the line to the vehicle, nor react to keys at the terminal.
  close(STDIN_FILENO);
  close(STDOUT_FILENO);
  if (line_ >= 0) {
    close(line_);
  }
  ignoreSignal(SIGINT);
  if (process_ >= 0 && work_.reopen != nullptr && work_.log.write != nullptr) {
    work_.reopen(work_.log);
  }
  while (isNudged(nudges)) {
    request_->answer = carryOut();
    if (!nudge(answers)) {
      break;
    }
  }
  _exit(0);
}

int32_t Card::carryOut() {
  const GliderLogSink& log = work_.log;
  switch (request_->task) {
    case Task::LogWrite:
      return log.write(log.self, bytes(), request_->count);
    case Task::LogSync:
      return log.sync(log.self);
    case Task::LogRenew:
      return log.renew(log.self);
    case Task::StoreRead:
    case Task::StoreWrite:
    case Task::StoreSync:
      break;
  }
  return carryOutOnStore();
}

int32_t Card::carryOutOnStore() {
  const GliderStore& store = work_.checkpoints;
  if (!held_ && work_.hold != nullptr) {
    work_.hold(store);
  }
  held_ = true;
  switch (request_->task) {
    case Task::StoreRead:
      return store.read(store.self, request_->offset, bytes(), request_->count);
    case Task::StoreWrite:
      return store.write(store.self, request_->offset, bytes(), request_->count);
    case Task::StoreSync:
    case Task::LogWrite:
    case Task::LogSync:
    case Task::LogRenew:
      break;
  }
  return store.sync(store.self);
}

bool Card::hear(double seconds) {
  const double began = clock_.now();
  double passed = 0;
  int ready = 0;
  do {
    pollfd wanted{answers_, POLLIN, 0};
    const double left = seconds < 0 ? -0.001 : seconds > passed ? seconds - passed : 0.0;
    ready = poll(&wanted, 1, static_cast<int>(left * 1000));
    passed = clock_.now() - began;
  } while (ready < 0 && errno == EINTR);
  if (left_s_ >= 0) {
    left_s_ = left_s_ > passed ? left_s_ - passed : 0.0;
  }
  if (ready <= 0) {
    return false;
  }
  busy_ = false;
  if (!isNudged(answers_)) {
    noteGone();
  }
  return !gone_;
}

/// False while the card must not be used.
bool Card::isFree() {
  if (busy_ && !gone_ && hear(0)) {
    rests_until_s_ = clock_.now() + rest_s_;
    renewed_ = renewed_ || (request_->task == Task::LogRenew && request_->answer == 1);
  }
  return !gone_ && !busy_ && clock_.now() >= rests_until_s_;
}

void Card::rested(bool virtual_time) {
  left_s_ = virtual_time ? kForever : patience_s_;
  if (gone_ && clock_.now() >= rests_until_s_ && !spawn()) {
    rests_until_s_ = clock_.now() + rest_s_;
  }
}

int32_t Card::ask(Task task, uint32_t offset, const uint8_t* from, uint32_t count) {
  if (count > most_bytes_ || !isFree()) {
    return -1;
  }
  if (count > 0) {
    memcpy(bytes(), from, count);
  }
  request(task, offset, count);
  return !gone_ && hear(left_s_) ? request_->answer : -1;
}

void Card::request(Task task, uint32_t offset, uint32_t count) {
  *request_ = {task, offset, count, -1};
  busy_ = true;
  if (!nudge(nudges_)) {
    busy_ = false;
    noteGone();
  }
}

GliderLogSink Card::log() {
  const GliderLogSink& inner = work_.log;
  if (request_ == nullptr || inner.write == nullptr) {
    return inner;
  }
  return {this, writeLog, inner.sync != nullptr ? syncLog : nullptr,
          inner.renew != nullptr ? renewLog : nullptr};
}

GliderStore Card::checkpoints() {
  const GliderStore& inner = work_.checkpoints;
  return request_ == nullptr || inner.write == nullptr ? inner
                                                       : GliderStore{this, read, write, sync};
}

int32_t Card::writeLog(void* self, const uint8_t* bytes, uint32_t count) {
  return cardOf(self).ask(Task::LogWrite, 0, bytes, count);
}

int32_t Card::syncLog(void* self) {
  return cardOf(self).ask(Task::LogSync, 0, nullptr, 0);
}

/// A renewal that finished after the mission had stopped waiting for it is reported by the next
/// call.
int32_t Card::renewLog(void* self) {
  Card& card = cardOf(self);
  const bool now = card.ask(Task::LogRenew, 0, nullptr, 0) == 1;
  const bool late = card.renewed_;
  card.renewed_ = false;
  return now || late ? 1 : 0;
}

/// A program waits for its checkpoint before its mission begins. If the wait is too long, it has
/// none.
int32_t Card::read(void* self, uint32_t offset, uint8_t* bytes, uint32_t count) {
  Card& card = cardOf(self);
  if (count > card.most_bytes_ || !card.isFree()) {
    return -1;
  }
  card.request(Task::StoreRead, offset, count);
  const double patience = card.left_s_;
  const bool answered = !card.gone_ && card.hear(kMostWait);
  card.left_s_ = patience;  // this wait was outside any cycle
  if (!answered) {
    return -1;
  }
  // Another process wrote it.
  const int32_t got = card.request_->answer;
  if (got < 0 || static_cast<uint32_t>(got) > count) {
    return -1;
  }
  memcpy(bytes, card.bytes(), static_cast<uint32_t>(got));
  return got;
}

int32_t Card::write(void* self, uint32_t offset, const uint8_t* bytes, uint32_t count) {
  return cardOf(self).ask(Task::StoreWrite, offset, bytes, count);
}

int32_t Card::sync(void* self) {
  return cardOf(self).ask(Task::StoreSync, 0, nullptr, 0);
}

}  // namespace glider::runtime
