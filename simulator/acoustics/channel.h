// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/acoustics/acoustic_frame.h"
#include "simulator/acoustics/modem_settings.h"
#include "simulator/acoustics/trouble.h"
#include "simulator/faults/faults.h"
#include "simulator/vehicle/true_place.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace glider::simulator {

/// Why a packet was not received.
enum class Loss : uint8_t {
  None,       ///< it was received
  Sending,    ///< the receiver was sending: half duplex
  Jammed,     ///< by noise in the water
  Collision,  ///< with another frame
  Faint,      ///< by chance; more often far away
  Off,        ///< the receiver had no power for the whole of it
};

/// A packet that has ended at a receiver: the one that announces a frame, or the frame.
struct Reception {
  bool is_frame = false;
  bool announced = false;  ///< of a frame: its announcement was received
  double begin_s = 0;      ///< when the announcement began to arrive
  double end_s = 0;
  Loss loss = Loss::None;
  AcousticFrame frame;
};

/// The probability that a modem of this range does not receive a frame from so far away, for no
/// other reason.
double faintLoss(double range_m, double greatest_range_m);

/// The water between the modems of several vehicles, which have numbers. A frame arrives after the
/// time that sound needs. Two frames that overlap at a receiver destroy each other, also when one
/// of them comes from too far away to be received. Who sends receives nothing.
///
/// What is sent in a step of the simulation is received in a later one, and places are those at the
/// begin of the step. So the result does not depend on the order of the vehicles within a step.
class Channel {
 public:
  static constexpr double kSoundSpeed = 1500;  ///< m/s

  explicit Channel(uint64_t seed, AcousticTrouble trouble = {})
      : seed_(seed), trouble_(std::move(trouble)) {}

  /// Where a vehicle is, at the begin of each step; only then it can send and receive.
  void place(uint32_t vehicle, const TruePlace& place) { nodes_[vehicle].place = place; }
  /// At these times, noise in its water hides all that arrives at a vehicle.
  void jam(uint32_t vehicle, std::vector<Span> when) { jammed_[vehicle] = std::move(when); }
  /// It is out of the water.
  void leave(uint32_t vehicle) { nodes_.erase(vehicle); }

  /// Sends an announcement at `now_s`, and `frame` behind it; a mini packet has none.
  void send(uint32_t vehicle, double now_s, const AcousticFrame& frame,
            const ModemSettings& settings);
  /// What has ended at a vehicle by `now_s` and was not taken yet, in the order of its ends. A
  /// frame from beyond the range is not there.
  std::vector<Reception> take(uint32_t vehicle, double now_s);

 private:
  struct Arrival {
    double begin_s = 0;
    double announced_s = 0;  ///< the end of the announcement
    double end_s = 0;
    uint32_t sender = 0;
    bool in_range = false;
    bool faint = false;
    bool announced = false;  ///< the announcement was received
    bool announcement_taken = false, frame_taken = false;
    AcousticFrame frame;
  };
  struct Node {
    TruePlace place;
    uint32_t sent = 0;  ///< frames
    std::vector<Span> sending;
    std::vector<Arrival> arrivals;
  };
  [[nodiscard]] Loss lossOf(uint32_t vehicle, const Arrival& arrival, const Span& packet) const;
  [[nodiscard]] bool isFaint(uint32_t sender, uint32_t frame, uint32_t receiver, double probability,
                             uint32_t reason) const;
  static void forget(Node& node, double now_s);

  uint64_t seed_;
  AcousticTrouble trouble_;
  // By the number of the vehicle.
  std::map<uint32_t, std::vector<Span>> jammed_;
  std::map<uint32_t, Node> nodes_;
};

}  // namespace glider::simulator
