// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "tests/random_missions/random.h"

#include <optional>
#include <string>
#include <vector>

namespace glider::containment {

/// The types of a hard mission's expressions.
enum class Kind : uint8_t { Truth, Number, Length, Time, Angle, Latitude, Longitude };

/// As the text form of the IR writes it.
std::string typeText(Kind kind);

/// What an expression may read at its place; and sensors and clocks.
struct Named {
  std::string text;  ///< "(var n)", "(temporal 3)"
  Kind kind = Kind::Number;
  std::optional<uint32_t> state;     ///< of the state with this number only
  std::optional<ir::ListKind> list;  ///< of a temporal
};

/// Random expressions in the text form of the IR, each of the kind that is asked for.
class HardExpressions {
 public:
  explicit HardExpressions(random_missions::Random& random) : random_(random) {}

  void add(Named named) { named_.push_back(std::move(named)); }
  /// Where what is made from now on stands; no state: `always`, or an initial value.
  void stand(ir::ListKind list, std::optional<uint32_t> state) {
    list_ = list;
    state_ = state;
  }
  /// Of parameters and variables that come first: no sensor, no clock, no temporal.
  std::string plain(Kind kind);
  std::string constant(Kind kind);
  std::string of(Kind kind, uint32_t depth);
  /// A guard, mostly of clocks: the prover bounds those without a solver.
  std::string guard();
  /// A time of a duration: also 0, negative, a parameter's end, or unknown.
  std::string duration();
  std::string anything(uint32_t depth);

 private:
  std::optional<std::string> made(ir::Op op, Kind kind, uint32_t depth);
  std::optional<std::string> leaf(ir::Op op, Kind kind);
  std::optional<std::string> numbers(ir::Op op, Kind kind, uint32_t depth);
  std::optional<std::string> unary(ir::Op op, Kind kind, uint32_t depth);
  std::optional<std::string> function(ir::Op op, Kind kind, uint32_t depth);
  std::optional<std::string> called(Kind kind);
  std::optional<std::string> named(Kind kind, const char* word);
  std::string operation(ir::Op op, const std::vector<Kind>& operands, uint32_t depth);
  Kind measured();

  random_missions::Random& random_;
  std::vector<Named> named_;
  ir::ListKind list_ = ir::ListKind::Always;
  std::optional<uint32_t> state_;
};

}  // namespace glider::containment
