// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/extctl/port.h"
#include "hooks/extctl/sentence.h"
#include "hooks/transport/byte_stream.h"
#include "runtime/abi/glider_abi.h"
#include "runtime/abi/port_mission.h"
#include "runtime/checkpoint/checkpoint.h"
#include "runtime/extctl/depth_seen.h"
#include "runtime/extctl/depth_state.h"
#include "runtime/extctl/port_writer.h"
#include "runtime/extctl/reported.h"
#include "runtime/extctl/stand_in.h"
#include "runtime/front_seat/inner_seat.h"

#include <stdint.h>

namespace glider::runtime::extctl {

struct BackseatOptions {
  /// The program has a checkpoint: when the vehicle last reported, by the time of the vehicle's
  /// mission and by its clock. Null: there is none.
  const LinkFacts* checkpoint = nullptr;
};

/// Joins a mission's program to a vehicle without the hooks, by the port that it has for a backseat
/// driver. To the program it is a vehicle that speaks the hook protocol: a stream() of its frames.
/// To the vehicle it is a backseat driver: sentences on `line`. No heap; it must not move.
class Backseat {
 public:
  /// `line` is the port. `mission` outlives this.
  Backseat(const GliderMission& mission, const GliderPortMission& port,
           const GliderByteStream& line, const BackseatOptions& options);
  Backseat(const Backseat&) = delete;
  Backseat& operator=(const Backseat&) = delete;

  /// The program's end.
  [[nodiscard]] GliderByteStream stream() { return inner_.stream(); }
  /// Counts the sentences and pairs that arrived damaged, or that no list of sensors explains.
  [[nodiscard]] const uint32_t* damaged() const { return &damaged_; }
  /// For how long the vehicle has been brought to the surface before the mission may begin, s; NaN:
  /// it is not.
  [[nodiscard]] const double* comesUpFor() const { return stand_in_.comesUpFor(); }
  /// The program's mission is over: false while the vehicle is still to be brought up.
  bool mayEnd() { return stand_in_.mayEnd(); }

 private:
  static constexpr uint32_t kMostBytes = 1024;  ///< of an answer
  static void hear(void* self);
  static void answer(void* self);
  static bool closed(void* self) { return static_cast<Backseat*>(self)->line_closed_; }
  [[nodiscard]] bool depthGoesOn(double* depth) const;
  static bool reading(void* self, uint16_t id, double* value);
  static void instruct(void* self, const hooks::Instruction& instruction);
  static void state(void* self, hooks::SeatState* state);
  static double clock(void* self);

  bool fill();
  void takeSentence();
  void takeCycle();
  void answerCycle();
  void beginMission();
  [[nodiscard]] Whereabouts whereabouts() const;
  uint32_t writeText(char* text, uint32_t capacity);
  void flush();
  [[nodiscard]] double reported(GliderRole role) const;
  [[nodiscard]] double reported(uint32_t sensor) const;

  const GliderDictionary& dictionary_;
  const GliderCompass* compass_;  ///< null: the mission has no headings
  GliderPortMission mission_;
  uint32_t start_depth_cm_;  ///< no mission begins below; 0: at any depth
  GliderByteStream line_;
  bool line_closed_ = false;
  uint32_t damaged_ = 0;
  hooks::extctl::Port port_;
  hooks::extctl::SentenceReader sentences_;
  Reported reported_;
  StandIn stand_in_;
  DepthSeen depth_seen_;
  DepthState depth_state_;
  bool wants_surface_ = false;  ///< the program commands the surface
  bool depth_moves_ = false;    ///< a depth was reported since the last command to dive
  StockCommand stock_;
  PortWriter writer_;
  bool virtual_time_ = false;
  char out_[kMostBytes];
  uint32_t out_next_ = 0, out_end_ = 0;
  bool brings_up_ = false;                    ///< what is in it brings the vehicle up
  double stuck_since_s_ = __builtin_nan("");  ///< it did not leave at once; NaN: it did
  uint8_t in_[64];
  uint32_t in_next_ = 0, in_end_ = 0;
  InnerSeat inner_;
};

}  // namespace glider::runtime::extctl
