// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "runtime/checkpoint/checkpoint.h"
#include "runtime/core/control.h"
#include "runtime/core/mission_clock.h"
#include "runtime/log/mission_log.h"

/// Keeps the part of a running mission that survives a power cut, and decides whether a restarted
/// program continues where it was ("Checkpoints" of runtime/README.md).
namespace glider::runtime {

/// The other parts of the runtime that it uses.
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

  /// Reads the newest checkpoint into `context`, which is laid out for its mission. Must be called
  /// once, before the first tick.
  void look(GliderContext& context);
  /// True if there is a checkpoint, and hookbeh has not yet reported the state of its flight: the
  /// mission neither begins nor continues.
  [[nodiscard]] bool isUndecided() const { return found_; }
  /// That checkpoint's link; null: there is none.
  [[nodiscard]] const LinkFacts* undecided() const { return found_ ? &facts_ : nullptr; }
  /// Takes in a tick while it is undecided, before Control does. True if the mission continues in
  /// this tick from `context`, which look() filled.
  bool decide(const hooks::VehicleTick& tick, const GliderContext& context, double sbc_time);
  /// The mission does not begin at this depth, m: reports it.
  void waits(double depth);
  /// For `seconds` the vehicle has been brought to the surface before the mission may begin:
  /// reports it in the log, and at first in the vehicle's.
  void bringsUp(double seconds);
  /// Logs an event that only some programs know, at the mission's time: `count` of them.
  void logs(LogEvent what, LogDetail detail, uint32_t count);
  /// The mission has begun: logs why an existing checkpoint was not used.
  void begun();
  /// Writes the results of this tick to log and checkpoint; `context` is null before the mission
  /// begins. A context with a failed check is not kept. Must be called before the tick is answered,
  /// so that nothing reported to the vehicle can be lost.
  void commit(const GliderContext* context);
  /// Checks the memory of the parts and, if a mission is `running` (else null), its `context`: what
  /// lives from one tick to the next. Notes in the context what failed.
  void check(const GliderContext& context, const GliderMission* running) const;
  /// A check of the program's own memory has failed: reports it in the log, and in a checkpoint by
  /// which a restarted program leaves control to the vehicle. Makes `context` again, for `mission`,
  /// with nothing in it but its time and the failed checks.
  void giveUp(GliderContext& context, const GliderMission& mission);

 private:
  [[nodiscard]] double outageByClock(const hooks::VehicleTick& tick) const;
  void leaveControl(const GliderMission& mission, bool restarted, double outage);
  void tellVehicle(double mission_time, const char* what);
  [[nodiscard]] LinkFacts facts() const;

  PersistenceParts parts_;
  Checkpoint checkpoint_;
  LinkFacts facts_;                          ///< of the checkpoint that was found
  bool found_ = false;                       ///< there is one, and it is not decided yet
  LogDetail begins_anew_ = LogDetail::None;  ///< why an existing checkpoint is not used
  bool failed_ = false;                      ///< the checkpoint found is that of a giveUp()
  bool log_fails_ = false;
  bool not_kept_ = false;  ///< the newest could not be written
};

}  // namespace glider::runtime
