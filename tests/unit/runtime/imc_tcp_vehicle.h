// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/unit/hooks/imc_described.h"
#include "tests/unit/runtime/tcp_peer.h"

#include <gtest/gtest.h>

#include <bit>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// A vehicle that is steered by IMC and is reached over TCP. It speaks by the second codec.
namespace glider::runtime::testing {

using imc_described::Bytes;
using imc_described::Leaves;

inline constexpr uint64_t kBackSeat = 0x4001;  ///< the SBC's address

inline uint64_t bitsOf(double value) {
  return std::bit_cast<uint64_t>(value);
}
inline uint64_t bitsOf(float value) {
  return std::bit_cast<uint32_t>(value);
}

class TcpVehicle {
 public:
  /// A second of the vehicle's passes.
  void second() {
    now_s += 1;
    if (peer.accept()) {
      rest_.clear();
      swallows = swallows && swallows_always;
    }
    if (plan && now_s - heard_s_ > 15) {
      say(480, follow(6));
      plan.reset();
      told.reset();
    }
    if (speaks) {
      sayState();
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
  /// A packet of the vehicle.
  [[nodiscard]] Bytes packet(uint16_t id, const Leaves& leaves) const {
    using hooks::imc::ByteOrder;
    return imc_described::packetOf(id,
                                   {.time_s = now_s,
                                    .source = 0x1E,
                                    .source_entity = 1,
                                    .destination = 0xFFFF,
                                    .destination_entity = 255},
                                   imc_described::payloadOf(id, leaves, ByteOrder::Little),
                                   ByteOrder::Little);
  }
  [[nodiscard]] double toldDepth() const {
    return told ? static_cast<double>(std::bit_cast<float>(
                      static_cast<uint32_t>(std::get<uint64_t>(told->at("z.value")))))
                : -1;
  }

  TcpPeer peer;
  double now_s = 1.7e9, depth_m = 0.2, temperature = 20;
  bool speaks = true;
  bool swallows = false;         ///< until the next connection: takes all bytes and obeys none
  bool swallows_always = false;  ///< on the next connections too
  std::optional<std::string> plan;
  std::optional<Leaves> told;  ///< the Reference
  int references = 0, starts = 0, stops = 0;
  std::function<void()> work = [] {};  ///< the program has time for what has arrived
  int moments_ms = 1;                  ///< real time to wait for an answer, up to 20 times

 private:
  void say(uint16_t id, const Leaves& leaves) {
    if (peer.isConnected()) {
      peer.send(packet(id, leaves));
    }
  }
  [[nodiscard]] Leaves follow(uint8_t state) const {
    Leaves leaves{{"control_src", kBackSeat},
                  {"control_ent", uint64_t{255}},
                  {"reference?", uint64_t{told.has_value()}},
                  {"state", uint64_t{state}},
                  {"proximity", uint64_t{0}}};
    if (told) {
      for (const auto& [name, value] : *told) {
        leaves["reference." + name] = value;
      }
    }
    return leaves;
  }
  void sayState() {
    say(560, {{"state", uint64_t{plan ? 3U : 1U}},
              {"plan_id", plan.value_or("")},
              {"plan_eta", uint64_t{0}},
              {"plan_progress", uint64_t{0}},
              {"man_id", std::string()},
              {"man_type", uint64_t{0}},
              {"man_eta", uint64_t{0}},
              {"last_outcome", uint64_t{0}}});
    if (plan) {
      say(480, follow(2));
    }
    say(263, {{"value", bitsOf(static_cast<float>(temperature))}});
    say(508, {{"medium", uint64_t{2}}});
    Leaves state;
    for (const char* name : {"height", "x", "y", "z", "phi", "theta", "psi", "u", "v", "w", "vx",
                             "vy", "vz", "p", "q", "r"}) {
      state[name] = uint64_t{0};
    }
    state["lat"] = bitsOf(0.72);
    state["lon"] = bitsOf(-0.15);
    state["depth"] = bitsOf(static_cast<float>(depth_m));
    state["alt"] = bitsOf(-1.0F);
    say(350, state);
  }
  /// What was said may take a moment to arrive, and so may the answer.
  void exchange() {
    constexpr int kMostRounds = 20;
    answered_ = false;
    if (!peer.isConnected()) {
      usleep(static_cast<useconds_t>(1000 * moments_ms));
    }
    for (int round = 0; round < kMostRounds && !answered_; ++round) {
      work();
      obey(peer.receive(round == 0 || !speaks ? 0 : moments_ms));
    }
  }
  void obey(const Bytes& bytes) {
    answered_ = answered_ || (swallows && !bytes.empty());
    if (swallows) {
      return;
    }
    rest_.insert(rest_.end(), bytes.begin(), bytes.end());
    constexpr size_t kHead = 20, kCrc = 2;
    while (rest_.size() >= kHead + kCrc) {
      ASSERT_TRUE(rest_[0] == 0x54 && rest_[1] == 0xFE) << "a connection begins with a packet";
      const size_t size = rest_[4] + 256U * rest_[5];
      if (rest_.size() < kHead + size + kCrc) {
        return;
      }
      const auto at = [&](size_t where) { return rest_.begin() + static_cast<ptrdiff_t>(where); };
      const Bytes head(at(0), at(kHead + size));
      ASSERT_EQ(imc_described::slowCrc(head), rest_[kHead + size] + 256U * rest_[kHead + size + 1]);
      obey(static_cast<uint16_t>(rest_[2] + 256U * rest_[3]), Bytes(at(kHead), at(kHead + size)));
      rest_.erase(at(0), at(kHead + size + kCrc));
    }
  }
  void obey(uint16_t id, const Bytes& payload) {
    const auto leaves = imc_described::leavesOf(id, payload, hooks::imc::ByteOrder::Little);
    ASSERT_TRUE(leaves.has_value()) << id;
    heard_s_ = id == 559 || id == 479 ? now_s : heard_s_;
    if (id == 559) {
      const bool start = std::get<uint64_t>(leaves->at("op")) == 0;
      ++(start ? starts : stops);
      plan = start ? std::optional(std::get<std::string>(leaves->at("plan_id"))) : std::nullopt;
      told.reset();
    } else if (id == 479) {
      ++references;
      told = plan ? leaves : std::nullopt;
    }
    answered_ = answered_ || id == 150;
  }

  Bytes rest_;
  double heard_s_ = 0;
  bool answered_ = false;
};

}  // namespace glider::runtime::testing
