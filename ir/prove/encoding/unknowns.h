// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/terms.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>
#include <z3++.h>

namespace glider::ir::prove {

/// A known condition of an unknown, and its source.
struct Fact {
  enum class From : uint8_t { Nature, Sensor, Age, Variable, Temporal };
  z3::expr holds;
  From from = From::Nature;  ///< Nature: of clocks and arithmetic
  uint32_t index = 0;        ///< of the sensor, variable or temporal
};

/// Makes the unknowns of a question, each with a unique name, and keeps the facts known about them.
class Unknowns {
 public:
  /// `prefix` distinguishes them from those of other objects.
  explicit Unknowns(z3::context& context, std::string prefix = "")
      : context_(context), prefix_(std::move(prefix)) {}

  /// `of`: the number of the expression or temporal that it stands for, if it does for one.
  z3::expr real(const std::string& what, std::optional<uint32_t> of = std::nullopt);
  z3::expr truth(const std::string& what, std::optional<uint32_t> of = std::nullopt);
  z3::expr whole(const std::string& what);
  void require(const z3::expr& holds, Fact::From from = Fact::From::Nature, uint32_t index = 0) {
    facts_.push_back({holds, from, index});
  }
  [[nodiscard]] const std::vector<Fact>& facts() const { return facts_; }
  /// All unknowns, in the order in which they were made.
  [[nodiscard]] const std::vector<z3::expr>& made() const { return made_; }
  /// What each stands for, in the same order.
  [[nodiscard]] const std::vector<std::optional<uint32_t>>& standFor() const { return of_; }
  [[nodiscard]] z3::context& context() { return context_; }
  /// The result of an operation that was made for the same operands: `key` names the operation, the
  /// terms its operands. Null: none was.
  [[nodiscard]] const NumberTerm* resultOf(const std::string& key,
                                           const std::vector<z3::expr>& terms) const;
  void keepResult(const std::string& key, std::vector<z3::expr> terms, const NumberTerm& result);

 private:
  /// The operands are kept, so that their numbers in Z3 stay theirs.
  struct Result {
    std::vector<z3::expr> terms;
    NumberTerm value;
  };
  static std::string fullKey(const std::string& key, const std::vector<z3::expr>& terms);

  z3::context& context_;
  std::string prefix_;
  std::vector<z3::expr> made_;
  std::vector<std::optional<uint32_t>> of_;
  std::vector<Fact> facts_;
  std::map<std::string, Result> results_;
};

}  // namespace glider::ir::prove
