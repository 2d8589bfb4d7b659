// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/validate/comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

namespace glider::codegen::validate {
namespace {

/// Z3's own measure of work, the same on every machine: some ten seconds.
constexpr unsigned kMostWork = 20'000'000;
constexpr size_t kMostValues = 8;
constexpr uint32_t kMostRounds = 12;

/// What may differ, in words, and when it does.
struct Difference {
  std::string what;
  z3::expr when;
  z3::expr meant;
  z3::expr done;
};

/// To the solver, what rounds may give anything. Where that leads it to a difference, it learns
/// what the operations really give there.
class Rounding {
 public:
  /// Of the operations in `term`.
  explicit Rounding(const z3::expr& term) {
    std::vector<z3::expr> open{term};
    while (!open.empty()) {
      const z3::expr one = open.back();
      open.pop_back();
      if (!one.is_app() || !parts_.insert(one.id()).second) {
        continue;
      }
      for (unsigned i = 0; i < one.num_args(); ++i) {
        open.push_back(one.arg(i));
      }
      if (one.num_args() > 0 && one.decl().decl_kind() == Z3_OP_UNINTERPRETED) {
        operations_.push_back(one);
      }
    }
  }

  [[nodiscard]] bool has(const z3::expr& part) const {
    return part.is_true() || parts_.contains(part.id());
  }
  [[nodiscard]] const std::vector<z3::expr>& learned() const { return learned_; }

  /// Whether in `model` every operation gives what it really gives. If not, the solver learns it.
  bool isReal(const z3::model& model) {
    bool real = true;
    for (const z3::expr& operation : operations_) {
      std::vector<z3::expr> operands;
      z3::expr_vector given(operation.ctx());
      for (unsigned i = 0; i < operation.num_args(); ++i) {
        operands.push_back(model.eval(operation.arg(i), true));
        given.push_back(operands.back());
      }
      if (!std::ranges::all_of(operands, [](const z3::expr& e) { return e.is_numeral(); })) {
        continue;
      }
      const auto result = resultOf(operation.decl().name().str(), operands);
      if (result && !z3::eq(*result, model.eval(operation, true))) {
        real = false;
        learned_.push_back(operation.decl()(given) == *result);
      }
    }
    return real;
  }

 private:
  std::unordered_set<unsigned> parts_;
  std::vector<z3::expr> learned_;
  std::vector<z3::expr> operations_;
};

class Comparison {
 public:
  Comparison(Effects& effects, const Outcome& meant, const Outcome& done) : effects_(effects) {
    add("what it returns", meant.result, done.result);
    std::set<Address> cells;
    for (const Outcome* one : {&meant, &done}) {
      for (const auto& [address, value] : one->memory.cells) {
        cells.insert(address);
      }
    }
    for (const Address cell : cells) {
      add(effects.places().at(cell).name, effects.load(meant.memory, cell),
          effects.load(done.memory, cell));
    }
    add("its commands, notes and calls of C code", meant.memory.world, done.memory.world);
    for (const auto& [address, value] : done.memory.cells) {
      addTruth(address, value);
    }
  }

  /// One difference after the other: together they are too much for the solver.
  Validated ask(const std::string& what) {
    Validated worst{what, Verdict::Same, {}};
    for (const Difference& difference : differences_) {
      Validated found = ask(what, difference);
      if (found.verdict == Verdict::Differs) {
        return found;
      }
      if (found.verdict == Verdict::Undecided) {
        worst = std::move(found);
      }
    }
    return worst;
  }

 private:
  Validated ask(const std::string& what, const Difference& difference) {
    Rounding rounding(difference.when);
    for (uint32_t round = 0; round < kMostRounds; ++round) {
      z3::solver solver = question(difference, rounding);
      switch (solver.check()) {
        case z3::unsat:
          return {what, Verdict::Same, {}};
        case z3::unknown:
          return {what, Verdict::Undecided, "the solver gives up on " + difference.what};
        case z3::sat:
          break;
      }
      const z3::model model = solver.get_model();
      if (rounding.isReal(model)) {
        return {what, Verdict::Differs, describe(difference, model)};
      }
    }
    return {what, Verdict::Undecided,
            difference.what + " differs if numbers are rounded otherwise than they are"};
  }

  z3::solver question(const Difference& difference, const Rounding& rounding) {
    z3::solver solver(effects_.z3());
    z3::params parameters(effects_.z3());
    parameters.set("rlimit", kMostWork);
    solver.set(parameters);
    for (const Numbers::Fact& fact : effects_.numbers().facts()) {
      if (rounding.has(fact.about)) {
        solver.add(fact.holds);
      }
    }
    for (const z3::expr& fact : rounding.learned()) {
      solver.add(fact);
    }
    solver.add(difference.when);
    return solver;
  }

  void add(const std::string& what, const z3::expr& meant, const z3::expr& done) {
    if (!z3::eq(meant, done)) {
      differences_.push_back({what, meant != done, meant, done});
    }
  }

  /// What later functions take for granted of truth values.
  void addTruth(Address address, const z3::expr& value) {
    if (effects_.places().at(address).kind != CellKind::Truth) {
      return;
    }
    Numbers& numbers = effects_.numbers();
    const z3::expr good =
        (value == numbers.constant(0) || value == numbers.constant(1) || value == numbers.unknown())
            .simplify();
    if (!good.is_true()) {
      differences_.push_back({effects_.places().at(address).name + ", which is not a truth value",
                              !good, value, value});
    }
  }

  std::string describe(const Difference& difference, const z3::model& model) {
    std::string words = fmt::format("{} differs", difference.what);
    const z3::expr meant = model.eval(difference.meant, true);
    const z3::expr done = model.eval(difference.done, true);
    if (meant.is_numeral() && done.is_numeral()) {
      words += fmt::format(": {} by the mission, {} by the code", inWords(meant), inWords(done));
    }
    std::vector<std::string> values;
    for (const auto& [address, value] : effects_.initial()) {
      if (values.size() < kMostValues && model.has_interp(value.decl())) {
        values.push_back(fmt::format("{} = {}", effects_.places().at(address).name,
                                     inWords(model.eval(value, true))));
      }
    }
    return values.empty() ? words : fmt::format("{}, where {}", words, fmt::join(values, ", "));
  }

  static std::string inWords(const z3::expr& value) {
    if (value.get_sort().bv_size() != 64) {
      const uint64_t whole = value.get_numeral_uint64();
      return whole == UINT32_MAX ? "none" : fmt::format("{}", whole);
    }
    const double number = doubleOf(value);
    return number == number ? fmt::format("{:.6g}", number) : "unknown";
  }

  Effects& effects_;
  std::vector<Difference> differences_;
};

}  // namespace

Validated compare(Effects& effects, const std::string& what, const Outcome& meant,
                  const Outcome& done) {
  return Comparison(effects, meant, done).ask(what);
}

}  // namespace glider::codegen::validate
