// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/validate/numbers.h"

#include <bit>
#include <cmath>
#include <iterator>
#include <utility>

namespace glider::codegen::validate {
namespace {

constexpr uint64_t kSignBit = uint64_t{1} << 63U;
constexpr uint64_t kInfinity = uint64_t{0x7FF} << 52U;
constexpr uint64_t kSmallestNormal = uint64_t{1} << 52U;
constexpr uint64_t kNan = uint64_t{0x7FF8} << 48U;

uint64_t bitsOf(const z3::expr& numeral) {
  return numeral.get_numeral_uint64();
}

bool isPowerOfTwo(double x) {
  int exponent = 0;
  return std::isnormal(x) && std::abs(std::frexp(x, &exponent)) == 0.5 && std::isnormal(1 / x);
}

}  // namespace

double doubleOf(const z3::expr& numeral) {
  return std::bit_cast<double>(bitsOf(numeral));
}

z3::expr Numbers::constant(double value) {
  return std::isnan(value) ? unknown() : z3_.bv_val(std::bit_cast<uint64_t>(value), kNumberBits);
}

z3::expr Numbers::unknown() {
  return z3_.bv_val(kNan, kNumberBits);
}

z3::expr Numbers::isKnown(const z3::expr& x) {
  return z3::ule(magnitude(x), z3_.bv_val(kInfinity, kNumberBits)).simplify();
}

z3::expr Numbers::kept(const z3::expr& x) {
  kept_.push_back(x);
  return x;
}

void Numbers::assumeCanonical(const z3::expr& x) {
  canonical_.insert(kept(x).id());
}

z3::expr Numbers::canonical(const z3::expr& x) {
  if (canonical_.contains(x.id())) {
    return x;
  }
  z3::expr result = z3::ite(isKnown(x), x, unknown()).simplify();
  assumeCanonical(result);
  return result;
}

z3::expr Numbers::settle(const z3::expr& x) {
  const z3::expr size = magnitude(x);
  z3::expr result = z3::ite(z3::uge(size, z3_.bv_val(kInfinity, kNumberBits)), unknown(),
                            z3::ite(z3::ule(size, z3_.bv_val(kSmallestNormal, kNumberBits)),
                                    z3_.bv_val(0, kNumberBits), x))
                        .simplify();
  assumeCanonical(result);
  return result;
}

z3::expr Numbers::negate(const z3::expr& x) {
  if (const auto found = negated_.find(x.id()); found != negated_.end()) {
    return found->second;
  }
  z3::expr result = (x ^ z3_.bv_val(kSignBit, kNumberBits)).simplify();
  negated_.emplace(kept(result).id(), kept(x));
  return result;
}

z3::expr Numbers::magnitude(const z3::expr& x) {
  return (x & z3_.bv_val(~kSignBit, kNumberBits)).simplify();
}

z3::expr Numbers::call(const std::string& name, const z3::sort& range,
                       const std::vector<z3::expr>& arguments) {
  z3::expr_vector given(z3_);
  z3::sort_vector sorts(z3_);
  for (const z3::expr& argument : arguments) {
    const bool number = argument.is_bv() && argument.get_sort().bv_size() == kNumberBits;
    given.push_back(number ? canonical(argument) : argument);
    sorts.push_back(argument.get_sort());
  }
  return z3_.function(name.c_str(), sorts, range)(given);
}

z3::expr Numbers::numberOf(const std::string& name, const std::vector<z3::expr>& arguments) {
  return canonical(call(name, z3_.bv_sort(kNumberBits), arguments));
}

z3::expr Numbers::sqrt(const z3::expr& x) {
  return x.is_numeral() ? constant(std::sqrt(doubleOf(x)))
                        : z3::ite(isKnown(x), numberOf("sqrt", {x}), unknown()).simplify();
}

z3::expr Numbers::rounded(const char* name, const z3::expr& a, const z3::expr& b) {
  // NaN stays NaN: the one thing that is known of them.
  return z3::ite(isKnown(a) && isKnown(b), numberOf(name, {a, b}), unknown()).simplify();
}

/// Of an operation whose operands may change places. LLVM puts constants last, and behind other
/// operands what is negated, which then becomes a subtraction.
z3::expr Numbers::eitherWay(const char* name, const z3::expr& a, const z3::expr& b) {
  const auto isLast = [&](const z3::expr& x) {
    return x.is_numeral() ? 2 : negated_.contains(x.id()) ? 1 : 0;
  };
  return isLast(a) > isLast(b) ? rounded(name, b, a) : rounded(name, a, b);
}

z3::expr Numbers::add(const z3::expr& a, const z3::expr& b) {
  if (a.is_numeral() && b.is_numeral()) {
    return constant(doubleOf(a) + doubleOf(b));
  }
  for (const auto& [x, other] : {std::pair(a, b), std::pair(b, a)}) {
    if (other.is_numeral() && bitsOf(other) == kSignBit) {  // x + -0 is x
      return canonical(x);
    }
  }
  return eitherWay("add", a, b);
}

z3::expr Numbers::subtract(const z3::expr& a, const z3::expr& b) {
  return add(a, negate(b));
}

z3::expr Numbers::multiply(const z3::expr& a, const z3::expr& b) {
  if (a.is_numeral() && b.is_numeral()) {
    return constant(doubleOf(a) * doubleOf(b));
  }
  for (const auto& [x, factor] : {std::pair(a, b), std::pair(b, a)}) {
    if (!factor.is_numeral()) {
      continue;
    }
    if (std::abs(doubleOf(factor)) == 1) {
      return canonical(doubleOf(factor) > 0 ? x : negate(x));
    }
    if (const auto found = negated_.find(x.id()); found != negated_.end()) {
      return multiply(found->second, negate(factor));
    }
  }
  return eitherWay("multiply", a, b);
}

z3::expr Numbers::divide(const z3::expr& a, const z3::expr& b) {
  if (a.is_numeral() && b.is_numeral()) {
    return constant(doubleOf(a) / doubleOf(b));
  }
  if (b.is_numeral() && isPowerOfTwo(doubleOf(b))) {
    return multiply(a, constant(1 / doubleOf(b)));
  }
  return rounded("divide", a, b);
}

/// As signed numbers, these are in the order of the doubles, both zeros at 0.
z3::expr Numbers::order(const z3::expr& x) {
  const z3::expr zero = z3_.bv_val(0, kNumberBits);
  const z3::expr below = x ^ z3_.bv_val(~kSignBit, kNumberBits);
  return z3::ite(x == z3_.bv_val(kSignBit, kNumberBits), zero, z3::ite(x < zero, below, x))
      .simplify();
}

z3::expr Numbers::less(const z3::expr& a, const z3::expr& b) {
  return (isKnown(a) && isKnown(b) && order(a) < order(b)).simplify();
}

z3::expr Numbers::equal(const z3::expr& a, const z3::expr& b) {
  return (isKnown(a) && isKnown(b) && order(a) == order(b)).simplify();
}

z3::expr Numbers::compare(llvm::CmpInst::Predicate predicate, const z3::expr& a,
                          const z3::expr& b) {
  // A predicate of LLVM is a set of these four.
  constexpr unsigned kEqual = 1;
  constexpr unsigned kGreater = 2;
  constexpr unsigned kLess = 4;
  constexpr unsigned kUnordered = 8;
  const auto set = static_cast<unsigned>(predicate);
  if ((set & kUnordered) != 0) {
    return (!compare(llvm::CmpInst::getInversePredicate(predicate), a, b)).simplify();
  }
  const z3::expr known = isKnown(a) && isKnown(b);
  switch (set) {
    case kEqual:
      return equal(a, b);
    case kGreater:
      return less(b, a);
    case kLess:
      return less(a, b);
    case kEqual | kGreater:
      return (known && !less(a, b)).simplify();
    case kEqual | kLess:
      return (known && !less(b, a)).simplify();
    case kLess | kGreater:
      return (known && !equal(a, b)).simplify();
    case kEqual | kLess | kGreater:
      return known.simplify();
    default:
      return z3_.bool_val(false);
  }
}

z3::expr Numbers::isOfClass(const z3::expr& x, uint64_t classes) {
  const auto bits = [&](uint64_t value) { return z3_.bv_val(value, kNumberBits); };
  const z3::expr size = magnitude(x);
  const z3::expr negative = x < bits(0);
  const z3::expr infinite = size == bits(kInfinity);
  const z3::expr zero = size == bits(0);
  const z3::expr subnormal = !zero && z3::ult(size, bits(kSmallestNormal));
  const z3::expr nan = z3::ugt(size, bits(kInfinity));
  const z3::expr normal = !infinite && !zero && !subnormal && !nan;
  const z3::expr quiet = nan && z3::uge(size, bits(kNan));
  const z3::expr is[] = {nan && !quiet,         quiet,
                         negative && infinite,  negative && normal,
                         negative && subnormal, negative && zero,
                         !negative && zero,     !negative && subnormal,
                         !negative && normal,   !negative && infinite};
  z3::expr any = z3_.bool_val(false);
  for (size_t i = 0; i < std::size(is); ++i) {
    if ((classes >> i & 1U) != 0) {
      any = any || is[i];
    }
  }
  return any.simplify();
}

z3::expr Numbers::fromWhole(const z3::expr& whole) {
  if (whole.is_numeral()) {
    return constant(static_cast<int32_t>(whole.get_numeral_uint64()));
  }
  return numberOf("from_whole", {whole});
}

/// A number below the greatest that was learned becomes one of those.
z3::expr Numbers::toWhole(const z3::expr& x) {
  const z3::expr whole = call("to_whole", z3_.bv_sort(32), {x});
  const z3::expr inside =
      !less(x, constant(0)) && less(x, constant(static_cast<double>(whole_count_)));
  addFact(whole, z3::implies(inside, z3::ult(whole, z3_.bv_val(whole_count_, 32))));
  return whole;
}

void Numbers::learnWhole(uint32_t count) {
  for (; whole_count_ < count; ++whole_count_) {
    const z3::expr whole = z3_.bv_val(whole_count_, 32);
    const z3::expr number = constant(whole_count_);
    // Of every whole number: no term shows where it matters.
    addFact(z3_.bool_val(true), call("from_whole", z3_.bv_sort(kNumberBits), {whole}) == number);
    addFact(z3_.bool_val(true), call("to_whole", z3_.bv_sort(32), {number}) == whole);
  }
}

std::optional<z3::expr> resultOf(const std::string& name, const std::vector<z3::expr>& operands) {
  z3::context& z3 = operands.front().ctx();
  const auto number = [&](double value) {
    return z3.bv_val(std::isnan(value) ? kNan : std::bit_cast<uint64_t>(value), kNumberBits);
  };
  const double a = operands[0].get_sort().bv_size() == kNumberBits ? doubleOf(operands[0]) : 0;
  if (name == "sqrt") {
    return number(std::sqrt(a));
  }
  if (name == "from_whole") {
    return number(static_cast<int32_t>(operands[0].get_numeral_uint64()));
  }
  if (name == "to_whole" && std::abs(a) < INT32_MAX) {
    return z3.bv_val(static_cast<int32_t>(a), 32);
  }
  if (operands.size() != 2 || operands[1].get_sort().bv_size() != kNumberBits) {
    return {};
  }
  const double b = doubleOf(operands[1]);
  return name == "add"        ? std::optional(number(a + b))
         : name == "multiply" ? std::optional(number(a * b))
         : name == "divide"   ? std::optional(number(a / b))
                              : std::nullopt;
}

}  // namespace glider::codegen::validate
