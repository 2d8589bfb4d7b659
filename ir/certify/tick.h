// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/certify/certificate.h"
#include "ir/certify/expressions.h"
#include "ir/certify/vehicle.h"

#include <optional>
#include <string>
#include <vector>

namespace glider::ir::certify {

/// One way in which a start or a tick may end.
struct Outcome {
  Term condition;                   ///< that it ends so
  std::string words;                ///< "case 2 of `look` (goto `home`)"
  std::optional<Configuration> to;  ///< where it leads; empty: the mission has finished
  bool impossible = false;          ///< a `return` without a caller
  StateId entered;                  ///< by goto, call or the start; invalid: none
  Store store;
};

/// A tick (README, steps 3 to 5, and E), all paths at once: what several paths have in common
/// is written once, and where they meet, values are chosen by conditions.
class Tick {
 public:
  /// A tick at time `time`, with the vehicle at `depth`, from configuration `at`.
  Tick(const Setting& setting, SmtText& out, const Configuration& at, const Term& time,
       const Term& depth);

  /// E8: the start; `store` holds the parameters.
  std::vector<Outcome> start(Store store);
  /// Steps 3 to 5, from what the tick before has left.
  std::vector<Outcome> run(Store store);

  /// README, Monitors: what the requirement's monitor does at the end of a start or tick that ends
  /// so.
  void observe(Outcome& outcome);

  Expressions& expressions() { return expressions_; }
  /// That some assignment on a path that is taken leaves the range of its variable.
  [[nodiscard]] Term leavesRange() const { return disjunction(out_of_range_); }

 private:
  enum class TemporalMoment : uint8_t { Start, Resume, Advance };
  /// A path that the tick takes where `taken` is true, and what it has done so far.
  struct Path {
    Term taken;
    Store store;
  };

  void tryList(ListKind list, Path& path);
  [[nodiscard]] const std::vector<Case>& casesOf(ListKind list) const;
  [[nodiscard]] bool mayFire(ListKind list, uint32_t number) const;
  void move(ListKind list, uint32_t number, Path path);
  void giveArguments(const Case& fired, Path& path);
  void enter(StateId target, Path& path);
  void resume(Configuration& at, Path& path);
  void startActivity(const Activity& activity, Path& path);
  void end(const Path& path, std::string words, std::optional<Configuration> to,
           StateId entered = {});

  void initialise(VariableId id, Path& path);
  void assign(VariableId id, ExprId expr, const Value& value, Path& path);
  void run(BlockId block, Path& path);
  void execute(const Statement& s, Path& path);
  [[nodiscard]] bool sees(const Observation& observation, const Outcome& outcome) const;

  void updateTemporals(bool always, StateId state, TemporalMoment moment, Store& store);
  void updateGuard(uint32_t temporal, TemporalMoment moment, Store& store);
  void updateWindow(uint32_t temporal, TemporalMoment moment, Store& store);

  const Setting& setting_;
  SmtText& out_;
  const Configuration& at_;
  Expressions expressions_;
  std::vector<Outcome> outcomes_;
  std::vector<Term> out_of_range_;
};

}  // namespace glider::ir::certify
