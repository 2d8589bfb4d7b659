// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/falsification/counterexample.h"
#include "support/diagnostics/engine.h"

/// Notes that say what to change where a requirement is not proved.
namespace glider::ir::prove {

/// Why the mission may not end within the time of `exit within`: names each exit by mission time
/// that would end it in time as the first case of its list; or else a case that waits for a
/// reading, perhaps for ever, and an exit that would end the mission in time as the first case of
/// `always`.
void noteLateEnd(support::DiagnosticBuilder& diagnostic, const Requirement& requirement,
                 const ProofContext& proof_context);

/// When the mission is proved to end, if that is later than `requirement.seconds`; if only power
/// cuts make it later, the bound with them.
void notePowerCutsCount(support::DiagnosticBuilder& warning, const Requirement& requirement,
                        const ProofContext& proof_context, Ending& ending);

/// What makes it easier to prove that the vehicle stays within, or out of, areas; nothing for other
/// requirements.
void noteFences(support::DiagnosticBuilder& warning, const Requirement& requirement,
                const ProofContext& proof_context);

/// Says of a requirement that speaks only of what the sea decides that no mission can ensure it.
void noteWhatTheSeaDecides(support::DiagnosticBuilder& error, const Requirement& requirement,
                           const ProofContext& proof_context);

/// Says of a promise that waits for a reading that no mission can ensure it.
void noteAwaitedReading(support::DiagnosticBuilder& error, const Requirement& requirement,
                        const Counterexample& run, const ProofContext& proof_context);

/// For a promise about readings on which a case of `always` acts: names a case of a state that is
/// resumed which may fire first on the tick after the return, so that such a reading is missed.
void notePutOff(support::DiagnosticBuilder& warning, const Requirement& requirement,
                const ProofContext& proof_context);

/// Names variables of the mission that are counted without a limit.
void noteUnlimitedCounts(support::DiagnosticBuilder& warning, const ProofContext& proof_context);

/// For a promise of traces where the time of day decides: why a search does not know that it goes
/// on.
void noteCalendar(support::DiagnosticBuilder& warning, const Requirement& requirement,
                  const ProofContext& proof_context);

/// Names each statement that sets a time of the mission's own to `missiontime` as a state begins:
/// what happens within a time is proved from such a time only if a case sets it.
void noteTimersOfEntries(support::DiagnosticBuilder& warning, const ProofContext& proof_context);

/// For a promise of a depth some time after a state begins that commands the surface: in what time
/// it would be proved, or which case leaves the state too early.
void noteSlowClimb(support::DiagnosticBuilder& warning, const Requirement& requirement,
                   const ProofContext& proof_context);

/// Of a `surfaces every`: names a case of `always` with a timer of the mission with which it would
/// be proved, if that case came before those that lead to other states.
void noteTimerBelow(support::DiagnosticBuilder& warning, const Requirement& requirement,
                    const ProofContext& proof_context);

/// That a profile which comes to the surface by itself does not stay there for as long as proofs
/// need; of an undecided `surfaces every`.
void noteOwnSurfacings(support::DiagnosticBuilder& warning, const ProofContext& proof_context);

/// Names, of each state that commands the surface, a case that may lead on under water before the
/// slowest climb of the environment model is over.
void noteEarlyLeaves(support::DiagnosticBuilder& diagnostic, const ProofContext& proof_context);

/// Names each state that commands the surface and that `run` leaves under water, before the
/// slowest climb of the environment model is over.
void noteShortSurfacings(support::DiagnosticBuilder& error, const Counterexample& run,
                         const ProofContext& proof_context);

}  // namespace glider::ir::prove
