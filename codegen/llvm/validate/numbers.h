// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <llvm/IR/InstrTypes.h>

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>
#include <z3++.h>

namespace glider::codegen::validate {

inline constexpr unsigned kNumberBits = 64;

/// Doubles as terms for Z3: 64 bits each, with their order, sign and NaN exactly as IEEE 754 has
/// them. Operations that round are functions of which nothing is known but that equal operands give
/// equal results, in a normal form: code and mission agree if they round the same operands in the
/// same order. The payload of a NaN is never looked at by anything that flies, so there is one NaN.
class Numbers {
 public:
  explicit Numbers(z3::context& z3) : z3_(z3) {}

  z3::expr constant(double value);
  z3::expr unknown();
  /// Whether it is not a NaN.
  z3::expr isKnown(const z3::expr& x);
  /// The same number, a NaN as the one that is used here.
  z3::expr canonical(const z3::expr& x);
  /// `x` is a term that has no other NaN.
  void assumeCanonical(const z3::expr& x);
  /// ir/README.md: infinities and NaN become unknown, magnitudes of 2^-1022 or less +0.
  z3::expr settle(const z3::expr& x);

  z3::expr negate(const z3::expr& x);
  z3::expr magnitude(const z3::expr& x);
  z3::expr sqrt(const z3::expr& x);
  z3::expr add(const z3::expr& a, const z3::expr& b);
  z3::expr subtract(const z3::expr& a, const z3::expr& b);
  z3::expr multiply(const z3::expr& a, const z3::expr& b);
  z3::expr divide(const z3::expr& a, const z3::expr& b);

  /// False if either is a NaN.
  z3::expr less(const z3::expr& a, const z3::expr& b);
  z3::expr equal(const z3::expr& a, const z3::expr& b);
  /// Whether it is of one of the classes of LLVM's is.fpclass, a bit each.
  z3::expr isOfClass(const z3::expr& x, uint64_t classes);
  z3::expr compare(llvm::CmpInst::Predicate predicate, const z3::expr& a, const z3::expr& b);

  /// A double and a whole number of 32 bits, signed, as each other (LLVM's sitofp and fptosi).
  z3::expr fromWhole(const z3::expr& whole);
  z3::expr toWhole(const z3::expr& x);
  /// What must be known of the two above for tables of up to `count` elements.
  void learnWhole(uint32_t count);

  /// A function of which nothing is known; numbers among its arguments are made canonical.
  z3::expr call(const std::string& name, const z3::sort& range,
                const std::vector<z3::expr>& arguments);
  /// The same, for a result that is a number: canonical.
  z3::expr numberOf(const std::string& name, const std::vector<z3::expr>& arguments);

  /// What is known of a term; it matters only where that occurs.
  struct Fact {
    z3::expr about;
    z3::expr holds;
  };
  [[nodiscard]] const std::vector<Fact>& facts() const { return facts_; }
  void addFact(const z3::expr& about, const z3::expr& holds) { facts_.push_back({about, holds}); }

  z3::context& z3() { return z3_; }

 private:
  z3::expr order(const z3::expr& x);
  z3::expr rounded(const char* name, const z3::expr& a, const z3::expr& b);
  z3::expr eitherWay(const char* name, const z3::expr& a, const z3::expr& b);
  z3::expr kept(const z3::expr& x);

  z3::context& z3_;
  std::vector<Fact> facts_;
  std::vector<z3::expr> kept_;  ///< so that their numbers stay theirs
  std::unordered_set<unsigned> canonical_;
  std::unordered_map<unsigned, z3::expr> negated_;
  uint32_t whole_count_ = 0;
};

/// The double that a numeral of 64 bits is.
double doubleOf(const z3::expr& numeral);

/// The result that an operation really has, one that is only a name above: of "add" and so on with
/// these numerals. Empty: it is another function.
std::optional<z3::expr> resultOf(const std::string& name, const std::vector<z3::expr>& operands);

}  // namespace glider::codegen::validate
