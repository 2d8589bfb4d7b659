// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/way_home.h"
#include "slocum/mission_files/argument_files.h"
#include "slocum/mission_files/read.h"
#include "support/files.h"

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
  auto text = support::readFile(path);
  if (!text) {
    return std::unexpected(text.error());
  }
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const uint32_t file = sources.add(path, std::move(*text));
  auto mission = slocum::readMission(sources, file, diagnostics);
  if (mission) {
    slocum::applyArgumentFiles(*mission, std::filesystem::path(path).parent_path(), sources,
                               diagnostics);
  }
  if (diagnostics.errorCount() > 0) {
    if (show) {
      show(diagnostics, sources);
    }
    return support::fail(DiagnosticId::skeletonErrors, path, diagnostics.errorCount());
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
