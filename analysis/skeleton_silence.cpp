// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/way_home.h"
#include "slocum/mission_files/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace glider::analysis {
namespace {

using support::DiagnosticId;

/// s; the longest silence that hookbeh accepts
constexpr double kLongestSilence = 3600;

}  // namespace

support::Result<Silence> silenceOf(const std::string& path, const support::ShowDiagnostics& show) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const auto mission = slocum::loadMission(path, sources, diagnostics, [](auto&&...) {});
  if (!mission) {
    if (show && diagnostics.hasErrors()) {
      show(diagnostics, sources);
    }
    return std::unexpected(mission.error());
  }
  const auto hookbeh =
      std::ranges::find(mission->behaviours, "hookbeh", &slocum::BehaviourBlock::name);
  if (hookbeh == mission->behaviours.end()) {
    return support::fail(DiagnosticId::skeletonErrors, path, "it has no behavior `hookbeh`");
  }
  const double seconds = hookbeh->value("silence_secs");
  if (!(seconds > 0 && seconds <= kLongestSilence)) {
    return support::fail(DiagnosticId::skeletonErrors, path,
                         fmt::format("silence_secs must be above 0 and at most {:.0f}, not {}",
                                     kLongestSilence, seconds));
  }
  return Silence{seconds, fmt::format("silence_secs {:.4g} from {}", seconds,
                                      std::filesystem::path(path).filename().string())};
}

}  // namespace glider::analysis
