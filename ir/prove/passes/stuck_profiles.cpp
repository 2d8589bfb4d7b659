// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `stuckProfiles`: profiles meant to climb and dive that come to command one direction for
// good (GL3112). In: the profiles of the mission, not of the library; out: a warning at the case
// that leads there. Every combination of a profile's own truth values and its latest command is
// visited, comparisons having either result. A hint in one respect: whether some flight reaches the
// combination is not known. More than ProfileModes::kMostTruths truth values: not checked.

#include "ir/prove/abstract/profile_modes.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

/// The modes that a profile can be in, and how its cases lead from one to another. Sensors are
/// assumed to be known: what a profile does without them does not count as leaving a trap. A
/// comparison may have either result.
class ModeGraph {
 public:
  /// `resumes`: its state may be returned to, so that its entry runs again, in the current mode.
  ModeGraph(const Mission& mission, const Activity& profile, bool resumes)
      : m_(mission), profile_(profile), resumes_(resumes), modes_(mission, profile, nullptr) {}

  /// False if there are too many.
  bool explore() {
    if (modes_.own().size() > ProfileModes::kMostTruths) {
      return false;
    }
    for (const Mode& mode : modes_.begin()) {
      arrive(mode, profile_.range);
    }
    while (!pending_.empty()) {
      const Mode mode = pending_.back();
      pending_.pop_back();
      follow(mode);
    }
    return true;
  }

  struct Trap {
    Command command;
    support::SourceRange range;  ///< of the case that leads into it
  };

  /// A mode from which only its own command is given, up or down, and the profile is never done.
  [[nodiscard]] std::optional<Trap> trap() const {
    for (const auto& [mode, range] : arrivals_) {
      const bool sloped = mode.command && (isDescent(*mode.command) || isAscent(*mode.command));
      if (sloped && !leadsToAnother(mode)) {
        return Trap{*mode.command, range};
      }
    }
    return std::nullopt;
  }

 private:
  void arrive(const Mode& mode, const support::SourceRange& by) {
    if (arrivals_.emplace(mode, by).second) {
      pending_.push_back(mode);
    }
  }

  void follow(const Mode& mode) {
    if (resumes_) {
      for (const Mode& after : modes_.run(profile_.entry, {mode})) {
        next_[mode].insert(after);
        arrive(after, profile_.range);
      }
    }
    for (const Case& c : profile_.cases) {
      const Truth guard = modes_.judge(c.guard, mode);
      if (guard == Truth::False) {
        continue;
      }
      if (c.transition == Transition::Done) {
        ends_.insert(mode);
      }
      for (const Mode& after : modes_.run(c.action, {mode})) {
        next_[mode].insert(after);
        arrive(after, m_[c.guard].range);
      }
      if (guard == Truth::True) {
        return;  // it hides the rest
      }
    }
  }

  [[nodiscard]] bool leadsToAnother(const Mode& from) const {
    std::vector<Mode> pending{from};
    std::set<Mode> seen{from};
    while (!pending.empty()) {
      const Mode mode = pending.back();
      pending.pop_back();
      if (mode.command != from.command || ends_.contains(mode)) {
        return true;
      }
      const auto next = next_.find(mode);
      if (next == next_.end()) {
        continue;
      }
      for (const Mode& after : next->second) {
        if (seen.insert(after).second) {
          pending.push_back(after);
        }
      }
    }
    return false;
  }

  const Mission& m_;
  const Activity& profile_;
  bool resumes_;
  ProfileModes modes_;
  std::map<Mode, support::SourceRange> arrivals_;  ///< the case by which each was first reached
  std::map<Mode, std::set<Mode>> next_;
  std::set<Mode> ends_;  ///< in which it may be done
  std::vector<Mode> pending_;
};

/// A profile that only goes one way is intended to do so.
bool goesBothWays(const Mission& mission, const Activity& profile) {
  bool down = false;
  bool up = false;
  for (const Statement* statement : commandsOf(mission, profile)) {
    down = down || isDescent(statement->command) || statement->command == Command::Hover;
    up = up || isAscent(statement->command) || statement->command == Command::Surface;
  }
  return down && up;
}

/// Whether some of the cases may call a state, which may return.
bool mayCall(const Proof& proof, StateId state, const std::vector<Case>& cases) {
  for (uint32_t i = 0; i < cases.size(); ++i) {
    if (cases[i].transition == Transition::Call && !proof.dead.contains({state, i})) {
      return true;
    }
  }
  return false;
}

}  // namespace

void passes::stuckProfiles(Proof& proof) {
  const Mission& m = proof.proof_context.mission;
  std::set<std::pair<uint32_t, uint32_t>> told;
  const bool always_calls = mayCall(proof, StateId(), m.always);
  for (uint32_t i = 0; i < m.states.size(); ++i) {
    const State& state = m.states[i];
    const bool own =
        !state.profile.cases.empty() && !proof.options.inLibrary(state.profile.cases.front().range);
    ModeGraph modes(m, state.profile, always_calls || mayCall(proof, {i}, state.cases));
    if (!own || !goesBothWays(m, state.profile) || !modes.explore()) {
      continue;
    }
    const auto trap = modes.trap();
    if (trap && told.emplace(trap->range.file, trap->range.begin).second) {
      const bool dives = isDescent(trap->command);
      proof.diagnostics.report(support::diagnostics::profileStuck, trap->range,
                               dives ? "dive" : "climb", dives ? "climb" : "dive");
    }
  }
}

}  // namespace glider::ir::prove
