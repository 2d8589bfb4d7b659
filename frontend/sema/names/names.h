// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/paths.h"
#include "frontend/sema/names/snippet.h"
#include "frontend/sema/names/types.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glider::frontend {

/// The kinds of names with a value other than constants, sensors and clocks.
enum class NamedKind : uint8_t {
  Parameter,  ///< of the mission, set at its launch
  MissionVariable,
  StateParameter,
  StateVariable,
  BehaviourParameter,
  BehaviourVariable
};

/// "a variable", "a parameter of the mission".
std::string_view describe(NamedKind kind);
/// Whether `set` may change it.
bool isVariable(NamedKind kind);

/// What a plain number counts, as far as its text shows it: `uM`, `ug/L`; "1" for a reading
/// without a unit; empty if that is not known.
struct Scale {
  std::string_view unit;
  bool written = false;  ///< a number with this unit is part of it
};

/// An element of an array.
struct Element {
  ir::VariableId variable;
  ir::VariableId longitude;  ///< of a position
};

/// A name of one of these kinds. A position is two IR variables, an array those of its elements.
struct Named {
  const ast::Name* name = nullptr;
  NamedKind kind = NamedKind::MissionVariable;
  DeclaredType type;
  bool reached = false;  ///< its declaration was lowered
  bool valid = true;     ///< false: its declaration was refused, which has been reported
  ir::VariableId variable;
  ir::VariableId longitude;
  std::vector<Element> elements;  ///< of an array whose declaration was lowered
  bool array = false;             ///< it is declared with a size
  /// For a behaviour's parameter where the behaviour is used: the argument, one expression or, for
  /// a position, two.
  std::vector<Snippet> arguments;
  PathArgument path;  ///< the same for a path; where the behaviour is checked on its own, any path
  Scale scale;        ///< of the value that it is declared with, if that has a unit
  bool starts_constant = false;
  bool read = false;  ///< by something else than a `set` of itself
  bool written = false;
};

struct LoopPass;

/// By name, as written.
using Names = std::map<std::string, Named, std::less<>>;

/// The parameters of a state, behaviour or command.
struct Signature {
  struct Formal {
    const ast::Name* name = nullptr;
    DeclaredType type;
    const ast::Expr* usual = nullptr;   ///< the argument if none is given; null: one must be
    const ast::Range* range = nullptr;  ///< in which arguments lie; null: anywhere
    // Its ends, SI units (declarations/formal_ranges.h).
    double lowest = -ir::Variable::kEndless;
    double highest = ir::Variable::kEndless;
  };
  std::vector<Formal> formals;
  std::vector<ir::Parameter> slots;  ///< as in the IR: a position is two
  std::string text;                  ///< "leg(to: position, speed: speed)"
  bool valid = true;                 ///< false: refused, which has been reported
};

/// The context of an expression or statement: what its names mean, and what it may use.
struct Context {
  Names* names = nullptr;      ///< of the state or behaviour
  bool isolated = false;       ///< in a behaviour, which cannot use any name of the mission
  std::string_view behaviour;  ///< its name
  /// The list that contains `became` and `held`; none where they cannot be watched.
  std::optional<ir::ListKind> list;
  ir::StateId state;
  /// Not empty if the value must be known before the mission runs: the reason, "a constant".
  std::string_view constant;
  bool requirement = false;  ///< in a requirement, or in a place that it names
  /// Whether the value must be known when the mission starts: constants and parameters only.
  bool at_start = false;
  /// The state whose activities `profiledone` and `routedone` read; null where there is none.
  const ir::State* activities = nullptr;
  /// In the body of a behaviour: the use that it is lowered for. Warnings were given at its
  /// definition.
  std::optional<support::SourceRange> use;
  const LoopPass* pass = nullptr;  ///< of the innermost loop around it

  /// Whether it is in a behaviour that is checked on its own, whose parameters have no values.
  [[nodiscard]] bool checkedAlone() const { return isolated && !state.valid(); }
};

}  // namespace glider::frontend
