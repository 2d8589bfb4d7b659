// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/validate/validate.h"

#include "codegen/llvm/validate/comparison.h"
#include "codegen/llvm/validate/mission_functions.h"
#include "codegen/llvm/validate/tables.h"
#include "codegen/llvm/validate/undecided.h"
#include "support/diagnostics/ids/command.h"
#include "support/files.h"

#include <fmt/format.h>
#include <llvm/ADT/STLFunctionalExtras.h>
#include <llvm/Bitcode/BitcodeReader.h>
#include <llvm/Support/Error.h>
#include <llvm/Support/MemoryBuffer.h>

#include <memory>
#include <utility>

namespace glider::codegen {
namespace {

using validate::fieldOf;
using validate::Outcome;

/// What a function must do, given its second argument.
using Meant = llvm::function_ref<Outcome(validate::MissionFunctions&, const z3::expr&)>;

/// What a function returns.
enum class Returns : uint8_t { Nothing, Case };

/// Compares the functions of one part, each with terms of its own: those of a large mission would
/// not fit into memory together.
class Part {
 public:
  Part(const Input& input, const llvm::Module& module, const llvm::Module& inlinable)
      : mission_(input.mission),
        module_(module),
        inlinable_(inlinable),
        index_(indexMission(input.mission)),
        types_(makeAbiTypes(module.getContext())) {}

  void function(const std::string& what, const llvm::Constant* code, Returns returns, Meant meant) {
    const auto* function = llvm::dyn_cast_or_null<llvm::Function>(code);
    try {
      if (function != nullptr && function->isDeclaration()) {
        throw validate::Undecided("it is not there");
      }
      found.push_back(compared(what, function, returns, meant));
    } catch (const validate::Undecided& met) {
      found.push_back({what, Verdict::Undecided, met.what()});
    } catch (const z3::exception& trouble) {
      found.push_back({what, Verdict::Undecided, trouble.msg()});
    }
  }

  void profile(uint32_t state, const llvm::Constant* code);
  void state(uint32_t number);
  void head(uint32_t stack_depth);

  Validation found;

 private:
  Validated compared(const std::string& what, const llvm::Function* function, Returns returns,
                     Meant meant) {
    z3::context z3;
    validate::Numbers numbers(z3);
    validate::Places places(mission_, index_, types_, module_.getDataLayout());
    validate::Effects effects(numbers, places);
    validate::Code code(effects, inlinable_);
    validate::MissionFunctions meaning(code, mission_, index_);
    const z3::expr word = z3.bv_const("word", 32);
    const Outcome says = meant(meaning, word);
    return validate::compare(effects, what, says, done(code, function, returns, word));
  }

  /// What the code does. One that is missing does nothing and answers that no case fires.
  static Outcome done(validate::Code& code, const llvm::Function* function, Returns returns,
                      const z3::expr& word) {
    validate::Effects& effects = code.effects();
    if (function == nullptr) {
      return {effects.word(returns == Returns::Case ? GLIDER_NO_CASE : 0), effects.first()};
    }
    std::vector<z3::expr> arguments{effects.address(effects.places().object("context"))};
    if (function->arg_size() > 1) {
      arguments.push_back(function->getArg(1)->getType()->isPointerTy()
                              ? effects.address(effects.places().object("nap"))
                              : word);
    }
    return code.run(*function, arguments, effects.first());
  }

