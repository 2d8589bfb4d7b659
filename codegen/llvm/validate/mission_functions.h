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
        moments_(code.moments()),
        mission_(mission),
        index_(index),
        expressions_(code.moments(), mission) {}

  /// `word` is the function's second argument: the case from which on guards are tried, the case
  /// that fired, the phase.
  Outcome guards(const std::vector<ir::Case>& cases, bool always, const z3::expr& word);
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

  void run(Moment& moment, ir::BlockId block);
  void execute(Moment& moment, const ir::Statement& statement);
  void set(Moment& moment, const ir::Statement& statement);
  void choose(Moment& moment, const ir::Statement& statement);
  void note(Moment& moment, uint32_t kind, const std::string& text,
            const std::vector<z3::expr>& values);
  void assign(Moment& moment, ir::VariableId variable, const z3::expr& value);
  void pass(Moment& moment, const ir::Case& fired);

  void watch(Moment& moment, ir::TemporalId id, When when);
  z3::expr held(Moment& moment, ir::TemporalId id, When when, const z3::expr& turned);
  void startWindow(Moment& moment, ir::TemporalId id);
  void advanceWindow(Moment& moment, ir::TemporalId id);
  z3::expr fresh(const Moment& moment, const ir::Temporal& window);
  z3::expr shape(const ir::Temporal& window);

  void behaviour(Moment& moment, const ir::Activity& activity, uint32_t block,
                 const z3::expr& phase);
  void begin(Moment& moment, const ir::Activity& activity, uint32_t block, const z3::expr& phase);
  void sample(Moment& moment, const ir::State& state);
  void add(Moment& moment, const ir::Wake& wake, z3::expr& open, const z3::expr& nap,
           WaysOut& ways);

  z3::expr context() { return moments_.address(moments_.places().object("context")); }
  z3::expr time(const Moment& moment);
  Numbers& numbers() { return moments_.numbers(); }
  Outcome only(const Moment& moment) { return {moments_.word(0), moment}; }

  Code& code_;
  Moments& moments_;
  const ir::Mission& mission_;
  const MissionIndex& index_;
  MissionExpressions expressions_;
};

}  // namespace glider::codegen::validate
