// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/validate/contracts.h"

#include "support/one_of.h"

#include <algorithm>

namespace glider::codegen::validate {
namespace {

bool isCommand(std::string_view symbol) {
#define COMMAND(name, text, function, ...) \
  if (symbol == function) {                \
    return true;                           \
  }
#include "ir/core/commands.def"
#undef COMMAND
  return symbol == "gliderSample" || symbol.starts_with("gliderNap");
}

bool isPure(std::string_view symbol) {
#define FUNCTION(name, text, operands, takes, gives, known, whole, function) \
  if (symbol == #function) {                                                 \
    return true;                                                             \
  }
#include "ir/core/ops.def"
  return false;
}

}  // namespace

Contract contractOf(const ir::Mission& mission, std::string_view symbol) {
  if (symbol == "gliderNote") {
    return Contract::Note;
  }
  if (symbol == "gliderFirstTrue") {
    return Contract::Table;
  }
  if (support::isOneOf(
          symbol, {"gliderWindowStart", "gliderWindowAdvance", "gliderLegStart", "gliderLegAdvance",
                   "gliderSteepestStart", "gliderSteepestAdvance"})) {
    return Contract::Window;
  }
  if (std::ranges::find(mission.functions, symbol, &ir::Function::symbol) !=
      mission.functions.end()) {
    return Contract::Foreign;
  }
  const bool behaviour = std::ranges::find(mission.behaviours, symbol, &ir::Behaviour::symbol) !=
                         mission.behaviours.end();
  return isPure(symbol)                   ? Contract::Pure
         : behaviour || isCommand(symbol) ? Contract::Command
                                          : Contract::None;
}

}  // namespace glider::codegen::validate
