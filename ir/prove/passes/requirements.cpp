// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `requirements`: a verdict on each `require`: proved, refuted (GL3110) or undecided
// (GL3111). In: what all passes before have left, and the budget Proof::searches, which no other
// pass takes from. Out: Findings::requirements, with the trace, the premise, the assumptions and
// the evidence of each.
//
// Order: what needs no search (Insight, structure, geometry), then Spacer over all traces, then
// random flights; what is proved helps the rest. Proofs are for an SBC whose power may be cut; a
// counterexample without power cuts is preferred. What can go wrong is only that no verdict is
// found: a trace of Spacer is replayed (concretize) before it refutes anything. A mission with
// assumptions is checked with and without them, so that a proof names only those that it needs
// (CheckUnderAssumptions). README.md has the arguments.

#include "ir/core/under_assumptions.h"
#include "ir/prove/abstract/depth_bound.h"
#include "ir/prove/abstract/entered_after.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/encoding/cone_of_influence.h"
#include "ir/prove/encoding/known_roughly.h"
#include "ir/prove/encoding/safety_properties.h"
#include "ir/prove/evidence/evidence.h"
#include "ir/prove/evidence/needed_assumptions.h"
#include "ir/prove/falsification/random_flight.h"
#include "ir/prove/geometry/geofences.h"
#include "ir/prove/passes.h"
#include "ir/prove/passes/advice.h"
#include "ir/prove/passes/insight.h"
#include "ir/prove/passes/violation_report.h"
#include "support/diagnostics/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace glider::ir::prove {
namespace {

using support::DiagnosticId;

/// A question about all traces is not even written if more expressions than this matter to it.
constexpr size_t kMostSearched = 30000;
/// For a requirement without a time, s.
constexpr double kLongFlight = 4 * 3600;

/// What naming only the needed assumptions may take, beside what the proofs take.
constexpr double kShareOfPremises = 0.25;

class CheckUnderAssumptions;

class RequirementCheck {
 public:
  /// `bare`: of the mission without its assumptions; null if it has none. It must outlive this.
  explicit RequirementCheck(Proof& proof, RequirementCheck* bare = nullptr)
      : proof_(proof),
        bare_(bare),
        m_(proof.proof_context.mission),
        search_effort_(proof.options.run_effort),
        premises_(budgetOf(proof.options, kShareOfPremises)),
        deepest_(std::ranges::max(deepestByState(proof.proof_context))) {}

  /// First what needs no search, then the searches. What a search has proved may prove others.
  void run() {
    std::vector<RequirementVerdict>& verdicts = proof_.findings.requirements;
    for (uint32_t i = 0; i < m_.requirements.size(); ++i) {
      const bool bare = bare_ != nullptr && bare_->provesAtOnce(i);
      auto found = bare ? std::optional(RequirementVerdict{0, Verdict::Proved, std::nullopt})
                        : judgeAtOnce(m_.requirements[i]);
      waiting_.push_back(!found);
      bare_proved_.push_back(bare);
      verdicts.push_back(found.value_or(RequirementVerdict()));
      verdicts.back().requirement = i;
    }
    for (const uint32_t i : waitingInOrder()) {
      if (proof_.options.before_requirement) {
        proof_.options.before_requirement(i);
      }
      verdicts[i] = judge(m_.requirements[i]);
      if (bare_ != nullptr && verdicts[i].verdict == Verdict::Open) {
        judgeBare(i, verdicts[i]);
      }
      verdicts[i].requirement = i;
      if (verdicts[i].verdict == Verdict::Proved && m_.requirements[i].geofences.empty()) {
        insight().know(m_.requirements[i]);
        fresh_ = true;
      }
    }
    for (RequirementVerdict& verdict : verdicts) {
      settle(verdict);
      addPremises(verdict);
    }
    if (proof_.options.evidence) {
      addEvidence(verdicts);
    }
  }

  /// A proof under fewer assumptions.
  struct RepeatedProof {
    bool proved = false;
    std::optional<Evidence> evidence;
  };

  /// Whether what was proved under more assumptions, `was`, is proved under these too; `effort`:
  /// the limit of a search. Nothing is reported.
  RepeatedProof provesAgain(const RequirementVerdict& was, unsigned effort) {
    const unsigned usual = std::exchange(search_effort_, effort);
    RepeatedProof again = provedAgain(was);
    search_effort_ = usual;
    return again;
  }

