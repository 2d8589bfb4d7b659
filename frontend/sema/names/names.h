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

/// What holds a value beside constants, sensors and clocks.
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

/// A name of that kind. A position is two IR variables.
struct Named {
  const ast::Name* name = nullptr;
  NamedKind kind = NamedKind::MissionVariable;
  DeclaredType type;
  bool reached = false;  ///< its declaration was lowered
  bool valid = true;     ///< false: its declaration was refused, and said to be so
  ir::VariableId variable;
  ir::VariableId longitude;
  /// Of a behaviour's parameter where the behaviour is used: what stands for it, one or, for a
  /// position, two.
  std::vector<Snippet> arguments;
  PathArgument path;  ///< the same, of one that is a path; where it is checked alone, any path
  bool starts_constant = false;
  bool read = false;  ///< by something else than a `set` of itself
  bool written = false;
};

/// By what is written.
using Names = std::map<std::string, Named, std::less<>>;

/// What can be given when a state, behaviour or command is named.
struct Signature {
  struct Formal {
    const ast::Name* name = nullptr;
    DeclaredType type;
  };
  std::vector<Formal> formals;
  std::vector<ir::Parameter> slots;  ///< as the IR sees them: a position is two
  std::string text;                  ///< "leg(to: position, speed: speed)"
  bool valid = true;                 ///< false: refused, and said to be so
};

/// Where an expression or statement stands: what its names mean, and what it may use.
struct Context {
  Names* names = nullptr;      ///< of the state or behaviour
  bool isolated = false;       ///< in a behaviour, which sees no name of the mission
  std::string_view behaviour;  ///< its name
  /// The list that `became` and `held` stand in; none where they cannot be watched.
  std::optional<ir::ListKind> list;
  ir::StateId state;
  /// Not empty: the value must be known before the mission runs, and this says why: "a constant".
  std::string_view constant;
  /// The value must be known when the mission starts: constants and parameters only.
  bool at_start = false;
  /// What `profiledone` and `routedone` read; null where no state's activities are meant.
  const ir::State* activities = nullptr;
  /// In the body of a behaviour, lowered for this use of it: warnings were given at its definition.
  std::optional<support::SourceRange> use;

  /// In a behaviour that is checked by itself, whose parameters have no values.
  [[nodiscard]] bool checkedAlone() const { return isolated && !state.valid(); }
};

}  // namespace glider::frontend
