// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/run.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace glider::analysis::check {

using Subject = report::Remark::Subject;

/// How the vehicle comes up without the SBC and, if no mission file of the vehicle says it better,
/// which commands it would usually refuse.
support::Result<void> wayHome(Run& run) {
  const vehicles::OwnMission* own = run.file.own_mission.get();
  if (own == nullptr) {
    run.remark(fmt::format("what the vehicle does if the SBC stops responding is not known: its "
                           "platform `{}` names no known family of vehicles",
                           run.platform().name),
               Subject::WayHome);
    return {};
  }
  if (auto line = own->endlessLine(run.worlds().written)) {
    run.remark(std::move(*line), Subject::End);
  }
  for (std::string& line : own->wayHomeLines(run.worlds().widest)) {
    run.remark(std::move(line), Subject::WayHome);
  }
  for (std::string& line : own->refusedLines(run.mission())) {
    run.remark(std::move(line));
  }
  return {};
}

}  // namespace glider::analysis::check
