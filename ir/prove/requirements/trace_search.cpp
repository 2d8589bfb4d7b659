// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What can go wrong in a search is only that no verdict is found: a trace of Spacer is replayed
// (concretize) before it refutes anything.

#include "ir/prove/requirements/trace_search.h"

#include "ir/core/inside.h"
#include "ir/prove/context/place_read.h"
#include "ir/prove/encoding/cone_of_influence.h"
#include "ir/prove/encoding/known_roughly.h"
#include "ir/prove/encoding/safety_properties.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace glider::ir::prove {
namespace {

/// A question about all traces is not even written if more expressions than this matter to it.
constexpr size_t kMostSearched = 30000;

void limit(z3::config& config, unsigned effort, const Budget& budget) {
  config.set("rlimit", static_cast<int>(effort));  // Spacer's only limit, except for the time
  if (const auto time = budget.milliseconds()) {
    config.set("timeout", static_cast<int>(*time));
  }
}

/// In a Z3 context of its own: Z3 counts its steps for all questions of a context.
RunsAnswer ask(const Requirement& requirement, Insight& insight, const ConeOfInfluence& relevance,
               StrategyContext& of, const std::optional<Scope>& scope = std::nullopt,
               Lemmas lemmas = Lemmas::Farkas) {
  Budget& budget = of.proof.searches;
  constexpr unsigned kWithin = 2;  // part of a mission is a smaller question: more of it is decided
  const unsigned effort = budget.allow(scope ? kWithin * of.search_effort : of.search_effort);
  if (effort == 0) {
    return {Answer::Unknown, std::nullopt, of.limitReached(), 0};
  }
  z3::config config;
  limit(config, effort, budget);
  z3::context context(config);
  const auto size = static_cast<size_t>(std::ranges::count(relevance.expressions, true));
  budget.spend(Budget::kCondition * size);
  if (size > kMostSearched) {
    return {Answer::Unknown, std::nullopt, "the mission is too large for a search", 0};
  }
  try {
    const ProofContext& proof_context = insight.context();
    SafetyProperty watch = safetyPropertyFor(requirement, context, proof_context, relevance);
    if (scope || !watch.awaited_depths.empty()) {
      watch.known = insight.byState();  // elsewhere Spacer is quicker without
    }
    watch.scope = scope;
    watch.lemmas = lemmas;
    RunsAnswer answer =
        askAboutRuns(context, proof_context, relevance, watch, effort, of.wantsEvidence());
    budget.spend(answer.steps);
    if (answer.bad == Answer::Unknown && budget.isUsedUp()) {
      answer.trouble = of.limitReached();
    }
    return answer;
  } catch (const z3::exception& trouble) {
    budget.spend(effort);
    return {Answer::Unknown, std::nullopt, trouble.msg(), effort};
  }
}

/// Asks, and once more with the vehicle if the answer is a trace whose readings of the depth may be
/// those of no vehicle. `use` is given each answer.
template <typename Use>
auto askTwice(const Requirement& requirement, Insight& insight, StrategyContext& context,
              const Use& use, Lemmas lemmas = Lemmas::Farkas) {
  const ProofContext& proof_context = insight.context();
  const ConeOfInfluence relevance = relevanceOf(requirement, proof_context);
  auto found = use(ask(requirement, insight, relevance, context, std::nullopt, lemmas));
  if (found.answer.bad != Answer::Yes || relevance.vehicle ||
      !readsDepth(relevance, proof_context)) {
    return found;
  }
  return use(ask(requirement, insight, withVehicle(requirement, proof_context), context,
                 std::nullopt, lemmas));
}

/// What Z3 says where it gives up.
std::string inWords(const std::string& trouble) {
  return trouble.contains("resource limit")
             ? "the search stopped after as many steps as `--effort` allows"
         : trouble.contains("cancel") ? "the search was stopped by `--timeout`"
                                      : trouble;
}

}  // namespace