  [[nodiscard]] Proof& proof() { return proof_; }

 private:
  /// The result of a question about all traces; `run` is a trace that was checked on the
  /// interpreter.
  struct Search {
    RunsAnswer answer;
    std::optional<Counterexample> run;
  };

  /// The requirements that a search has to decide. Of several `surfaces every`, what is proved
  /// about one holds for every longer time, and what violates it violates every shorter: so the
  /// middle one comes first, and few of them take a search.
  [[nodiscard]] std::vector<uint32_t> waitingInOrder() const {
    std::vector<uint32_t> order;
    std::vector<uint32_t> surfacing;
    for (uint32_t i = 0; i < m_.requirements.size(); ++i) {
      if (waiting_[i]) {
        order.push_back(i);
        if (m_.requirements[i].kind == RequirementKind::SurfacesEvery) {
          surfacing.push_back(i);
        }
      }
    }
    std::ranges::stable_sort(surfacing, {}, [&](uint32_t i) { return m_.requirements[i].seconds; });
    std::vector<uint32_t> middle_first;
    std::deque<std::pair<size_t, size_t>> parts{{0, surfacing.size()}};
    for (; !parts.empty(); parts.pop_front()) {
      const auto [from, to] = parts.front();
      if (from < to) {
        const size_t middle = (from + to) / 2;
        middle_first.push_back(surfacing[middle]);
        parts.emplace_back(from, middle);
        parts.emplace_back(middle + 1, to);
      }
    }
    size_t next = 0;
    for (uint32_t& number : order) {
      if (m_.requirements[number].kind == RequirementKind::SurfacesEvery) {
        number = middle_first[next++];
      }
    }
    return order;
  }

  /// The flight without power cuts that violated another `surfaces every`, as far as it violates
  /// this one.
  [[nodiscard]] std::optional<Counterexample> alsoSubmerged(const Requirement& requirement) const {
    return requirement.kind == RequirementKind::SurfacesEvery && submerged_
               ? concretize(*submerged_, proof_.proof_context, proof_.facts.stack_depth,
                            requirement)
               : std::nullopt;
  }

  RepeatedProof provedAgain(const RequirementVerdict& was) {
    const Requirement& requirement = m_.requirements[was.requirement];
    if (!requirement.geofences.empty()) {
      const RequirementVerdict found = provedAreas(areasOf(requirement));
      const bool proved = found.verdict == Verdict::Proved && found.premise == was.premise;
      return {proved, std::nullopt};
    }
    if (provesAtOnce(was.requirement)) {
      return {true,
              proof_.options.evidence ? evidences().seen(requirement, false, false) : std::nullopt};
    }
    if (!was.searched) {
      return {};
    }
    // Only a proof counts: no counterexample is made concrete.
    const ProofContext& context = insight().context();
    const ConeOfInfluence relevance = relevanceOf(requirement, context);
    RunsAnswer answer = ask(requirement, context, relevance);
    if (answer.bad == Answer::Yes && !relevance.vehicle && readsDepth(relevance, context)) {
      answer = ask(requirement, context, withVehicle(requirement, context));
    }
    if (answer.bad != Answer::No) {
      return {};
    }
    return {true, wantsInvariants() ? std::optional(evidences().searched(
                                          requirement, std::move(answer.invariants)))
                                    : std::nullopt};
  }

  void keepSubmerged(const Requirement& requirement, const Search& found) {
    if (requirement.kind == RequirementKind::SurfacesEvery && found.run) {
      submerged_ = found.answer.run;
    }
  }

  /// Without a search, and without a report where it is violated.
  [[nodiscard]] bool provesAtOnce(uint32_t number) {
    const Requirement& requirement = m_.requirements[number];
    return requirement.kind == RequirementKind::StackAtMost
               ? proof_.facts.stack_depth <= requirement.depth
               : easilyProved(requirement) || isSeen(requirement);
  }

  /// Monitors of assumptions make a search longer: it may succeed without them.
  void judgeBare(uint32_t number, RequirementVerdict& verdict) {
    const Requirement& requirement = bare_->m_.requirements[number];
    if (!restsOnWatches(requirement) || proof_.searches.isUsedUp()) {
      return;
    }
    Search found = bare_->search(requirement, bare_->insight().context());
    if (found.answer.bad == Answer::No) {
      verdict = {number, Verdict::Proved, std::nullopt};
      verdict.searched = true;
      bare_proved_[number] = true;
      if (wantsInvariants()) {
        verdict.evidence =
            bare_->evidences().searched(requirement, std::move(found.answer.invariants));
      }
    }
  }

