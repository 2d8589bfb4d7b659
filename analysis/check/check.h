// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "ir/prove/prove.h"
#include "report/findings/findings.h"
#include "support/source_manager.h"
#include "vehicles/own_mission.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glider::analysis {

/// How a mission is checked.
struct CheckOptions {
  bool report = false;               ///< also findings that are not errors, and the budgets
  std::vector<std::string> targets;  ///< of the budget; empty: all boards of the vehicle
  /// The vehicle's mission file (`--mi`), without errors; empty: that of the scenario.
  std::string own_mission;
  std::string scenario;                ///< whose start and mission file apply; empty: none
  std::optional<double> duration_s;    ///< of flights in the scenario; empty: as it says
  std::vector<std::string> user_code;  ///< of the budget: what has the mission's `extern` names
  unsigned effort = 1;                 ///< multiplies the resource limits of proofs
  double timeout_s = 0;                ///< of the proofs about a mission; 0: none
  bool evidence = false;               ///< of each proof; the cache has none
};

/// A mission's file with all findings; `found` points into `compilation`, which is empty if the
/// file could not be read.
struct CheckedFile {
  std::optional<compiler::Compilation> compilation;
  ir::prove::Findings proved;
  report::CheckedMission found;
  /// On what proofs rest with the vehicle's mission file: "with skeleton.mi, in water of 35 m or
  /// more"; empty if none is named.
  std::string vehicle_premise = {};
  /// What the vehicle flies by itself: of the file that the options name, or of their scenario, or
  /// what is usual for its family; null: its family is not known.
  std::unique_ptr<vehicles::OwnMission> own_mission = {};
};

/// Receives what a check does, which can take seconds. All calls come from the thread of
/// checkMission.
class CheckObserver {
 public:
  CheckObserver() = default;
  CheckObserver(const CheckObserver&) = delete;
  CheckObserver& operator=(const CheckObserver&) = delete;
  virtual ~CheckObserver() = default;

  /// What is done from now on, in a few words: "proving 3 of 5: require exit within 90 min".
  virtual void at(const std::string& /*work*/) {}
  /// The errors in a file beside the mission, a scenario's.
  virtual void show(const support::DiagnosticEngine& /*diagnostics*/,
                    const support::SourceManager& /*sources*/) {}
};

/// Checks the mission at `path`, `-` for standard input: its text, its structure, and what can be
/// proved about it, in the steps of check_steps.def. An I/O or system error is in
/// CheckedFile::found.
CheckedFile checkMission(const std::string& path, const CheckOptions& options,
                         CheckObserver& observer);

/// The same for a mission that is compiled already; messages call it `name`.
CheckedFile checkCompilation(const std::string& name, compiler::Compilation compiled,
                             const CheckOptions& options, CheckObserver& observer);

}  // namespace glider::analysis
