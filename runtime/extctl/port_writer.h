// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/extctl/port.h"
#include "runtime/extctl/stock_command.h"

#include <stdint.h>

namespace glider::runtime::extctl {

/// Writes the commands for the vehicle. Nothing on the port is acknowledged, and values that are
/// written together arrive in the flight computer seconds apart. So a value that changes is written
/// again in the next cycles, all of them every 16 s, and a depth is written only when it agrees
/// with every depth that may be in force at the other end of the yo: no mixture of old and new has
/// targets that contradict each other, unless three sentences in a row are lost.
class PortWriter {
 public:
  /// `knows_start`: the vehicle still has what its mission file says, because no program has
  /// written anything else since it was started.
  PortWriter(const GliderPortMission& port, bool knows_start);

  /// The command at `now_s` by the vehicle's clock.
  void tell(const StockCommand& command, double now_s);
  /// All of it is written again with the next answer, and takes its time again: the vehicle's end
  /// of the port has restarted, and what was on its way is lost.
  void forget();
  /// The wish to surface is written in each answer from now on.
  void insist();
  /// What the SBC says of its mission in each answer, for the vehicle's log.
  struct Mission {
    uint32_t state = 0;  ///< from 1; 0: it does not fly
    double time_s = 0;
  };
  /// The sentences that end the answer to a control cycle, into `text`; returns their size. Without
  /// `steers` they have only what the SBC says of its mission.
  uint32_t write(const Mission& mission, bool steers, char* text, uint32_t capacity);

  /// The most that write() needs.
  static constexpr uint32_t kMostBytes = 512;
  /// How often a value that has changed is written.
  static constexpr uint8_t kTimes = 3;
  static constexpr double kAgainSecs = 16;

 private:
  struct Value {
    double told = __builtin_nan("");
    double wanted = __builtin_nan("");
    double pending_s = 0;  ///< since when another value waits
    uint8_t due = 0;       ///< times that it is still to be written
  };

  /// The depths that may be in force at one end of the yo: the newest one written, and those
  /// before it for as long as a value may be on its way.
  class InForce {
   public:
    void tell(double depth_m, double now_s);
    /// The deepest and the shallowest of them; there is at least one.
    void range(double now_s, double* shallowest, double* deepest) const;
    /// What had not settled at `then_s` settles again from `now_s` on.
    void unsettle(double then_s, double now_s);

   private:
    static constexpr uint32_t kMost = 24;  ///< more than there are control cycles in that time
    double depths_m_[kMost];
    double until_s_[kMost];  ///< replaced then; that of the newest does not count
    uint32_t count_ = 0;
  };

  [[nodiscard]] Value& at(hooks::extctl::PortSensor sensor) {
    return values_[static_cast<uint32_t>(sensor)];
  }
  [[nodiscard]] bool isOver(double since_s, double seconds) const;
  void want(Value& value, double wanted);
  void tellNow(Value& value);
  void begin();
  void tellDepths(const StockCommand& command);
  [[nodiscard]] bool mayDive(const Value& value);
  void tellWhetherToSurface(const StockCommand& command);
  uint32_t writeValues(uint32_t first, char* text, uint32_t capacity);
  uint32_t writeModes(char* text, uint32_t capacity);

  bool modes_;
  double greatest_depth_m_;
  Value values_[hooks::extctl::kWrittenSensors];
  Value mode_;
  InForce dives_, climbs_;
  bool knows_start_;
  bool begun_ = false;    ///< a command was written
  bool forgets_ = false;  ///< forget() since then
  double now_s_ = 0;
  double all_s_ = -kAgainSecs;  ///< when all were last written
  uint32_t beat_ = 0;
};

}  // namespace glider::runtime::extctl