  /// The assumptions that a proof rests on: of those that it may rest on, the ones without which
  /// none was found. A flight that reaches a state does so under any assumptions (but see prove()).
  void addPremises(RequirementVerdict& verdict) {
    const uint32_t number = verdict.requirement;
    if (bare_ == nullptr || bare_proved_[number] || verdict.verdict != Verdict::Proved ||
        verdict.run) {
      return;
    }
    for (uint32_t i = 0; i < m_.assumptions.size(); ++i) {
      if (matters(m_.assumptions[i], number)) {
        verdict.assumptions.push_back(i);
      }
    }
    if (!proof_.options.premises) {
      return;
    }
    verdict.assumptions = neededAssumptions(
        verdict.assumptions, [&](const auto& fewer) { return isProvedUnder(fewer, verdict); });
  }

  /// Then its evidence rests only on these.
  bool isProvedUnder(const std::vector<uint32_t>& fewer, RequirementVerdict& verdict);

  [[nodiscard]] bool matters(const Assumption& assumption, uint32_t number) {
    const bool of_areas = !m_.requirements[number].geofences.empty();
    switch (assumption.kind) {
      case AssumptionKind::StartDepth:
        return !of_areas;
      case AssumptionKind::StartInside:
      case AssumptionKind::Current:
        return of_areas;
      case AssumptionKind::Outage:
      case AssumptionKind::Range:
        return true;
      case AssumptionKind::Always:
        return restsOnWatches(bare_->m_.requirements[number]);
    }
    return true;
  }

  [[nodiscard]] EvidenceBuilder& evidences() {
    if (!evidences_) {
      evidences_.emplace(proof_.proof_context, proof_.ending.bound());
    }
    return *evidences_;
  }

  /// Of the proofs that have none yet.
  void addEvidence(std::vector<RequirementVerdict>& verdicts) {
    for (RequirementVerdict& verdict : verdicts) {
      if (verdict.verdict == Verdict::Proved && !verdict.evidence &&
          bare_proved_[verdict.requirement]) {
        verdict.evidence =
            bare_->evidences().seen(bare_->m_.requirements[verdict.requirement], false, false);
      } else if (verdict.verdict == Verdict::Proved && !verdict.evidence) {
        verdict.evidence = evidences().seen(m_.requirements[verdict.requirement],
                                            verdict.run.has_value(), waiting_[verdict.requirement]);
      }
    }
  }

  /// A requirement left undecided may follow from one that was proved after it.
  void settle(RequirementVerdict& verdict) {
    const Requirement& requirement = m_.requirements[verdict.requirement];
    if (verdict.verdict != Verdict::Open) {
      return;
    }
    if (fresh_ && isSeen(requirement)) {
      verdict = {verdict.requirement, Verdict::Proved, std::nullopt};
      return;
    }
    auto warning = proof_.diagnostics.report(DiagnosticId::requirementOpen, requirement.range);
    warning.note(requirement.range, verdict.reason);
    if (requirement.seconds > 0 && requirement.kind != RequirementKind::SurfacesEvery) {
      noteLateExits(warning, requirement.seconds, proof_.proof_context);
    }
  }

  [[nodiscard]] Insight& insight() {
    if (!insight_) {
      insight_.emplace(proof_.proof_context, proof_.ending.bound());
    }
    return *insight_;
  }

  [[nodiscard]] Insight& insightWithoutPowerCuts() {
    if (!powered_) {
      powered_.emplace(proof_.proof_context.withoutPowerCuts(),
                       proof_.ending.boundWithoutPowerCuts());
    }
    return *powered_;
  }

  /// Whether a requirement is proved without a search over traces.
  [[nodiscard]] bool isSeen(const Requirement& requirement) {
    return requirement.geofences.empty() &&
           insight().proves(requirement, proof_.options.effort, proof_.searches);
  }

