// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"
#include "support/diagnostics/show.h"
#include "support/result.h"

#include <string>
#include <vector>

namespace glider::analysis {

/// After how long a silence of the SBC hookbeh lets go, and where that is from.
struct Silence {
  double seconds = 0;
  std::string source;  ///< "silence_secs of skeleton.mi"
};

/// What hookbeh has if its mission file gives none.
Silence usualSilence();
/// `silence_secs` of the hookbeh in the vehicle's mission file at `path`, with the argument files
/// beside it; its mistakes are shown. GL9001, GL51xx; GL5120 if there is no hookbeh, or its silence
/// is no time.
support::Result<Silence> silenceOf(const std::string& path,
                                   const support::ShowDiagnostics& show = {});

/// What becomes of the vehicle if the SBC dies or falls silent.
struct WayHome {
  double depth_m = 0;    ///< no deeper is it then, by the mission's commands
  double surface_s = 0;  ///< from the SBC's last word until it is at the surface, at most
};

/// From where no commands lead deeper than `depth_m`: hookbeh lets go after its silence and two
/// cycles, then the vehicle's own layers climb as the platform says. For a mission file that
/// surfaces whenever nothing else commands.
WayHome wayHomeFrom(double depth_m, const platforms::Platform& platform,
                    const Silence& silence = usualSilence());

/// Lines for the report: the way home of a mission, and of states where it is shorter.
std::vector<std::string> wayHomeLines(const ir::Mission& mission,
                                      const platforms::Platform& platform, const Silence& silence);

}  // namespace glider::analysis
