// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/horn.h"
#include "ir/prove/requirements/strategy_context.h"

#include <optional>
#include <string>
#include <string_view>

/// Spacer's search over all traces, within the budget of the requirements.
namespace glider::ir::prove {

/// The result of a question about all traces.
struct TraceSearch {
  RunsAnswer answer;
  std::optional<Counterexample> run = {};  ///< its trace, checked on the interpreter
};

/// Searches for a trace that violates `requirement` (Reach: satisfies). `insight`: with power cuts
/// or without.
TraceSearch searchTraces(const Requirement& requirement, Insight& insight,
                         StrategyContext& context);

/// The same where only a proof counts: no trace is made concrete.
RunsAnswer provenByTraces(const Requirement& requirement, Insight& insight,
                          StrategyContext& context, Lemmas lemmas = Lemmas::Farkas);

/// The same of part of the mission.
RunsAnswer provenWithin(const Requirement& requirement, const Scope& scope, Insight& insight,
                        StrategyContext& context, Lemmas lemmas = Lemmas::Farkas);

/// Why `answer`, without a trace that holds when it is checked, decides nothing.
std::string whyUndecided(const Requirement& requirement, const RunsAnswer& answer,
                         const StrategyContext& context);

/// Whether whyUndecided says that a limit was reached, so that a longer search may help.
bool isCutShort(std::string_view reason);

/// Whether a requirement is a promise about all traces that a search may decide.
bool isPromiseOfTraces(const Requirement& requirement);

/// The verdict by `answer`, a proof, with its evidence.
RequirementVerdict provedBy(RunsAnswer answer, const Requirement& requirement,
                            StrategyContext& context);

/// The same if `answer` is a proof.
std::optional<RequirementVerdict> provedIf(RunsAnswer answer, const Requirement& requirement,
                                           StrategyContext& context);

/// Keeps the trace of `found`, without power cuts, if it violates a `surfaces every`: it may
/// violate others.
void keepSubmersion(const Requirement& requirement, const TraceSearch& found,
                    StrategyContext& context);

}  // namespace glider::ir::prove