  std::optional<RequirementVerdict> judgeAtOnce(const Requirement& requirement) {
    if (requirement.kind == RequirementKind::StackAtMost) {
      return judgeStack(requirement);
    }
    if (easilyProved(requirement) || isSeen(requirement)) {
      return RequirementVerdict{0, Verdict::Proved, std::nullopt};
    }
    return std::nullopt;
  }

  RequirementVerdict judge(const Requirement& requirement) {
    if (fresh_ && isSeen(requirement)) {
      return {0, Verdict::Proved, std::nullopt};
    }
    if (proof_.searches.isUsedUp()) {
      return open("it was not searched for: " + limitReached());
    }
    RequirementVerdict verdict =
        requirement.geofences.empty() ? judgeRuns(requirement) : judgeAreas(requirement);
    // For Reach its trace is needed; what was cut short hangs on what was searched for before.
    verdict.searched = requirement.kind != RequirementKind::Reach && !proof_.searches.isUsedUp();
    return verdict;
  }

  [[nodiscard]] std::string limitReached() const {
    return proof_.searches.isOver() ? "the time limit was reached (`--timeout`)"
                                    : "all requirements together reached their limit (`--effort`)";
  }

  /// What proofs by a search rest on is collected, so that it can be checked again.
  [[nodiscard]] bool wantsInvariants() const { return proof_.options.evidence; }

  /// The check of the mission under some of its assumptions.
  RequirementCheck& under(const std::vector<uint32_t>& some);

  /// How long the SBC is without power in a flight, s: an assumption only limits each outage, but
  /// one that leaves none limits all.
  [[nodiscard]] double darkTogether() const {
    const bool some = m_.resume_within_s > proof_.proof_context.platform.world.tick_gap_s;
    return some && bare_ != nullptr ? bare_->m_.resume_within_s : m_.resume_within_s;
  }

  GeofenceVerdict areasOf(const Requirement& requirement) {
    return judgeGeofences(requirement.geofences, proof_.proof_context, darkTogether(),
                          proof_.ending);
  }

  /// Open if it is not proved.
  static RequirementVerdict provedAreas(const GeofenceVerdict& found) {
    if (!found.proved) {
      return open(found.reason);
    }
    if (found.start_assumed) {
      return {0, Verdict::Proved, std::nullopt};
    }
    return {0, Verdict::Proved, std::nullopt,
            fmt::format(
                "assuming that control is given on the right side of each edge, at least "
                "{0:.0f} m from it{1}, and that "
                "everything between there and the waypoints is also {0:.0f} m from the edge",
                std::ceil(found.margin_m),
                found.start_within_m > 0
                    ? fmt::format(" and within {:g} km of a waypoint", found.start_within_m / 1000)
                    : "")};
  }

  RequirementVerdict judgeAreas(const Requirement& requirement) {
    RequirementVerdict found = provedAreas(areasOf(requirement));
    if (found.verdict == Verdict::Proved) {
      return found;
    }
    auto run = tryAtRandom(requirement, proof_.proof_context.withoutPowerCuts());
    if (!run && powerCutsMatter()) {
      run = tryAtRandom(requirement, proof_.proof_context);
    }
    if (run) {
      return broken(requirement, std::move(*run));
    }
    found.reason += "; no random flight violated it";
    return found;
  }

  RequirementVerdict judgeStack(const Requirement& requirement) {
    if (proof_.facts.stack_depth <= requirement.depth) {
      return {0, Verdict::Proved, std::nullopt};
    }
    std::string path;
    for (const StateId state : proof_.facts.deepest_path) {
      path += fmt::format("{}`{}`", path.empty() ? "" : " calls ", m_[state].name);
    }
    const uint32_t waiting = proof_.facts.stack_depth;
    const std::string words = fmt::format("up to {} state{} may wait on the call stack: {}",
                                          waiting, waiting == 1 ? "" : "s", path);
    if (!m_.assumptions.empty()) {  // which may exclude these calls
      return open(words + "; what the mission assumes is not considered here");
    }
    proof_.diagnostics.report(DiagnosticId::requirementBroken, requirement.range, words);
    return {0, Verdict::Refuted, std::nullopt};
  }

  /// Without a search over traces.
  bool easilyProved(const Requirement& requirement) {
    switch (requirement.kind) {
      case RequirementKind::NeverAfter:
        return !mayEnterAfter(m_, requirement.state, requirement.after);
      case RequirementKind::Always:
        return heldByCommands(requirement.condition, proof_.proof_context, deepest_);
      case RequirementKind::ExitWithin:
        return proof_.ending.by(requirement.seconds).has_value();
      case RequirementKind::SurfacesEvery:
      case RequirementKind::StackAtMost:
      case RequirementKind::Reach:
        break;
    }
    return false;
  }

