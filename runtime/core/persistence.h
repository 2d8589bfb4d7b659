// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "runtime/checkpoint/checkpoint.h"
#include "runtime/core/control.h"
#include "runtime/core/mission_clock.h"
#include "runtime/log/mission_log.h"

/// What of a running mission outlives a power cut, and whether a program that starts again goes on
/// where it was ("Checkpoints" of runtime/README.md).
namespace glider::runtime {

/// The rest of the runtime that has to do with it.
struct PersistenceParts {
  hooks::Client& client;
  Control& control;
  MissionClock& clock;
  MissionLog& log;
};

class Persistence {
 public:
  /// What `parts` refers to outlives this.
  Persistence(const Checkpoint& checkpoint, const PersistenceParts& parts)
      : parts_(parts), checkpoint_(checkpoint) {}
  Persistence(const Persistence&) = delete;
  Persistence& operator=(const Persistence&) = delete;

  /// The newest checkpoint into `context`, which is laid out for its mission. To be asked once,
  /// before the first tick.
  void look(GliderContext& context);
  /// There is a checkpoint, and hookbeh has not yet said what became of its flight: the mission
  /// neither begins nor goes on.
  [[nodiscard]] bool isUndecided() const { return found_; }
  /// Takes in a tick while it is undecided, before Control does. True if the mission goes on in
  /// this tick from `context`, the one that look() filled.
  bool decide(const hooks::VehicleTick& tick, const GliderContext& context, double sbc_time);
  /// The mission has begun: logs why a checkpoint that was there was not taken.
  void begun();
  /// What this tick leaves, to log and checkpoint; `context` is null before the mission begins. To
  /// be called before the tick is answered: what the vehicle has been told is never forgotten.
  void commit(const GliderContext* context);

 private:
  [[nodiscard]] double outageByClock(const hooks::VehicleTick& tick) const;
  void leaveControl(double outage);
  void tellVehicle(const GliderContext& context, const char* what);

  PersistenceParts parts_;
  Checkpoint checkpoint_;
  LinkFacts facts_;                          ///< of the checkpoint that was found
  bool found_ = false;                       ///< there is one, and nothing is decided about it
  LogDetail begins_anew_ = LogDetail::None;  ///< why a checkpoint that is there is not taken
  bool log_fails_ = false;
  bool not_kept_ = false;  ///< the newest could not be written
};

}  // namespace glider::runtime
