// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "simulator/ports/sbc_port.h"

#include <deque>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace glider::simulator {

/// A pilot in a few lines, on the real client: dives and climbs between two depths, releases
/// control after a while.
class FakePilot {
 public:
  struct Plan {
    double top_m = 5, bottom_m = 20;
    double release_s = 1e9;  ///< mission time
    double pitch_rad = 0.4538;
    bool hovers = false;       ///< at bottom_m, instead of climbing
    bool takes_again = false;  ///< after silence, with the mission where it is
  };
  explicit FakePilot(Plan plan);
  /// Answers all frames that are there, up to the tick `most_ticks` of all: to a program the next
  /// may be there before it has looked at anything else.
  void poll(const GliderByteStream& stream, const GliderClock& clock,
            int most_ticks = std::numeric_limits<int>::max());
  [[nodiscard]] int ticks() const { return ticks_; }
  [[nodiscard]] bool closed() const { return closed_; }

 private:
  void tick(const GliderByteStream& stream);
  void steer(double depth);

  Plan plan_;
  hooks::Client client_;
  bool taken_ = false, diving_ = true, given_back_ = false, closed_ = false;
  double start_s_ = 0;
  double depth_m_ = 0;  ///< the newest reading
  int ticks_ = 0, silent_ticks_ = 0;
};

/// The pilot as an SBC in memory. `silent_from_s`: from then on it receives but does not answer, as
/// a hung board would.
class FakeSbc final : public SbcPort {
 public:
  explicit FakeSbc(FakePilot::Plan plan, double silent_from_s = 1e9, bool keeps_time = false)
      : pilot_(plan), silent_from_s_(silent_from_s), keeps_time_(keeps_time) {}

  [[nodiscard]] std::string way() const override { return "in-process"; }
  void deliver(std::span<const uint8_t> bytes, double now_s) override;
  std::vector<uint8_t> collect() override;
  void kill() override { killed_ = true; }
  void plug(bool in) override { plugged_ = in; }
  [[nodiscard]] bool keepsTime() const override { return keeps_time_; }
  [[nodiscard]] bool alive() const override { return !killed_ && !pilot_.closed(); }
  [[nodiscard]] std::string exitReason() const override {
    return killed_ ? "killed" : pilot_.closed() ? "exited with status 2" : "";
  }

 private:
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity);
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count);
  static double now(void* self) { return static_cast<FakeSbc*>(self)->now_s_; }

  FakePilot pilot_;
  double silent_from_s_;
  std::deque<uint8_t> in_;
  std::vector<uint8_t> out_;
  double now_s_ = 0;
  bool keeps_time_;
  bool plugged_ = true;
  bool killed_ = false;
};

}  // namespace glider::simulator
