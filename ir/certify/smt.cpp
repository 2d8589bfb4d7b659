// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/certify/smt.h"

#include "support/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace glider::ir::certify {
namespace {

constexpr int kBitsOfMantissa = 53;
/// A power of two that a double holds, for the denominators that it does not hold.
constexpr int kLargePower = 1000;

struct Ratio {
  double numerator = 0;  ///< whole, positive
  int power = 0;         ///< of two, by which it is divided; not negative
};

/// `magnitude` (positive) as a ratio; exact.
Ratio ratioOf(double magnitude) {
  int exponent = 0;
  double whole = std::ldexp(std::frexp(magnitude, &exponent), kBitsOfMantissa);
  exponent -= kBitsOfMantissa;
  while (exponent < 0 && std::fmod(whole, 2) == 0) {
    whole /= 2;
    ++exponent;
  }
  return exponent >= 0 ? Ratio{magnitude, 0} : Ratio{whole, -exponent};
}

std::string wholeNumber(double value) {
  return fmt::format("{:.0f}.0", value);
}

std::string powerOfTwo(int power) {
  return power <= kLargePower ? wholeNumber(std::ldexp(1, power))
                              : fmt::format("(* {} {})", wholeNumber(std::ldexp(1, kLargePower)),
                                            wholeNumber(std::ldexp(1, power - kLargePower)));
}

Term withSign(double value, const Term& magnitude) {
  return value < 0 ? fmt::format("(- {})", magnitude) : magnitude;
}

/// `(op …)` without `neutral`; `ruling` if that is among them.
Term joined(std::string_view op, const std::vector<Term>& terms, std::string_view neutral,
            std::string_view ruling) {
  std::vector<Term> rest;
  for (const Term& term : terms) {
    if (term == ruling) {
      return term;
    }
    if (term != neutral) {
      rest.push_back(term);
    }
  }
  if (rest.empty()) {
    return Term(neutral);
  }
  return rest.size() == 1 ? rest.front() : operation(op, rest);
}

constexpr std::string_view kSpace = " \t\r\n";
/// What formulas may contain beside names, numbers and the variables of `let`. Quantifiers,
/// annotations and what cvc5 adds to SMT-LIB are not among them.
constexpr auto kWords = std::to_array<std::string_view>(
    {"true", "false",    "not", "and", "or",      "xor",    "=>",    "ite", "let",
     "=",    "distinct", "<",   "<=",  ">",       ">=",     "+",     "-",   "*",
     "/",    "abs",      "div", "mod", "to_real", "to_int", "is_int"});

/// Text up to the end of the token that begins at `i`: a bracket, one space, a quoted symbol or a
/// word.
std::string_view tokenAt(std::string_view text, size_t i) {
  if (text[i] == '(' || text[i] == ')' || kSpace.contains(text[i])) {
    return text.substr(i, 1);
  }
  if (text[i] == '|') {
    const size_t end = text.find('|', i + 1);
    return text.substr(i, end == std::string_view::npos ? end : end + 1 - i);
  }
  const size_t end = text.find_first_of(" \t\r\n()|", i);
  return text.substr(i, end == std::string_view::npos ? end : end - i);
}

/// A word of kWords, a number, or a variable of `let`: a letter, and then at most digits, `!` and
/// `_`.
bool isHarmless(std::string_view word) {
  const std::string_view rest = word.substr(1);
  const char first = word.front();
  const bool letter = (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z');
  const bool digit = first >= '0' && first <= '9';
  return std::ranges::find(kWords, word) != kWords.end() ||
         (letter && rest.find_first_not_of("0123456789!_") == std::string_view::npos) ||
         (digit && rest.find_first_not_of("0123456789.") == std::string_view::npos);
}

/// A symbol is the same with and without its bars.
bool isNamed(std::string_view token, std::span<const std::string> names) {
  return std::ranges::any_of(names, [&](const std::string& name) {
    return token == name || token == std::string_view(name).substr(1, name.size() - 2);
  });
}

}  // namespace

Term literal(double value) {
  CHECK(std::isfinite(value), "a number without an end");
  if (value == 0) {
    return "0.0";
  }
  const Ratio ratio = ratioOf(std::fabs(value));
  return withSign(value, ratio.power == 0 ? wholeNumber(ratio.numerator)
                                          : fmt::format("(/ {} {})", wholeNumber(ratio.numerator),
                                                        powerOfTwo(ratio.power)));
}

Term reciprocal(double value) {
  const Ratio ratio = ratioOf(std::fabs(value));
  return withSign(value,
                  fmt::format("(/ {} {})", powerOfTwo(ratio.power), wholeNumber(ratio.numerator)));
}

Term negation(const Term& a) {
  if (a == "true" || a == "false") {
    return a == "true" ? "false" : "true";
  }
  return operation("not", {a});
}

Term conjunction(const std::vector<Term>& terms) {
  return joined("and", terms, "true", "false");
}

Term disjunction(const std::vector<Term>& terms) {
  return joined("or", terms, "false", "true");
}

Term implication(const Term& a, const Term& b) {
  return disjunction({negation(a), b});
}

Term choice(const Term& condition, const Term& a, const Term& b) {
  if (condition == "true" || a == b) {
    return a;
  }
  return condition == "false" ? b : operation("ite", {condition, a, b});
}

Term operation(std::string_view op, const std::vector<Term>& operands) {
  return fmt::format("({} {})", op, fmt::join(operands, " "));
}

Term SmtText::define(std::string_view sort, const Term& term) {
  if (!term.starts_with('(')) {
    return term;
  }
  const auto [found, is_new] = names_.try_emplace(term);
  if (is_new) {
    found->second = fmt::format("{}t{}", kOwnNames, next_++);
    text_ += fmt::format("(define-fun {} () {} {})\n", found->second, sort, term);
  }
  return found->second;
}

Term SmtText::fresh(std::string_view sort) {
  Term name = fmt::format("{}c{}", kOwnNames, next_++);
  declare(name, sort);
  return name;
}

void SmtText::declare(const std::string& name, std::string_view sort) {
  text_ += fmt::format("(declare-const {} {})\n", name, sort);
}

void SmtText::require(const Term& term) {
  if (term != "true") {
    text_ += fmt::format("(assert {})\n", term);
  }
}

bool isOneTerm(std::string_view formula, std::span<const std::string> names) {
  size_t open = 0;
  size_t ended = 0;  // terms outside of all brackets
  for (size_t i = 0; i < formula.size();) {
    const std::string_view token = tokenAt(formula, i);
    i += token.size();
    if (kSpace.contains(token.front())) {
      continue;
    }
    if (token == "(") {
      ++open;
      continue;
    }
    if (token == ")") {
      if (open == 0) {
        return false;
      }
      --open;
    } else if (!isNamed(token, names) && !isHarmless(token)) {
      return false;
    }
    ended += open == 0 ? 1 : 0;
  }
  return open == 0 && ended == 1;
}

}  // namespace glider::ir::certify
