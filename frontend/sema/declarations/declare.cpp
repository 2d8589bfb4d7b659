// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/arrays/declared_array.h"
#include "frontend/sema/declarations/declarations.h"
#include "frontend/sema/declarations/externals.h"
#include "frontend/sema/declarations/formal_ranges.h"
#include "frontend/sema/declarations/variables.h"
#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace glider::frontend {

namespace {

class Declarations {
 public:
  explicit Declarations(Scope& scope) : scope_(scope) {}

  /// Enters the names of constants, so that one used too early is recognised.
  void enterConstant(const ast::Const& node, bool choice) {
    if (scope_.refuseName(node.name, "a constant") || scope_.refuseSecond(node.name)) {
      return;
    }
    Constant constant;
    constant.name = &node.name;
    constant.untyped = node.type ? nullptr : &node.value;
    constant.choice = choice;
    scope_.constants.emplace(node.name.text, constant);
  }

  void visit(const ast::Const& node) {
    const auto place = scope_.constants.find(node.name.text);
    if (place == scope_.constants.end() || place->second.name != &node.name) {
      return;  // refused
    }
    const bool path = node.type && node.type->text == "path";
    if (path || isPath(node.value, scope_)) {
      workPath(node, place->second);
    } else if (const auto* list = std::get_if<ast::List>(&node.value.node)) {
      workArray(node, *list, place->second);
    } else {
      const auto type = node.type ? scope_.declaredType(*node.type, "") : std::nullopt;
      if (!node.type || type) {
        work(node, type, place->second);
      }
    }
    place->second.worked_out = true;
  }

  void enterParameter(const ast::Param& node) {
    enterName(node.name, NamedKind::Parameter, scope_.names, scope_);
  }
  void enterVariable(const ast::Var& node) {
    enterName(node.name, NamedKind::MissionVariable, scope_.names, scope_);
  }

  void visit(const ast::Param&) {}
  void visit(const ast::Var&) {}
  void visit(const ast::ExternSensor& node) { declareExternal(node, scope_); }
  void visit(const ast::ExternFunction& node) { declareExternal(node, scope_); }
  void visit(const ast::Always&) {}
  void visit(const ast::Import&) {}
  void visit(const ast::PlaceDeclaration&) {}
  void visit(const ast::Requirement&) {}
  void visit(const ast::Assumption&) {}
  void visit(const ast::Resumption&) {}
  void visit(const ast::Nap&) {}
  void visit(const ast::Declination&) {}
  void visit(const ast::Share&) {}
  void visit(const ast::Vehicles&) {}
  void visit(const ast::Pack&) {}
  void visit(const ast::Choice& node) {
    visit(node.constant);
    const auto made = scope_.constants.find(node.constant.name.text);
    if (made != scope_.constants.end() && made->second.name == &node.constant.name) {
      made->second.open = true;
    }
  }
  void visit(const ast::Preference&) {}

  void visit(const ast::Behaviour& node) {
    BehaviourDeclaration declaration;
    declaration.body = &node;
    declaration.signature = scope_.signatureOf(node.name, listOf(node.formals), "");
    settleRanges(declaration.signature, scope_);
    enter(node.name, node.kind, std::move(declaration));
  }

  void visit(const ast::ExternBehaviour& node) {
    enter(node.name, node.kind, externalBehaviour(node, scope_));
  }

  void visit(const ast::State&) {}
  void visit(const ast::MissionLine&) {}
  void visit(const ast::PlatformLine&) {}

 private:
  /// Lowers the definition to IR, evaluates it, and removes the IR again.
  void work(const ast::Const& node, const std::optional<DeclaredType>& type, Constant& constant) {
    Context context;
    context.constant = "a constant";
    const Scope::Within within(scope_, context);
    const size_t before = scope_.mission.exprs.size(), open = scope_.open_reads;
    ExprLowering lowering(scope_);
    const auto value = type ? lowering.lowerDeclared(node.value, *type, "`" + node.name.text + "`")
                            : lowering.lower(node.value, std::nullopt);
    if (value) {
      settleConstant(node, *value, constant);
    }
    constant.open = scope_.open_reads != open;
    scope_.mission.exprs.resize(before);
  }

  /// A list of values of one type: that of the declaration, or of the first value with a unit.
  void workArray(const ast::Const& node, const ast::List& list, Constant& constant) {
    if (!arrayFits(node, list)) {
      return;
    }
    auto type = node.type ? scope_.declaredType(*node.type, "") : std::nullopt;
    if (node.type && !type) {
      return;
    }
    const auto leader = std::ranges::find_if_not(list.items, takesUnitOfContext);
    if (!type && leader != list.items.end()) {
      Constant first;
      work({node.name, {}, *leader, node.where}, std::nullopt, first);
      if (!first.valid) {
        return;
      }
      type = DeclaredType{first.type, first.position};
    }
    std::vector<double> elements;
    for (const ast::Expr& item : list.items) {
      Constant element;
      work({node.name, {}, item, node.where}, type.value_or(DeclaredType{plainNumber()}), element);
      if (!element.valid || !sameScale(constant, element, list.items.front(), item)) {
        return;
      }
      elements.push_back(element.number);
    }
    constant.type = type ? type->type : plainNumber();
    constant.elements = std::move(elements);
    constant.valid = true;
  }