TraceSearch searchTraces(const Requirement& requirement, Insight& insight,
                         StrategyContext& context) {
  const ProofContext& proof_context = insight.context();
  return askTwice(requirement, insight, context, [&](RunsAnswer answer) {
    TraceSearch found{std::move(answer)};
    if (found.answer.bad == Answer::Yes && !isAboutPlace(requirement, proof_context)) {
      found.run = concretize(*found.answer.run, proof_context, context.proof.facts.stack_depth,
                             requirement);
    }
    return found;
  });
}

RunsAnswer provenByTraces(const Requirement& requirement, Insight& insight,
                          StrategyContext& context, Lemmas lemmas) {
  return askTwice(
             requirement, insight, context,
             [](RunsAnswer answer) { return TraceSearch{std::move(answer)}; }, lemmas)
      .answer;
}

RunsAnswer provenWithin(const Requirement& requirement, const Scope& scope, Insight& insight,
                        StrategyContext& context, Lemmas lemmas) {
  const ConeOfInfluence relevance = relevanceWithin(requirement, insight.context());
  RunsAnswer answer = ask(requirement, insight, relevance, context, scope, lemmas);
  // What holds elsewhere holds with every control for which it stands.
  std::vector<certify::Invariant> elsewhere;
  for (const bool just_returned : {false, true}) {
    Control control = scope.elsewhere;
    control.just_returned = just_returned;
    const auto found =
        std::ranges::find(answer.invariants, configurationOf(control), &certify::Invariant::at);
    if (found != answer.invariants.end()) {
      elsewhere.push_back(*found);
      answer.invariants.erase(found);
    }
  }
  for (const Control& control : scope.others) {
    // Where no return matters nothing of its own is found for what comes after one.
    if (!elsewhere.empty()) {
      const certify::Invariant& of = control.just_returned ? elsewhere.back() : elsewhere.front();
      answer.invariants.push_back({configurationOf(control), of.formula});
    }
  }
  return answer;
}

std::string whyUndecided(const Requirement& requirement, const RunsAnswer& answer,
                         const StrategyContext& context) {
  if (isAboutPlace(requirement, context.proof.proof_context)) {
    return fmt::format(
        "places are decided only by geofences: write each area and each distance, with constant "
        "places and radii, in a `require always` of its own{}",
        assumedStart(context.mission)
            ? ""
            : ", and say where the mission starts with `assume start inside(…)`");
  }
  if (answer.bad != Answer::Yes) {
    const std::string trouble = inWords(answer.trouble);
    return requirement.kind == RequirementKind::Reach
               ? fmt::format(
                     "neither a flight that enters the state nor a proof that none does was "
                     "found ({})",
                     trouble)
               : fmt::format("no proof was found ({})", trouble);
  }
  const std::string what = knownRoughly(context.proof.proof_context,
                                        relevanceOf(requirement, context.proof.proof_context));
  return fmt::format("a possible {} was found, but did not hold when it was checked{}",
                     requirement.kind == RequirementKind::Reach ? "flight" : "counterexample",
                     what.empty() ? "" : "; approximated here: " + what);
}

bool isCutShort(std::string_view reason) {
  return reason.contains("`--effort`");
}

bool isPromiseOfTraces(const Requirement& requirement) {
  return requirement.kind != RequirementKind::Reach &&
         requirement.kind != RequirementKind::StackAtMost && requirement.geofences.empty();
}

RequirementVerdict provedBy(RunsAnswer answer, const Requirement& requirement,
                            StrategyContext& context) {
  RequirementVerdict proved{0, Verdict::Proved, std::nullopt};
  proved.steps = answer.steps;
  if (context.wantsEvidence()) {
    proved.evidence = context.evidences().searched(requirement, std::move(answer.invariants));
  }
  return proved;
}

std::optional<RequirementVerdict> provedIf(RunsAnswer answer, const Requirement& requirement,
                                           StrategyContext& context) {
  return answer.bad == Answer::No ? std::optional(provedBy(std::move(answer), requirement, context))
                                  : std::nullopt;
}

void keepSubmersion(const Requirement& requirement, const TraceSearch& found,
                    StrategyContext& context) {
  if (requirement.kind == RequirementKind::SurfacesEvery && found.run) {
    context.submerged = found.answer.run;
  }
}

}  // namespace glider::ir::prove
