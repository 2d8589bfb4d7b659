// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/lower/mission_index.h"
#include "codegen/llvm/validate/code.h"
#include "codegen/llvm/validate/mission_expressions.h"
#include "ir/naps/wake.h"

namespace glider::codegen::validate {

/// What each function of a compiled mission (runtime/abi/glider_abi.h) must do, by ir/README.md.
class MissionFunctions {
 public:
  /// All outlive this. `code` says what functions of the runtime do that have a body.
  MissionFunctions(Code& code, const ir::Mission& mission, const MissionIndex& index)
      : code_(code),
        effects_(code.effects()),
        mission_(mission),
        index_(index),
        expressions_(code.effects(), mission) {}

  /// `word` is the function's second argument: the case from which on guards are tried, the case
  /// that fired, the phase.
  Outcome guards(const std::vector<ir::Case>& cases, ir::ListKind list, const z3::expr& word);
  Outcome act(const std::vector<ir::Case>& cases, const z3::expr& word);
  Outcome enter(ir::StateId state, const z3::expr& word);
  Outcome advance(ir::StateId state);
  Outcome fly(const ir::Activity& activity, uint32_t memory_block);
  Outcome foresee(ir::StateId state);
  Outcome begin();
  Outcome advanceAlways();
  Outcome condition();

 private:
  enum class When : uint8_t { Start, Advance };
  struct EarlyReturns;

  void run(Memory& memory, ir::BlockId block);
  void execute(Memory& memory, const ir::Statement& statement);
  void set(Memory& memory, const ir::Statement& statement);
  void choose(Memory& memory, const ir::Statement& statement);
  void note(Memory& memory, uint32_t kind, const std::string& text,
            const std::vector<z3::expr>& values);
  void assign(Memory& memory, ir::VariableId variable, const z3::expr& value);
  void pass(Memory& memory, const ir::Case& fired);

  void watch(Memory& memory, ir::TemporalId id, When when);
  z3::expr held(Memory& memory, ir::TemporalId id, When when, const z3::expr& turned);
  void startWindow(Memory& memory, ir::TemporalId id);
  void advanceWindow(Memory& memory, ir::TemporalId id);
  z3::expr fresh(const Memory& memory, const ir::Temporal& window);
  z3::expr shape(const ir::Temporal& window);

  void behaviour(Memory& memory, const ir::Activity& activity, uint32_t block,
                 const z3::expr& phase);
  void begin(Memory& memory, const ir::Activity& activity, uint32_t block, const z3::expr& phase);
  void sample(Memory& memory, const ir::State& state);
  void add(Memory& memory, const ir::Wake& wake, z3::expr& open, const z3::expr& nap,
           EarlyReturns& returns);

  z3::expr context() { return effects_.address(effects_.places().object("context")); }
  z3::expr time(const Memory& memory);
  Numbers& numbers() { return effects_.numbers(); }
  Outcome only(const Memory& memory) { return {effects_.word(0), memory}; }

  Code& code_;
  Effects& effects_;
  const ir::Mission& mission_;
  const MissionIndex& index_;
  MissionExpressions expressions_;
};

}  // namespace glider::codegen::validate
