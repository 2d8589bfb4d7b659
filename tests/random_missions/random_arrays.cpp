// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_missions/random_arrays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <string_view>

namespace glider::random_missions {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct Expression {
  std::string text;
  std::function<double(const Memory&)> value;
};
double settled(double x) {
  return !std::isfinite(x) ? kUnknown : std::fabs(x) <= 0x1p-1022 ? 0.0 : x;
}

std::vector<double> knownOf(const std::vector<double>& all) {
  std::vector<double> known;
  std::ranges::copy_if(all, std::back_inserter(known), [](double x) { return !std::isnan(x); });
  return known;
}

double ofArray(const std::string& function, const std::vector<double>& all) {
  const std::vector<double> known = knownOf(all);
  if (known.empty()) {
    return kUnknown;
  }
  const auto [least, most] = std::ranges::minmax(known);
  if (function == "lowest") {
    return least;
  }
  if (function == "highest") {
    return most;
  }
  if (function == "spread") {
    return settled(most - least);
  }
  double sum = 0;
  for (const double x : known) {
    sum = settled(sum + settled(x - known.front()));
  }
  const double mean = settled(known.front() + settled(sum / static_cast<double>(known.size())));
  return std::isnan(mean) ? mean : std::clamp(mean, least, most);
}

/// The element of `all` with that number; null if there is none.
template <typename Numbers>
auto* elementOf(Numbers& all, double number) {
  const bool there =
      number >= 0 && number < static_cast<double>(all.size()) && number == std::floor(number);
  return there ? &all[static_cast<size_t>(number)] : nullptr;
}

class Generator {
 public:
  explicit Generator(uint64_t seed) : random_(seed) {
    for (const char* name : {"a", "b"}) {
      const size_t size = below(10) == 0 ? 64 : 2 + below(4);
      std::vector<double> values;
      for (size_t i = 0; i < size; ++i) {
        values.push_back(below(4) == 0 ? kUnknown : static_cast<double>(below(20)) / 2);
      }
      declare(name, values);
    }
    memory_.numbers = {{"x", 1.5}, {"n", 1}, {"u", kUnknown}};
    constants_ = {3, 1, 4, 1.5};
  }

  RandomArrays make() {
    Program all = program(3, 4);
    return {declarations_ +
                "const c = [3, 1, 4, 1.5]\nvar x: number = 1.5\nvar n: number = 1\n"
                "var u: number = unknown\n",
            std::move(all.text), memory_, std::move(all.run)};
  }

 private:
  struct Program {
    std::string text;
    std::function<void(Memory&)> run;
  };

  Program program(int depth, size_t statements) {
    std::vector<Program> all;
    std::string text;
    for (size_t i = 0; i < statements; ++i) {
      all.push_back(statement(depth));
      text += all.back().text;
    }
    return {text, [all](Memory& m) {
              for (const Program& each : all) {
                each.run(m);
              }
            }};
  }

  size_t below(size_t n) { return std::uniform_int_distribution<size_t>(0, n - 1)(random_); }
  template <typename T>
  T pick(std::initializer_list<T> all) {
    return *(all.begin() + static_cast<ptrdiff_t>(below(all.size())));
  }

  void declare(const std::string& name, const std::vector<double>& values) {
    std::string list;
    for (const double value : values) {
      list +=
          (list.empty() ? "" : ", ") + (std::isnan(value) ? "unknown" : fmt::format("{}", value));
    }
    declarations_ += fmt::format("var {}[{}]: number = [{}]\n", name, values.size(), list);
    memory_.arrays[name] = values;
  }

  // --- expressions ---

  Expression number(double value) {
    return {value < 0 ? fmt::format("({})", value) : fmt::format("{}", value),
            [value](const Memory&) { return value; }};
  }
  Expression variable(const std::string& name) {
    return {name, [name](const Memory& m) { return m.numbers.at(name); }};
  }

  /// An index of an array of `size`: a constant one is right, any other may be anything.
  Expression index(size_t size, int depth) {
    if (below(3) == 0) {
      return number(static_cast<double>(below(size)));
    }
    for (const Loop& loop : loops_) {
      if (loop.first >= 0 && loop.last < static_cast<double>(size) && below(2) == 0) {
        return variable(loop.name);
      }
    }
    const Expression other = expression(depth - 1);
    const Expression n = variable("n");
    return {fmt::format("n + {} - 1", other.text), [n, other](const Memory& m) {
              return settled(settled(n.value(m) + other.value(m)) - 1);
            }};
  }

  Expression element(int depth) {
    if (below(5) == 0) {
      const Expression at = index(constants_.size(), depth);
      return {"c[" + at.text + "]", [at, all = constants_](const Memory& m) {
                const double* found = elementOf(all, at.value(m));
                return found == nullptr ? kUnknown : *found;
              }};
    }
    const std::string name = pick({"a", "b"});
    const Expression at = index(memory_.arrays[name].size(), depth);
    return {name + "[" + at.text + "]", [name, at](const Memory& m) {
              const double* found = elementOf(m.arrays.at(name), at.value(m));
              return found == nullptr ? kUnknown : *found;
            }};
  }

  Expression binary(int depth) {
    const Expression l = expression(depth - 1);
    const Expression r = expression(depth - 1);
    switch (below(5)) {
      case 0:
        return {"(" + l.text + " + " + r.text + ")",
                [l, r](const Memory& m) { return settled(l.value(m) + r.value(m)); }};
      case 1:
        return {"(" + l.text + " - " + r.text + ")",
                [l, r](const Memory& m) { return settled(l.value(m) - r.value(m)); }};
      case 2:
        return {"(" + l.text + " * " + r.text + ")",
                [l, r](const Memory& m) { return settled(l.value(m) * r.value(m)); }};
      default:
        const bool least = below(2) == 0;
        return {fmt::format("{}({}, {})", least ? "min" : "max", l.text, r.text),
                [l, r, least](const Memory& m) {
                  const double a = l.value(m);
                  const double b = r.value(m);
                  return std::isnan(a) || std::isnan(b) ? kUnknown
                         : least                        ? std::min(a, b)
                                                        : std::max(a, b);
                }};
    }
  }

