// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

/// Terms of SMT-LIB as text. Those that are decided by "true" and "false" alone are simplified.
namespace glider::ir::certify {

using Term = std::string;

/// The exact value of a finite double, as a constant of sort Real.
Term literal(double value);
/// The exact value of 1 / `value`, which is finite and not 0.
Term reciprocal(double value);

Term negation(const Term& a);
Term conjunction(const std::vector<Term>& terms);
Term disjunction(const std::vector<Term>& terms);
Term implication(const Term& a, const Term& b);
Term choice(const Term& condition, const Term& a, const Term& b);
/// `(op a b …)`.
Term operation(std::string_view op, const std::vector<Term>& operands);

/// The declarations, definitions and assertions of a script, in order.
class SmtText {
 public:
  /// A name for `term`, of sort Bool or Real; the same for the same text. A symbol is its own name.
  Term define(std::string_view sort, const Term& term);
  Term boolean(const Term& term) { return define("Bool", term); }
  Term real(const Term& term) { return define("Real", term); }
  /// A new constant.
  Term fresh(std::string_view sort);
  void declare(const std::string& name, std::string_view sort);
  void require(const Term& term);
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::unordered_map<Term, Term> names_;
  size_t next_ = 0;
};

/// Whether `formula` is one term over `names` (quoted symbols) of truth, `let` and arithmetic: a
/// certificate may come from anyone, and must not end the command in which it stands, refer to a
/// name of the rules, or bring an assumption with it.
bool isOneTerm(std::string_view formula, std::span<const std::string> names);

/// How the names of the rules begin.
inline constexpr std::string_view kOwnNames = "glider.";

}  // namespace glider::ir::certify
