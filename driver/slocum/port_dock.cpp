// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/slocum/port_dock.h"

#include "driver/output/executable.h"
#include "vehicles/slocum/dock/dock.h"

#include <algorithm>

namespace glider::driver {

vehicles::DockResult checkPortAtDock(const PortFolder& folder, const FolderPort& port,
                                     const compiler::Optimised& mission, vehicles::DockPart part,
                                     double seconds, const vehicles::DockHost& host) {
  slocum::DockTimes times;
  times.whole_s = seconds;
  times.listen_s = std::min(times.listen_s, seconds / 4);
  times.steer_s = std::min(times.steer_s, seconds);
  return slocum::checkAtDock({.plan = port.plan,
                              .sensors = port.sensors,
                              .platform = mission.platform(),
                              .program = "sbc/" + stemOf(folder.mission.string()),
                              .part = part,
                              .times = times},
                             host);
}

}  // namespace glider::driver