  const ir::Mission& mission_;
  const llvm::Module& module_;
  const llvm::Module& inlinable_;
  MissionIndex index_;
  AbiTypes types_;
};

void Part::profile(uint32_t number, const llvm::Constant* code) {
  const ir::State& state = mission_.states[number];
  const std::string what = "the profile of `" + state.name + "`";
  const auto* function = llvm::dyn_cast_or_null<llvm::Function>(code);
  if (function != nullptr && function->isDeclaration() &&
      function->getName() == "profile." + state.name) {
    return;  // it is in another part
  }
  this->function(what, code, Returns::Case, [&](auto& meaning, const z3::expr&) {
    return meaning.fly(state.profile, index_.memory_blocks[number].profile);
  });
}

void Part::state(uint32_t number) {
  namespace field = field::GliderStateInfo;
  const ir::State& state = mission_.states[number];
  const ir::StateId id{number};
  const std::string name = "`" + state.name + "`";
  const llvm::GlobalVariable* described = module_.getNamedGlobal("state." + std::to_string(number));
  if (described == nullptr || !described->hasInitializer()) {
    found.push_back({"the table of " + name, Verdict::Differs, "it is missing"});
    return;
  }
  const llvm::Constant& table = *described->getInitializer();
  found.push_back(validate::compareState(mission_, id, table));
  function("the cases of " + name, fieldOf(table, field::guards), Returns::Case,
           [&](auto& meaning, const z3::expr& word) {
             return meaning.guards(state.cases, ir::ListKind::State, word);
           });
  function("the actions of " + name, fieldOf(table, field::act), Returns::Nothing,
           [&](auto& meaning, const z3::expr& word) { return meaning.act(state.cases, word); });
  function("the entry of " + name, fieldOf(table, field::enter), Returns::Nothing,
           [&](auto& meaning, const z3::expr& word) { return meaning.enter(id, word); });
  function("the watches of " + name, fieldOf(table, field::advance), Returns::Nothing,
           [&](auto& meaning, const z3::expr&) { return meaning.advance(id); });
  function("the route of " + name, fieldOf(table, field::route), Returns::Case,
           [&](auto& meaning, const z3::expr&) {
             return meaning.fly(state.route, index_.memory_blocks[number].route);
           });
  function("the naps of " + name, fieldOf(table, field::foresee), Returns::Nothing,
           [&](auto& meaning, const z3::expr&) { return meaning.foresee(id); });
  profile(number, fieldOf(table, field::profile));
}

void Part::head(uint32_t stack_depth) {
  namespace field = field::GliderMission;
  const llvm::GlobalVariable* described = module_.getNamedGlobal("gliderMission");
  if (described == nullptr || !described->hasInitializer()) {
    found.push_back({"the tables of the mission", Verdict::Differs, "they are missing"});
    return;
  }
  const llvm::Constant& table = *described->getInitializer();
  found.push_back(validate::compareMission(mission_, stack_depth, table));
  function("the start of the mission", fieldOf(table, field::begin), Returns::Nothing,
           [](auto& meaning, const z3::expr&) { return meaning.begin(); });
  function("the watches of `always`", fieldOf(table, field::advance), Returns::Nothing,
           [](auto& meaning, const z3::expr&) { return meaning.advanceAlways(); });
  function("the cases of `always`", fieldOf(table, field::guards), Returns::Case,
           [&](auto& meaning, const z3::expr& word) {
             return meaning.guards(mission_.always, ir::ListKind::Always, word);
           });
  function("the actions of `always`", fieldOf(table, field::act), Returns::Nothing,
           [&](auto& meaning, const z3::expr& word) { return meaning.act(mission_.always, word); });
  function("the conditions of the parameters", fieldOf(table, field::condition), Returns::Case,
           [](auto& meaning, const z3::expr&) { return meaning.condition(); });
}

}  // namespace

support::Result<Validation> validatePart(const Input& input, const MissionPart& part,
                                         const llvm::Module& module,
                                         const std::filesystem::path& inlinable) {
  auto bitcode = support::readFile(inlinable.string());
  if (!bitcode) {
    return std::unexpected(bitcode.error());
  }
  auto runtime = llvm::parseBitcodeFile(llvm::MemoryBufferRef(*bitcode, inlinable.string()),
                                        module.getContext());
  if (!runtime) {
    return support::fail(support::diagnostics::badRuntime, inlinable.string(),
                         llvm::toString(runtime.takeError()));
  }
  Part compared(input, module, **runtime);
  if (part.head) {
    compared.head(input.stack_depth);
  }
  for (const uint32_t state : part.states) {
    compared.state(state);
  }
  const std::set<uint32_t> states(part.states.begin(), part.states.end());
  for (const uint32_t state : part.profiles) {
    if (!states.contains(state)) {
      compared.profile(state, module.getFunction("profile." + input.mission.states[state].name));
    }
  }
  return std::move(compared.found);
}

}  // namespace glider::codegen
