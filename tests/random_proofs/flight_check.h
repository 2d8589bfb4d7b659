// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/requirement_monitor.h"
#include "tests/containment/flight.h"
#include "tests/random_proofs/claims.h"

#include <set>
#include <string>
#include <vector>

namespace glider::random_proofs {

/// What is watched for in the flights of a mission.
struct Watched {
  std::vector<Claim> claims;
  /// The verdicts that a flight can contradict: what is proved, and what is never reached.
  std::vector<ir::prove::RequirementVerdict> verdicts;
  uint32_t stack_depth = 0;
};

/// Which of it a flight was able to contradict: its state was current, for example.
struct Met {
  std::set<size_t> claims, verdicts;  ///< numbers in Watched
};

/// Watches one flight. Written from the meaning of requirements and findings alone.
class FlightCheck {
 public:
  /// All outlive this. `narrowed`: the vehicle is what the mission assumes, so that proofs that
  /// rest on its start hold.
  FlightCheck(const ir::prove::ProofContext& context, const Watched& watched,
              const containment::FlightStyle& style, bool narrowed, Met& met);

  /// After the start and after each tick: the first contradiction, in words; empty: none.
  std::string tick(const containment::Flight& flight);
  /// In the middle of a tick.
  std::string midway(const containment::Flight& flight);

 private:
  [[nodiscard]] bool excused(const ir::prove::RequirementVerdict& verdict) const;
  bool brokenMidway(const Claim& claim, const containment::Flight& flight, bool& met) const;
  bool brokenBy(size_t number, const containment::Flight& flight, bool& met);
  [[nodiscard]] bool fired(const Claim& claim, const containment::Flight& flight) const;
  [[nodiscard]] bool leaves(const Claim& claim, const containment::Flight& flight) const;
  [[nodiscard]] ir::Truth truthOf(ir::ExprId id, const containment::Flight& flight) const;
  [[nodiscard]] bool allTrue(const std::vector<ir::ExprId>& conditions,
                             const containment::Flight& flight) const;

  const ir::prove::ProofContext& context_;
  const ir::Mission& m_;
  const Watched& watched_;
  containment::FlightStyle style_;
  bool narrowed_;
  Met& met_;
  std::vector<ir::RequirementMonitor> monitors_;     ///< by number in Watched::verdicts
  std::vector<ir::RequirementMonitor> assumptions_;  ///< by number
  std::vector<bool> holds_;                          ///< by assumption: so far
  std::set<size_t> entered_;                         ///< claims: no exit may follow any more
  std::vector<ir::ExprId> assumed_, required_;       ///< conditions about a single moment
};

}  // namespace glider::random_proofs
