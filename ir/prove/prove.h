// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/certify/certificate.h"
#include "ir/core/mission.h"
#include "ir/prove/falsification/counterexample.h"
#include "ir/verify/structure.h"
#include "ir/worlds/worlds.h"
#include "platforms/load/board.h"
#include "platforms/load/platform.h"
#include "support/diagnostics/engine.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Proofs about a mission beyond its structure (`ir/verify`): with Z3, for every reading that the
/// platform's sensors can give. docs/verification.md lists the assumptions.
namespace glider::ir::prove {

enum class Verdict : uint8_t { Proved, Refuted, Open };

/// "proved", "refuted", "undecided".
const char* word(Verdict verdict);

/// The most by which `--effort` raises the limits of proofs.
inline constexpr unsigned kMostRaised = 100;

struct Options {
  /// By how much `--effort` has raised the limits below, for hints.
  unsigned raised = 1;
  /// The resource limit of Z3 for one question, in its own count of steps (`rlimit`), so the answer
  /// does not depend on the machine. A question that exceeds it has no answer, and nothing is
  /// reported.
  unsigned effort = 400000;
  /// The same for a question about all traces.
  unsigned run_effort = 1000000;
  /// The same for all requirements of a mission together, random flights and the rest included;
  /// what it leaves is open. The checks of cases and commands may take a quarter of it on top.
  uint64_t total_effort = 40000000;
  /// The upper bound of the ticks of random flights that try to violate a requirement where a
  /// search has no answer.
  size_t random_ticks = 120000;
  /// A time limit on top, which depends on the machine: no question begins after it.
  std::optional<std::chrono::steady_clock::time_point> until;
  /// The standard library's files: findings in them are not the pilot's errors.
  std::vector<uint32_t> library;
  [[nodiscard]] bool inLibrary(const support::SourceRange& range) const {
    return std::ranges::find(library, range.file) != library.end();
  }
  /// Also report what is not an error but useful to know: Findings::lines.
  bool report = false;
  /// Where vehicles are known to start: a waypoint that is far from all of them, but near one with
  /// its coordinates exchanged, is taken for an error.
  std::vector<Position> known_starts = {};
  /// Called with the number of each requirement before it is checked; may be empty.
  std::function<void(uint32_t)> before_requirement = {};
  /// Name only the assumptions that a proof needs, not all on which it may rest.
  bool premises = true;
  /// What the SBC draws; empty: it does not count.
  std::optional<platforms::BoardPower> board = {};
  /// Also give the evidence of each proof: RequirementVerdict::evidence.
  bool evidence = false;
};

/// How a requirement was proved.
enum class Method : uint8_t {
  Invariant,       ///< Spacer found what holds after every tick
  Bound,           ///< times or depths were added up
  Configurations,  ///< from the call configurations alone
  Run,             ///< a trace that satisfies it
  Energy,          ///< by the vehicle's power table
  Geometry         ///< of the mission's waypoints
};

/// "invariant", "bound", "configurations", "run", "energy", "geometry".
const char* word(Method method);

/// What the proof of a requirement rests on, in a form that can be checked again without the prover
/// (ir/certify). Of a run and of geometry there are no invariants.
struct Evidence {
  Method method = Method::Invariant;
  std::vector<certify::Invariant> invariants;
};

/// A line of the report.
struct ReportLine {
  support::SourceRange range;
  std::string text;
  bool about_end = false;  ///< says when the mission ends
};

/// What was found out about a requirement.
struct RequirementVerdict {
  uint32_t requirement = 0;  ///< its number
  Verdict verdict = Verdict::Open;
  std::optional<Counterexample> run;      ///< that violates it; for Reach, that satisfies it
  std::string premise = {};               ///< what a proof assumes beyond the environment model
  std::string reason = {};                ///< for an undecided one: why
  bool searched = false;                  ///< it took a search that may be long
  uint64_t steps = 0;                     ///< what the search of a proof took, in Z3's own count
  std::optional<Evidence> evidence = {};  ///< of a proof that has one, with Options::evidence
  /// The numbers of the assumptions of the mission on which a proof rests: without any one of them
  /// none was found.
  std::vector<uint32_t> assumptions = {};
  /// Of a proof about geofences: how far from their edges control must be given, m.
  double start_margin_m = 0;
};

/// What a verdict rests on beyond the environment model, in one line: "assuming no outage, and
/// …"; empty: nothing.
std::string premisesOf(const RequirementVerdict& verdict, const Mission& mission);

struct Findings {
  std::vector<ReportLine> lines;
  std::vector<RequirementVerdict> requirements;
  std::map<CasePlace, bool> never_fire;  ///< as casesThatNeverFire
};

/// Runs the checks of prove_passes.def. The mission must be valid and free of verification errors;
/// the platform is the one that it names. Reports GL31xx.
Findings prove(const Worlds& worlds, const MissionFacts& facts, const Options& options,
               support::DiagnosticEngine& diagnostics);

/// The same for a mission whose worlds no one else needs.
inline Findings prove(const Mission& mission, const MissionFacts& facts,
                      const platforms::Platform& platform, const Options& options,
                      support::DiagnosticEngine& diagnostics) {
  return prove(Worlds(mission, platform), facts, options, diagnostics);
}

/// The cases of `always` and of states that never fire, as GL3101 and GL3103 report, each with
/// whether earlier cases hide it. The arguments are those of prove(); nothing is reported.
std::map<CasePlace, bool> casesThatNeverFire(const Worlds& worlds, const MissionFacts& facts,
                                             const Options& options);

}  // namespace glider::ir::prove