  Search search(const Requirement& requirement, const ProofContext& proof_context) {
    const ConeOfInfluence relevance = relevanceOf(requirement, proof_context);
    Search found = searchIn(requirement, proof_context, relevance);
    if (found.answer.bad != Answer::Yes || relevance.vehicle ||
        !readsDepth(relevance, proof_context)) {
      return found;
    }
    // Its readings of the depth may be those of no vehicle.
    return searchIn(requirement, proof_context, withVehicle(requirement, proof_context));
  }

  Search searchIn(const Requirement& requirement, const ProofContext& proof_context,
                  const ConeOfInfluence& relevance) {
    Search found{ask(requirement, proof_context, relevance), std::nullopt};
    if (found.answer.bad == Answer::Yes) {
      found.run =
          concretize(*found.answer.run, proof_context, proof_.facts.stack_depth, requirement);
    }
    return found;
  }

  [[nodiscard]] bool powerCutsMatter() const {
    return proof_.proof_context.tick_gap_s > proof_.proof_context.platform.world.tick_gap_s;
  }

  RequirementVerdict judgeRuns(const Requirement& requirement) {
    return requirement.kind == RequirementKind::Reach ? judgeReach(requirement)
                                                      : judgePromise(requirement);
  }

  /// A trace without power cuts is easier to understand.
  RequirementVerdict judgeReach(const Requirement& requirement) {
    const ProofContext powered = proof_.proof_context.withoutPowerCuts();
    Search found = search(requirement, powered);
    if (!found.run && powerCutsMatter()) {
      found = search(requirement, proof_.proof_context);
    }
    if (found.answer.bad == Answer::No) {
      return unreached(requirement);
    }
    if (!found.run) {
      found.run = tryAtRandom(requirement, proof_.proof_context);
    }
    return found.run ? RequirementVerdict{0, Verdict::Proved, std::move(found.run)}
                     : open(reasonOf(requirement, found.answer));
  }

  /// Proves a requirement for an SBC whose power may be cut; a counterexample is shown without
  /// power cuts if possible.
  RequirementVerdict judgePromise(const Requirement& requirement) {
    if (auto run = alsoSubmerged(requirement)) {
      return broken(requirement, std::move(*run));
    }
    Search found = search(requirement, insight().context());
    if (found.answer.bad == Answer::No) {
      RequirementVerdict proved{0, Verdict::Proved, std::nullopt};
      proved.steps = found.answer.steps;
      if (wantsInvariants()) {
        proved.evidence = evidences().searched(requirement, std::move(found.answer.invariants));
      }
      return proved;
    }
    bool powered_proved = false;
    if (powerCutsMatter()) {
      const ProofContext powered = proof_.proof_context.withoutPowerCuts();
      powered_proved = provedWithoutPowerCuts(requirement);
      Search undisturbed;
      if (!powered_proved) {
        undisturbed = search(requirement, insightWithoutPowerCuts().context());
        powered_proved = undisturbed.answer.bad == Answer::No;
        keepSubmerged(requirement, undisturbed);
      }
      if (!undisturbed.run && !powered_proved) {
        undisturbed.run = tryAtRandom(requirement, powered);
      }
      if (undisturbed.run) {
        found.run = std::move(undisturbed.run);
      }
    } else {
      keepSubmerged(requirement, found);
    }
    if (!found.run) {
      found.run = tryAtRandom(requirement, proof_.proof_context);
    }
    if (found.run) {
      return broken(requirement, std::move(*found.run));
    }
    return open(reasonOf(requirement, found.answer) +
                (powered_proved ? "; it holds if the SBC never loses power" : ""));
  }

  /// Without a search over traces.
  bool provedWithoutPowerCuts(const Requirement& requirement) {
    return insightWithoutPowerCuts().proves(requirement, proof_.options.effort, proof_.searches);
  }

