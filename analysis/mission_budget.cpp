// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/mission_budget.h"

#include "analysis/modem_budget.h"
#include "codegen/codegen.h"
#include "compiler/boards.h"
#include "compiler/user_code.h"
#include "ir/core/window_shape.h"
#include "ir/verify/link_bytes.h"
#include "runtime/checkpoint/checkpoint.h"
#include "support/diagnostics/ids/target.h"

#include <fmt/format.h>

#include <algorithm>
#include <expected>
#include <iterator>
#include <utility>

namespace glider::analysis {
namespace {

constexpr const char* kExecutable = "executable";

using report::Budget;
using report::Quantity;
using support::Result;

std::optional<uint64_t> limitOf(uint64_t value) {
  return value == 0 ? std::nullopt : std::optional(value);
}

bool exceeds(const Quantity& quantity) {
  return quantity.value && quantity.limit && *quantity.value > *quantity.limit;
}

/// Of the serial line to the vehicle; a mission whose program has the seat within itself has none.
std::vector<Budget> linesBudget(const compiler::Optimised& mission,
                                support::DiagnosticEngine& diagnostics) {
  if (mission.platform().seatIsOnBoard()) {
    return {};
  }
  const ir::LinkBytes bytes = ir::linkBytes(mission.mission, mission.platform());
  const std::string unit = "bytes a cycle";
  const std::string fast = "115200 baud: ";
  Budget budget{
      "lines",
      {{"to_payload", bytes.to_sbc, bytes.fast_line, unit,
        fast + "readings of the subscribed sensors"},
       {"from_payload", bytes.from_sbc, bytes.fast_line, unit, fast + "the SBC's longest answer"}}};
  for (const Quantity& quantity : budget.quantities) {
    if (exceeds(quantity)) {
      diagnostics.report(support::diagnostics::lineOverloaded, {}, *quantity.value, 115200,
                         *quantity.limit);
    }
  }
  return {std::move(budget)};
}

Quantity figureOf(std::string name, const std::expected<uint64_t, std::string>& bound,
                  uint64_t limit, std::string unit, std::string remark) {
  Quantity figure{std::move(name), std::nullopt, limitOf(limit), std::move(unit),
                  std::move(remark)};
  if (bound) {
    figure.value = *bound;
  } else {
    figure.remark = bound.error();
  }
  return figure;
}

/// What --checkpoint writes to the card: at most one checkpoint per tick. A tick comes with each
/// cycle of the vehicle (or from the SBC's clock alone, after 12 s without one).
std::vector<Quantity> checkpointFigures(const codegen::Budget& measured, double cycle_s) {
  using runtime::Checkpoint;
  constexpr double kDay_s = 86400;
  const auto most = static_cast<uint64_t>(kDay_s / cycle_s);
  const uint64_t slot = Checkpoint::slotBytes(static_cast<uint32_t>(measured.context_bytes));
  return {{"checkpoint_writes", most, std::nullopt, "writes a day",
           fmt::format("with --checkpoint: one per tick, one every {:g} s while no state, "
                       "variable or command changes",
                       Checkpoint::kMostApart)},
          {"checkpoint_bytes", most * slot, std::nullopt, "bytes a day",
           fmt::format("{} bytes per write, alternating between {} places on the storage card",
                       slot, Checkpoint::kSlots)}};
}

Budget boardBudget(const codegen::Budget& measured, const platforms::Board& board, double cycle_s) {
  Budget budget{board.name, {}};
  budget.quantities = {
      {kExecutable, measured.executable_bytes, limitOf(board.max_executable_bytes), "bytes",
       "the file that goes on board"},
      {"memory", measured.memory_bytes + measured.stack_bytes.value_or(0),
       limitOf(board.max_memory_bytes), "bytes",
       measured.stack_bytes ? "code, data and stack of the running mission"
                            : "code and data of the running mission, without the stack"},
      {"data", measured.data_bytes, std::nullopt, "bytes", "part of memory: writable data"},
      figureOf("stack", measured.stack_bytes, board.max_stack_bytes, "bytes",
               "part of memory: the stack at its deepest, including the C library"),
      figureOf("tick_instructions", measured.tick_instructions, board.max_tick_instructions,
               "instructions", "longest path from a frame's readings to the command")};
  std::ranges::move(checkpointFigures(measured, cycle_s), std::back_inserter(budget.quantities));
  return budget;
}

/// As GL4013 says it.
std::string whatOf(const Quantity& quantity) {
  return quantity.unit == "bytes" ? "bytes of " + quantity.name : "instructions a tick";
}

/// How much of a tick a window takes, roughly; one over a leg has no length to shorten.
uint32_t binsOf(const ir::Temporal& temporal) {
  return ir::isWindow(temporal.kind) && temporal.leg == ir::Leg::None
             ? ir::windowShape(temporal).bins
             : 0;
}

/// "shorter or fewer windows (the longest is `mean(temp, 15 min)`, line 20), ", or "" without any.
std::string windowsAdvice(const compiler::Optimised& mission) {
  const auto& temporals = mission.mission.temporals;
  const auto longest = std::ranges::max_element(temporals, {}, binsOf);
  if (longest == temporals.end() || binsOf(*longest) == 0) {
    return std::ranges::any_of(temporals, [](const auto& t) { return ir::isWindow(t.kind); })
               ? "fewer windows, "
               : "";
  }
  const support::SourceRange& range = longest->range;
  if (!range.valid()) {
    return "shorter or fewer windows, ";
  }
  return fmt::format("shorter or fewer windows (the longest is `{}`, line {}), ",
                     mission.sources().text(range),
                     mission.sources().place(range.file, range.begin).line);
}

/// The budget of a mission that calls missing code: `why` no executable can be measured.
Budget unmeasured(const platforms::Board& board, const std::string& why) {
  return {board.name,
          {{kExecutable, std::nullopt, limitOf(board.max_executable_bytes), "bytes",
            why + "; link it with --link FILE"}}};
}

Result<Budget> budgetOn(const std::string& target, const compiler::Optimised& mission,
                        const std::vector<std::string>& user_code,
                        support::DiagnosticEngine& diagnostics) {
  const auto board = compiler::loadTarget(target);
  if (!board) {
    return std::unexpected(board.error());
  }
  codegen::CodegenOptions options;
  options.sources = &mission.sources();
  const auto code = compiler::loadUserCode(user_code, mission.mission, *board);
  if (!code) {
    return std::unexpected(code.error());
  }
  code->addTo(options);
  const auto measured = codegen::measureBudget(mission.input(), *board, options);
  if (!measured && measured.error().id == support::diagnostics::unboundSymbol) {
    return unmeasured(*board, measured.error().message);
  }
  if (!measured) {
    return std::unexpected(measured.error());
  }
  Budget budget = boardBudget(*measured, *board, mission.platform().envelope.cycle_s);
  for (const Quantity& quantity : budget.quantities) {
    if (exceeds(quantity)) {
      diagnostics.report(support::diagnostics::boardOverloaded, {}, *quantity.value,
                         whatOf(quantity), target, *quantity.limit, windowsAdvice(mission));
    }
  }
  return budget;
}

}  // namespace

Result<std::vector<Budget>> missionBudgets(const compiler::Optimised& mission,
                                           const std::vector<std::string>& targets,
                                           const std::vector<std::string>& user_code,
                                           support::DiagnosticEngine& diagnostics) {
  std::vector<Budget> budgets = linesBudget(mission, diagnostics);
  std::ranges::move(modemBudget(mission), std::back_inserter(budgets));
  for (const std::string& target : targets) {
    auto budget = budgetOn(target, mission, user_code, diagnostics);
    if (!budget) {
      return std::unexpected(budget.error());
    }
    budgets.push_back(std::move(*budget));
  }
  return budgets;
}

std::function<Result<void>(const codegen::Budget&)> onlyWhatFits(
    const platforms::Board& board, const compiler::Optimised& mission) {
  return [board, cycle_s = mission.platform().envelope.cycle_s,
          windows = windowsAdvice(mission)](const codegen::Budget& measured) -> Result<void> {
    for (const Quantity& quantity : boardBudget(measured, board, cycle_s).quantities) {
      // The size of the file is not a bound: one that is too large is refused where it is written.
      if (quantity.name != kExecutable && exceeds(quantity)) {
        return support::fail(support::diagnostics::boardOverloaded, *quantity.value,
                             whatOf(quantity), board.name, *quantity.limit, windows);
      }
    }
    return {};
  };
}

std::vector<std::string> boardsInTheVehicle() {
  std::vector<std::string> names = compiler::targetNames();
  std::erase(names, "host");
  return names;
}

}  // namespace glider::analysis
