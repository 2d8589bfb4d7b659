// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/system_clock.h"
#include "runtime/abi/runtime.h"

#include <sys/types.h>

/// A mission's data on the storage card, written by a separate process: a card that stops
/// responding blocks that process, and not the heartbeat.
namespace glider::runtime {

/// The functions that access the card.
struct CardWork {
  GliderLogSink log{};
  GliderStore checkpoints{};
  /// Called once before the checkpoints are first read or written: waits until no other program's
  /// process writes them. May be null.
  void (*hold)(const GliderStore& checkpoints) = nullptr;
  /// Called in a process that replaces one that has ended: the ended process may have begun a new
  /// log without reporting it. May be null.
  void (*reopen)(const GliderLogSink& log) = nullptr;
};

/// The mission's interface to that process. Its log and checkpoints behave as those of the
/// CardWork, with one exception: after an operation that does not finish in time, all operations
/// fail at once until the card has finished it and has then rested.
class Card {
 public:
  /// The longest wait for the card in one cycle, s: less than the cycle's 4 s, so that the SBC
  /// never lags behind the vehicle.
  static constexpr double kPatience = 3;
  /// How long the card is left unused after it has responded again, s: a card that is always slow
  /// then costs one wait per minute.
  static constexpr double kRest = 60;
  /// How long a starting program waits for its checkpoints, s: the process of the previous program
  /// may still hold them, and its card may never respond again.
  static constexpr double kMostWait = 60;

  Card() = default;
  Card(const Card&) = delete;
  Card& operator=(const Card&) = delete;

  /// Starts the process; no checkpoint has more than `most_bytes`. False if no process could be
  /// started: then `work` is done in this process, however long the card takes. `patience` and
  /// `rest` in s. A process that ends later is restarted after a rest.
  bool start(const CardWork& work, uint32_t most_bytes, double patience = kPatience,
             double rest = kRest);
  /// The line to the vehicle, which a restarted process must not hold open.
  void setLine(int descriptor) { line_ = descriptor; }
  /// The log, and where checkpoints are kept; both point into this object.
  [[nodiscard]] GliderLogSink log();
  [[nodiscard]] GliderStore checkpoints();
  /// The SBC is idle: the full patience is available again, and a process that has ended is
  /// restarted if the card has rested. In virtual time patience is unlimited, because the vehicle's
  /// clock waits.
  void rested(bool virtual_time);

 private:
  enum class Task : uint32_t { LogWrite, LogSync, LogRenew, StoreRead, StoreWrite, StoreSync };
  /// Is in memory shared by both processes; the bytes follow.
  struct Request {
    Task task;
    uint32_t offset;
    uint32_t count;
    int32_t answer;
  };
  static constexpr double kForever = -1;

  static int32_t writeLog(void* self, const uint8_t* bytes, uint32_t count);
  static int32_t syncLog(void* self);
  static int32_t renewLog(void* self);
  static int32_t read(void* self, uint32_t offset, uint8_t* bytes, uint32_t count);
  static int32_t write(void* self, uint32_t offset, const uint8_t* bytes, uint32_t count);
  static int32_t sync(void* self);

  bool spawn();
  void noteGone();
  int32_t ask(Task task, uint32_t offset, const uint8_t* bytes, uint32_t count);
  void request(Task task, uint32_t offset, uint32_t count);
  /// True once the process has answered.
  bool hear(double seconds);
  bool isFree();
  [[noreturn]] void serve(int nudges, int answers);
  int32_t carryOut();
  int32_t carryOutOnStore();
  [[nodiscard]] uint8_t* bytes() const { return reinterpret_cast<uint8_t*>(request_ + 1); }

  CardWork work_;
  hooks::SystemClock clock_;
  Request* request_ = nullptr;  ///< null: there is no process
  uint32_t most_bytes_ = 0;
  pid_t process_ = -1;
  int line_ = -1;
  int nudges_ = -1;   ///< a byte for each task
  int answers_ = -1;  ///< a byte for each answer
  double patience_s_ = kPatience;
  double rest_s_ = kRest;
  double left_s_ = kPatience;
  double rests_until_s_ = 0;
  bool busy_ = false;     ///< a task was given up on, and is not done yet
  bool gone_ = false;     ///< the process has ended; another is started when the card has rested
  bool renewed_ = false;  ///< a new log has begun, which was not reported to the mission yet
  bool held_ = false;     ///< in the process: hold() was called
};

}  // namespace glider::runtime