  /// In a separate context: Z3 counts its steps for all questions of a context.
  RunsAnswer ask(const Requirement& requirement, const ProofContext& proof_context,
                 const ConeOfInfluence& relevance) {
    const unsigned effort = proof_.searches.allow(search_effort_);
    if (effort == 0) {
      return {Answer::Unknown, std::nullopt, limitReached(), 0};
    }
    z3::config config;
    config.set("rlimit", static_cast<int>(effort));  // Spacer's only limit, except for the time
    if (const auto limit = proof_.searches.milliseconds()) {
      config.set("timeout", static_cast<int>(*limit));
    }
    z3::context context(config);
    const auto size = static_cast<size_t>(std::ranges::count(relevance.expressions, true));
    proof_.searches.spend(Budget::kCondition * size);
    if (size > kMostSearched) {
      return {Answer::Unknown, std::nullopt, "the mission is too large for a search", 0};
    }
    try {
      const SafetyProperty watch =
          safetyPropertyFor(requirement, context, proof_context, relevance);
      RunsAnswer answer =
          askAboutRuns(context, proof_context, relevance, watch, effort, wantsInvariants());
      proof_.searches.spend(answer.steps);
      if (answer.bad == Answer::Unknown && proof_.searches.isUsedUp()) {
        answer.trouble = limitReached();
      }
      return answer;
    } catch (const z3::exception& trouble) {
      proof_.searches.spend(effort);
      return {Answer::Unknown, std::nullopt, trouble.msg(), effort};
    }
  }

  /// Tries seeds 1, 2, …, until so many ticks are flown.
  std::optional<Counterexample> tryAtRandom(const Requirement& requirement,
                                            const ProofContext& proof_context) {
    const double cycle = proof_.proof_context.platform.envelope.cycle_s;
    const double time = std::max(requirement.seconds, requirement.monitor.horizon_s);
    const double span = time > 0 ? 2 * time : kLongFlight;
    const uint64_t tick = Budget::kTick + m_.exprs.size() / Budget::kExpressions;
    const uint64_t judged = requirement.condition.valid()
                                ? Evaluation(m_, requirement.condition).size() / Budget::kEvaluated
                                : 0;
    // A condition with very many operations, such as an area with 1,000 corners, is tried on fewer
    // ticks.
    const size_t most = proof_.options.random_ticks * 2 * tick / std::max(2 * tick, tick + judged);
    const auto ticks = static_cast<size_t>(std::min(span / cycle + 2, static_cast<double>(most)));
    const size_t flights = std::max<size_t>(1, most / ticks);
    for (uint64_t seed = 1; seed <= flights && !proof_.searches.isUsedUp(); ++seed) {
      proof_.searches.spend(ticks * (tick + judged));
      if (auto run =
              flyAtRandom(proof_context, proof_.facts.stack_depth, requirement, seed, ticks)) {
        return run;
      }
    }
    return std::nullopt;
  }

  RequirementVerdict unreached(const Requirement& requirement) {
    proof_.diagnostics.report(
        DiagnosticId::requirementBroken, requirement.range,
        fmt::format("no possible flight{} enters state `{}`",
                    m_.assumptions.empty() ? "" : " that satisfies the assumptions",
                    m_[requirement.state].name));
    return {0, Verdict::Refuted, std::nullopt};
  }

  [[nodiscard]] std::string reasonOf(const Requirement& requirement,
                                     const RunsAnswer& answer) const {
    if (answer.bad != Answer::Yes) {
      return fmt::format("no proof was found ({}), and no random flight violated it",
                         answer.trouble);
    }
    const std::string what = knownRoughly(m_, relevanceOf(requirement, proof_.proof_context));
    return fmt::format("a possible {} was found, but did not hold when it was checked{}",
                       requirement.kind == RequirementKind::Reach ? "flight" : "counterexample",
                       what.empty() ? "" : "; approximated here: " + what);
  }

  /// It is reported by settle().
  static RequirementVerdict open(const std::string& reason) {
    return {0, Verdict::Open, std::nullopt, {}, reason};
  }

  RequirementVerdict broken(const Requirement& requirement, Counterexample run) {
    reportViolation(requirement, run, proof_.proof_context, proof_.diagnostics);
    return {0, Verdict::Refuted, std::move(run)};
  }

