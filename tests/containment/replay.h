// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/scopes.h"
#include "tests/containment/flight.h"

#include <map>
#include <optional>
#include <set>
#include <vector>

namespace glider::containment {

/// Makes the tick of a flight once more, statement by statement, given which cases fired: for what
/// the interpreter does not show, the values that expressions have in the middle of it.
class Replay {
 public:
  explicit Replay(const ir::Mission& mission)
      : m_(mission), reads_(readsOf(mission)), watched_(mission.temporals.size()) {}

  /// After Flight::start; after the two halves of each tick.
  void start(const Flight& flight);
  void begun(const Flight& flight);
  void decided(const Flight& flight);

  struct Watched {
    bool was = false;
    double since = 0;
  };
  /// Of each temporal that is current, after the latest tick; and before it.
  [[nodiscard]] const std::vector<Watched>& watched() const { return watched_; }
  [[nodiscard]] const std::vector<Watched>& watchedBefore() const { return before_; }
  /// The values (NaN: unknown; a truth value 0 or 1) that an expression had in the latest tick.
  [[nodiscard]] std::vector<double> valuesOf(uint32_t expression) const;
  [[nodiscard]] std::vector<double> windowsOf(uint32_t temporal) const;
  /// What it leaves: those of the interpreter, if it is right.
  [[nodiscard]] const std::vector<double>& variables() const { return variables_; }

 private:
  [[nodiscard]] ir::Value value(ir::ExprId id) const;
  [[nodiscard]] double number(ir::ExprId id) const { return ir::asNumber(value(id)); }
  void record();
  void takeTemporals(const Flight& flight);
  void execute(ir::BlockId block);
  void list(ir::ListKind list, const std::vector<ir::Case>& cases);
  void activity(ir::ListKind list, const ir::Activity& activity);
  void move(const ir::Case& c);
  void watch(ir::StateId state, bool always);
  void enter();

  const ir::Mission& m_;
  std::vector<ir::Reads> reads_;
  const Flight* flight_ = nullptr;
  ir::StateId state_;
  double entered_ = 0, resumed_ = 0;
  std::vector<double> variables_;
  std::vector<double> temporals_;
  std::vector<Watched> watched_, before_;
  std::map<uint32_t, std::vector<double>> values_;
  std::map<uint32_t, std::vector<double>> windows_;
};

}  // namespace glider::containment
