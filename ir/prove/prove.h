// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/prove/falsification/counterexample.h"
#include "ir/verify/structure.h"
#include "platforms/load/platform.h"
#include "support/diagnostics/engine.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// What is proved of a mission beyond its structure (`ir/verify`): with Z3, for every reading that
/// the platform's sensors can give. docs/verification.md says what is assumed.
namespace glider::ir::prove {

enum class Verdict : uint8_t { Proved, Refuted, Open };

/// "proved", "refuted", "undecided".
const char* word(Verdict verdict);

/// What an earlier check has found out about a requirement.
struct CachedVerdict {
  Verdict verdict = Verdict::Open;  ///< proved or open
  std::string words;                ///< RequirementVerdict::premise or reason
};

struct Options {
  /// What Z3 may spend on one question, in its own count of steps (`rlimit`): the answer does not
  /// depend on the machine. A question that takes more has no answer, and nothing is reported.
  unsigned effort = 400000;
  /// The same for a question about all runs.
  unsigned run_effort = 1000000;
  /// The standard library's file: what is odd in there is not the pilot's.
  std::optional<uint32_t> library;
  /// Also what is no mistake but worth knowing: Findings::lines.
  bool report = false;
  /// What is known of a requirement (its number) and need not be searched for; may be null.
  std::function<std::optional<CachedVerdict>(uint32_t)> cached;
  /// Is told the number of each requirement before it is judged; may be empty.
  std::function<void(uint32_t)> before_requirement = {};
};

/// A line of the report.
struct ReportLine {
  support::SourceRange range;
  std::string text;
};

/// What was found out about a requirement.
struct RequirementVerdict {
  uint32_t requirement = 0;  ///< its number
  Verdict verdict = Verdict::Open;
  std::optional<Counterexample> run;  ///< that breaks it; of Reach, that keeps it
  std::string premise = {};           ///< what a proof takes for granted beyond the assumed world
  std::string reason = {};            ///< of an open one: why it is
  bool searched = false;              ///< it took a search that may be long
  bool cached = false;                ///< Options::cached knew it
};

struct Findings {
  std::vector<ReportLine> lines;
  std::vector<RequirementVerdict> requirements;
};

/// Makes the checks of prove_passes.def. `mission` is valid and free of verification errors; the
/// platform is the one that it names. Reports GL31xx.
Findings prove(const Mission& mission, const MissionFacts& facts,
               const platforms::Platform& platform, const Options& options,
               support::DiagnosticEngine& diagnostics);

/// The cases of `always` and of states that never fire, as GL3101 and GL3103 say; of each whether
/// it is earlier ones that hide it. The same is wanted as of prove(); nothing is reported.
std::map<CasePlace, bool> casesThatNeverFire(const Mission& mission, const MissionFacts& facts,
                                             const platforms::Platform& platform,
                                             const Options& options);

}  // namespace glider::ir::prove