  Expression expression(int depth) {
    switch (below(depth > 0 ? 8 : 3)) {
      case 0:
        return number(static_cast<double>(below(9)) / 2 - 1);
      case 1:
        return variable(pick({"x", "n", "u"}));
      case 2:
        return loops_.empty() ? variable("n") : variable(loops_[below(loops_.size())].name);
      case 3:
      case 4:
        return binary(depth);
      case 5: {
        const std::string function = pick({"mean", "lowest", "highest", "spread"});
        const std::string name = pick({"a", "b"});
        return {function + "(" + name + ")",
                [function, name](const Memory& m) { return ofArray(function, m.arrays.at(name)); }};
      }
      default:
        return element(depth);
    }
  }

  Expression condition(int depth) {
    const Expression l = expression(depth);
    if (below(3) == 0) {
      return {"known(" + l.text + ")",
              [l](const Memory& m) { return std::isnan(l.value(m)) ? 0.0 : 1.0; }};
    }
    const Expression r = expression(depth);
    const bool less = below(2) == 0;
    return {l.text + (less ? " < " : " >= ") + r.text, [l, r, less](const Memory& m) {
              const double a = l.value(m);
              const double b = r.value(m);
              return std::isnan(a) || std::isnan(b) ? kUnknown : (a < b) == less ? 1.0 : 0.0;
            }};
  }

  // --- statements ---

  Program setNumber() {
    const std::string name = pick({"x", "n", "u"});
    const Expression e = expression(2);
    return {fmt::format("set {} = {}\n", name, e.text), [name, e](Memory& m) {
              const double value = e.value(m);
              m.numbers[name] = std::isnan(value) ? m.numbers[name] : value;
            }};
  }
  Program setElement() {
    const std::string name = pick({"a", "b"});
    const Expression at = index(memory_.arrays[name].size(), 2);
    const Expression e = expression(2);
    return {fmt::format("set {}[{}] = {}\n", name, at.text, e.text), [name, at, e](Memory& m) {
              double* found = elementOf(m.arrays[name], at.value(m));
              const double value = e.value(m);
              if (found != nullptr && !std::isnan(value)) {
                *found = value;
              }
            }};
  }
  Program push() {
    const std::string name = pick({"a", "b"});
    Expression e = expression(2);
    while (e.text.find(name + "[") != std::string::npos ||
           e.text.find("(" + name + ")") != std::string::npos) {
      e = expression(1);
    }
    return {fmt::format("push({}, {})\n", name, e.text), [name, e](Memory& m) {
              const double value = e.value(m);
              std::vector<double>& all = m.arrays[name];
              if (std::isnan(value)) {
                return;
              }
              for (size_t i = all.size() - 1; i > 0; --i) {
                all[i] = std::isnan(all[i - 1]) ? all[i] : all[i - 1];
              }
              all[0] = value;
            }};
  }
  Program branch(int depth) {
    const Expression c = condition(1);
    const Program then = program(depth - 1, 1 + below(2));
    const Program otherwise = program(depth - 1, below(2));
    return {fmt::format("if {} then\n{}else\n{}end\n", c.text, then.text, otherwise.text),
            [c, then, otherwise](Memory& m) {
              const double value = c.value(m);
              if (value == 1.0) {
                then.run(m);
              } else if (value == 0.0) {
                otherwise.run(m);
              }
            }};
  }
  Program loop(int depth) {
    constexpr std::string_view kNames[] = {"i", "j", "k"};
    if (loops_.size() == std::size(kNames)) {
      return setNumber();
    }
    const std::string name(kNames[loops_.size()]);
    const auto first = static_cast<double>(below(3));
    // Sometimes as far as the loop around it has come, and so at times without a pass.
    const bool triangle = !loops_.empty() && below(2) == 0;
    const std::string outer = triangle ? loops_.back().name : "";
    const double last = triangle ? loops_.back().last
                                 : first - (below(6) == 0 ? 1 : 0) + static_cast<double>(below(3));
    loops_.push_back({name, first, last});
    const Program body = program(depth - 1, 1 + below(2));
    loops_.pop_back();
    return {fmt::format("for {} in {} .. {} do\n{}end\n", name, first,
                        triangle ? outer : fmt::format("{}", last), body.text),
            [=](Memory& m) {
              const double end = triangle ? m.numbers.at(outer) : last;
              for (double i = first; i <= end; ++i) {
                m.numbers[name] = i;
                body.run(m);
              }
              m.numbers.erase(name);
            }};
  }
  Program statement(int depth) {
    switch (below(depth > 0 ? 9 : 4)) {
      case 0:
        return setNumber();
      case 1:
      case 2:
        return setElement();
      case 3:
        return push();
      case 4:
      case 5:
        return branch(depth);
      default:
        return loop(depth);
    }
  }

  struct Loop {
    std::string name;
    double first;
    double last;
  };

  std::mt19937_64 random_;
  Memory memory_;
  std::string declarations_;
  std::vector<double> constants_;
  std::vector<Loop> loops_;  ///< around what is being made
};

}  // namespace

RandomArrays randomArrays(uint64_t seed) {
  return Generator(seed).make();
}

}  // namespace glider::random_missions
