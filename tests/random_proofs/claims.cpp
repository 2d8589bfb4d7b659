// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_proofs/claims.h"

#include "support/diagnostics/ids/verification.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace glider::random_proofs {
namespace {

using ir::ListKind;
using ir::Transition;
using support::Diagnostic;
using support::SourceRange;

class Reader {
 public:
  Reader(const ir::Mission& mission, const std::set<ir::CasePlace>& dead)
      : m_(mission), dead_(dead), structure_(mission, dead) {}

  std::vector<Claim> read(const support::DiagnosticEngine& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics.sorted()) {
      read(diagnostic);
    }
    return std::move(claims_);
  }

 private:
  void read(const Diagnostic& d) {
    Claim claim{d.id, d.message};
    switch (d.id) {
      case support::diagnostics::unreachableState:
        return ofState(claim, d.range, false);
      case support::diagnostics::deadEndState:
      case support::diagnostics::noWayToExit:
        return ofState(claim, d.range, true);
      case support::diagnostics::callForGood:
        return ofCalled(claim, d.range);
      case support::diagnostics::guardNeverTrue:
      case support::diagnostics::guardAlwaysTrue:
        return ofGuard(claim, d.range);
      case support::diagnostics::caseHidden:
        return ofHidden(claim, d.range);
      case support::diagnostics::neverTrueInState:
        return ofGuardPart(claim, d.range);
      case support::diagnostics::comparisonDecided:
        claim.expected = d.message.ends_with("true");
        return ofExpression(claim, d.range);
      case support::diagnostics::longerThanState:
        return ofTemporal(claim, d.range);
      case support::diagnostics::missionWithoutEnd:
      case support::diagnostics::endsAtOnce:
      case support::diagnostics::endNeedsReadings:
      case support::diagnostics::assumptionsContradict:
      case support::diagnostics::requirementsContradict:
        claims_.push_back(claim);
        return;
      case support::diagnostics::requirementVacuous:
        // Of a condition that no reading makes false, or of one that never makes it count.
        claim.expected = d.message.contains("no value within the range");
        return ofExpression(claim, d.notes.empty() ? SourceRange() : d.notes.front().range);
      default:
        return;
    }
  }

  void ofState(Claim claim, const SourceRange& range, bool limited) {
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      if (m_.states[i].range == range) {
        claim.state = {i};
        claim.limit = limited ? structure_.lowestLimit(i) : claim.limit;
        claims_.push_back(claim);
      }
    }
  }

  using Visit = std::function<void(ir::StateId, ListKind, const std::vector<ir::Case>&)>;
  void forEachList(const Visit& visit) const {
    visit({}, ListKind::Always, m_.always);
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      visit({i}, ListKind::State, m_.states[i].cases);
      visit({i}, ListKind::Profile, m_.states[i].profile.cases);
      visit({i}, ListKind::Route, m_.states[i].route.cases);
    }
  }

  void ofCalled(Claim claim, const SourceRange& range) {
    forEachList([&](ir::StateId, ListKind, const std::vector<ir::Case>& cases) {
      for (const ir::Case& c : cases) {
        if (c.range == range && c.transition == Transition::Call) {
          claim.state = c.target;
          claims_.push_back(claim);
        }
      }
    });
  }

  /// Of a case that earlier ones hide, this one alone is meant, although others may share its
  /// guard.
  void ofHidden(const Claim& claim, const SourceRange& range) {
    const size_t before = claims_.size();
    ofGuard(claim, range);
    std::erase_if(claims_, [&](const Claim& c) {
      return c.id == claim.id && isList(c.list) && !dead_.contains({c.state, c.number});
    });
    if (claims_.size() > before + 1) {
      claims_.resize(before);
    }
  }

  static bool isList(ListKind list) { return list == ListKind::Always || list == ListKind::State; }

  void ofGuard(Claim claim, const SourceRange& range) {
    forEachList([&](ir::StateId state, ListKind list, const std::vector<ir::Case>& cases) {
      for (uint32_t i = 0; i < cases.size(); ++i) {
        if (m_[cases[i].guard].range == range) {
          claim.state = state;
          claim.list = list;
          claim.number = i;
          claim.guard = cases[i].guard;
          claims_.push_back(claim);
        }
      }
    });
  }

  /// One of the alternatives of a guard of a state.
  void ofGuardPart(Claim claim, const SourceRange& range) {
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      for (const ir::Case& c : m_.states[i].cases) {
        if (claim.words.find("`" + m_.states[i].name + "`") != std::string::npos) {
          claim.state = {i};
          partOf(c.guard, claim, range);
        }
      }
    }
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  void partOf(ir::ExprId id, Claim claim, const SourceRange& range) {
    const ir::Expr& e = m_[id];
    if (e.range == range) {
      claim.guard = id;
      claims_.push_back(claim);
    } else if (e.op == ir::Op::Or) {
      partOf(e.operands[0], claim, range);
      partOf(e.operands[1], claim, range);
    }
  }

  void ofExpression(Claim claim, const SourceRange& range) {
    for (uint32_t i = 0; i < m_.exprs.size(); ++i) {
      if (m_.exprs[i].range == range && m_.exprs[i].type.kind == ir::TypeKind::Bool) {
        claim.guard = {i};
        claims_.push_back(claim);
        return;
      }
    }
  }

  void ofTemporal(Claim claim, const SourceRange& range) {
    for (uint32_t i = 0; i < m_.exprs.size(); ++i) {
      const ir::Expr& e = m_.exprs[i];
      if (e.op == ir::Op::Temporal && m_[e.temporal].range == range) {
        claim.state = m_[e.temporal].state;
        claim.guard = {i};
        claims_.push_back(claim);
        return;
      }
    }
  }

  const ir::Mission& m_;
  const std::set<ir::CasePlace>& dead_;
  ir::Structure structure_;
  std::vector<Claim> claims_;
};

}  // namespace

std::vector<Claim> claimsOf(const ir::Mission& mission,
                            const support::DiagnosticEngine& diagnostics,
                            const std::set<ir::CasePlace>& dead) {
  return Reader(mission, dead).read(diagnostics);
}

}  // namespace glider::random_proofs