  Proof& proof_;
  RequirementCheck* bare_;
  const Mission& m_;
  unsigned search_effort_;  ///< the limit of a search
  Budget premises_;         ///< of addPremises
  std::map<std::vector<uint32_t>, std::shared_ptr<CheckUnderAssumptions>> under_some_;
  std::optional<Run> submerged_;    ///< see alsoSubmerged
  std::optional<Insight> insight_;  ///< with power cuts; none: not asked for yet
  std::optional<Insight> powered_;
  double deepest_;                            ///< of the mission, m
  std::optional<EvidenceBuilder> evidences_;  ///< with Options::evidence
  std::vector<bool> waiting_;                 ///< by requirement: a search has to decide it
  std::vector<bool> bare_proved_;             ///< by requirement: without the assumptions
  bool fresh_ = false;                        ///< something was proved since the first look
};

/// The mission under some of its assumptions.
class CheckUnderAssumptions {
 public:
  /// `plain`: without any.
  CheckUnderAssumptions(RequirementCheck& plain, const std::vector<uint32_t>& kept)
      : written_(keeping(plain.proof().proof_context.mission, kept)),
        mission_(underAssumptions(written_)),
        platform_(underAssumptions(plain.proof().proof_context.platform, written_)),
        context_(mission_, platform_),
        proof_{plain.proof().context, context_, plain.proof().facts, plain.proof().options,
               plain.proof().diagnostics},
        check_(proof_, &plain) {}

  [[nodiscard]] RequirementCheck& check() { return check_; }

 private:
  static Mission keeping(Mission mission, const std::vector<uint32_t>& kept) {
    std::vector<Assumption> some;
    for (const uint32_t number : kept) {
      some.push_back(mission.assumptions[number]);
    }
    mission.assumptions = std::move(some);
    return mission;
  }

  Mission written_;
  Mission mission_;
  platforms::Platform platform_;
  ProofContext context_;
  Proof proof_;
  RequirementCheck check_;
};

RequirementCheck& RequirementCheck::under(const std::vector<uint32_t>& some) {
  if (bare_ == nullptr || some.size() == m_.assumptions.size()) {
    return *this;
  }
  // Not bare_ for none of them: its mission still has what is assumed of the start, for areas.
  std::shared_ptr<CheckUnderAssumptions>& found = under_some_[some];
  if (!found) {
    found = std::make_shared<CheckUnderAssumptions>(*bare_, some);
  }
  return found->check();
}

/// A proof that is found again takes about as long as the first.
bool RequirementCheck::isProvedUnder(const std::vector<uint32_t>& fewer,
                                     RequirementVerdict& verdict) {
  constexpr uint64_t kAtLeast = 50000;
  premises_.spend(Budget::kCondition * m_.exprs.size());
  if (premises_.isUsedUp()) {
    return false;
  }
  const uint64_t effort =
      std::min<uint64_t>(proof_.options.run_effort, 2 * verdict.steps + kAtLeast);
  RequirementCheck& check = under(fewer);
  const Budget before = std::exchange(check.proof_.searches, premises_);
  RepeatedProof again = check.provesAgain(verdict, static_cast<unsigned>(effort));
  premises_ = std::exchange(check.proof_.searches, before);
  const bool of_areas = !m_.requirements[verdict.requirement].geofences.empty();
  if (!again.proved || (proof_.options.evidence && !again.evidence && !of_areas)) {
    return false;  // what evidence there is may rest on more
  }
  verdict.evidence = std::move(again.evidence);
  return true;
}

}  // namespace

void passes::requirements(Proof& proof) {
  const ProofContext& plain = proof.proof_context;
  if (plain.mission.requirements.empty()) {
    return;
  }
  if (plain.mission.assumptions.empty()) {
    return RequirementCheck(proof).run();
  }
  const Mission mission = underAssumptions(plain.mission);
  const auto is_empty = [](const Sensor& sensor) { return sensor.lowest > sensor.highest; };
  if (std::ranges::any_of(mission.sensors, is_empty) || !proof.decided_assumptions.empty()) {
    return RequirementCheck(proof).run();  // GL3121 or GL3136 is reported: nothing rests on these
  }
  const platforms::Platform platform = underAssumptions(plain.platform, plain.mission);
  const ProofContext proof_context(mission, platform);
  Proof assuming{proof.context, proof_context, proof.facts, proof.options, proof.diagnostics};
  RequirementCheck bare(proof);
  RequirementCheck(assuming, &bare).run();
  proof.findings.requirements = std::move(assuming.findings.requirements);
}

}  // namespace glider::ir::prove
