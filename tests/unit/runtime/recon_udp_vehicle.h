// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/unit/hooks/recon_described.h"
#include "tests/unit/runtime/udp_peer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>

/// A vehicle that is steered by RECON and is reached over UDP. It speaks by the second codec.
namespace glider::runtime::testing {

class ReconUdpVehicle {
 public:
  /// A second of the vehicle's passes.
  void second() {
    now_s += 1;
    depth_m += std::clamp((obeys() ? told_depth_m : 0) - depth_m, -2.0, 2.0);
    if (speaks) {
      speak();
    }
    exchange();
  }
  void seconds(int count) {
    for (int i = 0; i < count; ++i) {
      second();
    }
  }
  /// Seconds until `holds`; `most` if it does not.
  template <typename Condition>
  int secondsUntil(Condition holds, int most) {
    int count = 0;
    for (; count < most && !holds(); ++count) {
      second();
    }
    return count;
  }
  /// It begins again: without an override and without the knowledge of any goal.
  void restart(int seconds_off) {
    peer.close();
    mode = kLaunched;
    told_depth_m = 0;
    for (int i = 0; i < seconds_off; ++i) {
      now_s += 1;
      depth_m = std::max(0.0, depth_m - 2);
      work();
    }
    ASSERT_TRUE(peer.open());
  }
  void say(const std::string& name, const recon_described::Values& values) const {
    peer.send(recon_described::lineOf(name, values));
  }
  [[nodiscard]] recon_described::Values state() const {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    recon_described::Values values;
    for (const char* name :
         {"depth_goal_m", "altitude_m", "pitch_deg", "roll_deg", "rpm", "rpm_goal", "speed_m_s",
          "heading_rate_deg_s", "heading_goal_deg", "leg"}) {
      values[name].number = kNaN;
    }
    constexpr int64_t kDay = 86400;
    values["time_s"].number = static_cast<double>(static_cast<int64_t>(now_s) % kDay);
    values["latitude_deg"].number = 41;
    values["longitude_deg"].number = -8.5;
    values["depth_m"].number = depth_m;
    values["heading_deg"].number = 30;
    values["mode"].number = mode;
    return values;
  }
  [[nodiscard]] bool obeys() const { return mode == kOverride; }

  static constexpr int kLaunched = 0x01, kOverride = 0x0D;
  UdpPeer peer;
  double now_s = 1.7e9, depth_m = 0;
  int mode = kLaunched;
  double told_depth_m = 0;
  int goals = 0, asks = 0, ends = 0, alive = 0, queries = 0;
  double shortest_pause_s = 1;
  bool speaks = true;
  std::function<void()> work = [] {};  ///< the program has time for what has arrived
  int answer_ms = 20;                  ///< real time to wait for an answer
  int pause_ms = 5;                    ///< and then for more of it

 private:
  void speak() {
    if (queries > times_) {
      times_ = queries;
      say("TimeSet", {{"unix_s", {now_s, ""}}});
    }
    say("State", state());
  }
  /// An answer is over when nothing more comes for a while.
  void exchange() {
    work();
    for (int wait_ms = answer_ms;; wait_ms = pause_ms) {
      const auto datagrams = peer.receive(wait_ms);
      if (datagrams.empty()) {
        return;
      }
      for (const Datagram& one : datagrams) {
        shortest_pause_s = std::min(shortest_pause_s, one.time_s - newest_s_);
        newest_s_ = one.time_s;
        obey(one.bytes);
      }
    }
  }
  void obey(const std::string& datagram) {
    using recon_described::valuesOf;
    if (valuesOf("HeadingGoal", datagram) || valuesOf("SpeedGoal", datagram)) {
      return;
    }
    if (const auto depth = valuesOf("DepthGoal", datagram)) {
      told_depth_m = depth->at("depth_m").number;
      ++goals;
    } else if (const auto override_ = valuesOf("Override", datagram)) {
      const bool on = override_->at("on").number != 0;
      ++(on ? asks : ends);
      mode = on ? kOverride : kLaunched;
    } else if (valuesOf("KeepAlive", datagram)) {
      ++alive;
    } else if (valuesOf("TimeQuery", datagram)) {
      ++queries;
    } else {
      ADD_FAILURE() << "a datagram is one line: " << datagram;
    }
  }

  int times_ = 0;
  double newest_s_ = 0;
};

}  // namespace glider::runtime::testing
