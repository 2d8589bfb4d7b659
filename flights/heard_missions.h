// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "flights/heard_ticks.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace glider::flights {

/// A tick of a mission, and which tick the mission knows as the one before it.
struct KnownTick {
  HeardTick heard;
  std::optional<size_t> before;  ///< number of the tick before; none: this is the start
  /// The first tick after an outage of the SBC. Then `before` is the tick of the checkpoint; the
  /// ticks after that one have happened, but the mission knows nothing of them.
  bool resumed = false;
};

/// One mission in a flight, from its start on.
struct HeardMission {
  std::vector<KnownTick> ticks;
};

/// Records the ticks of all missions of a flight, over all starts of its SBC: a program that
/// continues from a checkpoint adds to its mission, one that begins again makes a new one.
class HeardMissions {
 public:
  /// `mission` is the mission that was compiled; it must outlive this.
  explicit HeardMissions(const ir::Mission& mission) : m_(mission) {}

  /// The SBC starts. `kept`: mission time of the newest checkpoint that it finds, s; none: it
  /// begins again.
  void starts(std::optional<double> kept);
  /// To be called after each poll of the runtime, at vehicle time `now_s`.
  void look(const GliderContext& context, double now_s);

  /// The last one is the mission that flew last.
  [[nodiscard]] const std::vector<HeardMission>& missions() const { return missions_; }

 private:
  void resume(const GliderContext& context, double now_s);
  void add(const GliderContext& context, double now_s, std::optional<size_t> before, bool resumed);

  const ir::Mission& m_;
  std::vector<HeardMission> missions_;
  std::optional<double> kept_;
  std::optional<double> last_;  ///< mission time at the newest tick since the SBC started, s
};

}  // namespace glider::flights