  bool arrayFits(const ast::Const& node, const ast::List& list) {
    const size_t size = list.items.size();
    if (size < kFewestElements || size > kMostElements) {
      scope_.report(support::diagnostics::arraySize, node.value.where, kMostElements,
                    size == 1 ? "1 value" : fmt::format("{} values", size));
      return false;
    }
    return true;
  }

  /// Takes the scale of the first element that has one.
  bool sameScale(Constant& constant, const Constant& element, const ast::Expr& first,
                 const ast::Expr& item) {
    const Value one{{}, element.type, {}, element.scale};
    if (ExprLowering(scope_).scalesDiffer({{}, element.type, {}, constant.scale}, first.where, one,
                                          item.where, "[…]")) {
      return false;
    }
    constant.scale = constant.scale.unit.empty() ? element.scale : constant.scale;
    return true;
  }

  void workPath(const ast::Const& node, Constant& constant) {
    if (node.type && node.type->text != "path") {
      if (const auto type = scope_.declaredType(*node.type, "")) {
        scope_.report(support::diagnostics::wrongType, node.value.where, "`" + node.name.text + "`",
                      describe(*type), scope_.text(node.value.where), "a path", howToWrite(*type));
      }
      return;
    }
    ExprLowering lowering(scope_);
    if (auto path = lowering.lowerPath(node.value)) {
      constant.path = std::move(*path);
      constant.valid = true;
    }
  }

  void settleConstant(const ast::Const& node, const Value& value, Constant& constant) {
    const auto number = evaluate(scope_.mission, value.id);
    if (!number) {
      scope_.report(support::diagnostics::notConstant, node.value.where,
                    scope_.text(node.value.where), "a constant");
      return;
    }
    if (std::isnan(*number)) {
      scope_.report(support::diagnostics::constantUnknown, node.value.where,
                    scope_.text(node.value.where));
      return;
    }
    constant.type = value.type;
    constant.number = *number;
    constant.scale = value.scale;
    constant.position = value.longitude.valid();
    constant.second = constant.position ? *evaluate(scope_.mission, value.longitude) : 0;
    constant.valid = true;
  }

  void enter(const ast::Name& name, ast::BehaviourKind kind, BehaviourDeclaration declaration) {
    declaration.name = &name;
    declaration.kind =
        kind == ast::BehaviourKind::Profile ? ir::BehaviourKind::Profile : ir::BehaviourKind::Route;
    const auto known = scope_.behaviours.find(name.text);
    if (known != scope_.behaviours.end() && scope_.inStandardLibrary(known->second.name->where) &&
        !scope_.inStandardLibrary(name.where)) {
      scope_.replaced_behaviours.insert(scope_.behaviours.extract(known));
    }
    const auto [place, fresh] = scope_.behaviours.emplace(name.text, std::move(declaration));
    if (!fresh) {
      scope_.report(support::diagnostics::duplicateName, name.where, name.text)
          .note(place->second.name->where, "the first is here");
    }
  }

  Scope& scope_;
};

}  // namespace

void declare(const ast::File& file, bool library, Scope& scope) {
  Declarations declarations(scope);
  std::vector<const ast::Item*> items;
  for (const ast::Item& item : file.items) {
    if (!library || mayBeImported(item)) {
      items.push_back(&item);
    }
  }
  for (const ast::Item* item : items) {
    if (const auto* constant = std::get_if<ast::Const>(item)) {
      declarations.enterConstant(*constant, false);
    } else if (const auto* choice = std::get_if<ast::Choice>(item)) {
      declarations.enterConstant(choice->constant, true);
    } else if (const auto* parameter = std::get_if<ast::Param>(item)) {
      declarations.enterParameter(*parameter);
    } else if (const auto* variable = std::get_if<ast::Var>(item)) {
      declarations.enterVariable(*variable);
    } else if (const auto* share = std::get_if<ast::Share>(item); share && share->variable) {
      declarations.enterVariable(*share->variable);
    } else if (const auto* function = std::get_if<ast::ExternFunction>(item)) {
      enterExternal(*function, scope);
    } else if (const auto* sensor = std::get_if<ast::ExternSensor>(item)) {
      enterExternal(*sensor, scope);
    }
  }
  for (const ast::Item* item : items) {
    std::visit([&](const auto& node) { declarations.visit(node); }, *item);
  }
}

void declareValues(const ast::File& mission, Scope& scope) {
  const auto each = [&]<typename T>(std::type_identity<T>, auto lower) {
    for (const ast::Item& item : mission.items) {
      if (const auto* node = std::get_if<T>(&item)) {
        lower(*node);
      }
    }
  };
  each(std::type_identity<ast::Param>(),
       [&](const ast::Param& node) { lowerMissionParameter(node, scope); });
  Context context;
  context.at_start = true;
  const Scope::Within within(scope, context);
  each(std::type_identity<ast::Param>(),
       [&](const ast::Param& node) { lowerMissionCondition(node, scope); });
  each(std::type_identity<ast::Var>(), [&](const ast::Var& node) {
    lowerVariable(node, {ir::VariableKind::Mission, {}, ""}, scope.names, scope);
  });
  each(std::type_identity<ast::Share>(), [&](const ast::Share& node) {
    if (node.variable) {
      lowerVariable(*node.variable, {ir::VariableKind::Mission, {}, ""}, scope.names, scope);
    }
  });
}

}  // namespace glider::frontend
