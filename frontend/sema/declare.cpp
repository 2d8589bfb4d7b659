// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations.h"
#include "frontend/sema/evaluate.h"
#include "frontend/sema/lower_expr.h"
#include "frontend/sema/variables.h"

#include <cmath>
#include <map>
#include <type_traits>

namespace glider::frontend {

using support::DiagnosticId;

namespace {

class Declarations {
 public:
  explicit Declarations(Scope& scope) : scope_(scope) {}

  /// Enters the names of constants, so that one used too early is known as such.
  void enterConstant(const ast::Const& node) {
    if (scope_.refuseName(node.name, "a constant") || scope_.refuseSecond(node.name)) {
      return;
    }
    Constant constant;
    constant.name = &node.name;
    scope_.constants.emplace(node.name.text, constant);
  }

  void visit(const ast::Const& node) {
    const auto place = scope_.constants.find(node.name.text);
    if (place == scope_.constants.end() || place->second.name != &node.name) {
      return;  // refused
    }
    if (isPath(node.value, scope_) || (node.type && node.type->text == "path")) {
      workPath(node, place->second);
    } else {
      const auto type = node.type ? scope_.declaredType(*node.type) : std::nullopt;
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
  void visit(const ast::ExternSensor& node) {
    scope_.notYet(node.where, "`extern sensor`");
    scope_.later_values.emplace(node.name.text, &node.name);
  }
  void visit(const ast::ExternFunction& node) {
    scope_.notYet(node.where, "`extern function`");
    scope_.later_functions.emplace(node.name.text, &node.name);
  }
  void visit(const ast::Always&) {}
  void visit(const ast::Import&) {}
  void visit(const ast::Requirement&) {}

  void visit(const ast::Behaviour& node) {
    BehaviourDeclaration declaration;
    declaration.body = &node;
    declaration.signature = scope_.signatureOf(node.name, node.formals);
    enter(node.name, node.kind, std::move(declaration));
  }

  void visit(const ast::ExternBehaviour& node) {
    BehaviourDeclaration declaration;
    declaration.signature = scope_.signatureOf(node.name, node.formals);
    declaration.usable = declaration.signature.valid;
    checkParameters(declaration.signature);
    for (const ast::Name& sensor : node.reads) {
      const platforms::PlatformSensor* found = scope_.platform().find(sensor.text);
      if (found == nullptr) {
        scope_.report(DiagnosticId::unknownSensor, sensor.where, scope_.platform().name,
                      sensor.text, scope_.suggestSensor(sensor.text));
        declaration.usable = false;
      } else {
        declaration.reads.push_back(found);
      }
    }
    enter(node.name, node.kind, std::move(declaration));
  }

  void visit(const ast::State&) {}
  void visit(const ast::MissionLine&) {}
  void visit(const ast::PlatformLine&) {}

 private:
  /// Lowers the definition to IR, works its value out and takes the IR back.
  void work(const ast::Const& node, const std::optional<DeclaredType>& type, Constant& constant) {
    Context context;
    context.constant = "a constant";
    const Scope::Within within(scope_, context);
    const size_t before = scope_.mission.exprs.size();
    ExprLowering lowering(scope_);
    const auto value = type ? lowering.lowerDeclared(node.value, *type, "`" + node.name.text + "`")
                            : lowering.lower(node.value, std::nullopt);
    if (value) {
      settleConstant(node, *value, constant);
    }
    scope_.mission.exprs.resize(before);
  }

  void workPath(const ast::Const& node, Constant& constant) {
    if (node.type && node.type->text != "path") {
      if (const auto type = scope_.declaredType(*node.type)) {
        scope_.report(DiagnosticId::wrongType, node.value.where, "`" + node.name.text + "`",
                      describe(*type), scope_.text(node.value.where), "a path");
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
      scope_.report(DiagnosticId::notConstant, node.value.where, scope_.text(node.value.where),
                    "a constant");
      return;
    }
    if (std::isnan(*number)) {
      scope_.report(DiagnosticId::constantUnknown, node.value.where, scope_.text(node.value.where));
      return;
    }
    constant.type = value.type;
    constant.number = *number;
    constant.position = value.longitude.valid();
    constant.second = constant.position ? *evaluate(scope_.mission, value.longitude) : 0;
    constant.valid = true;
  }

  void checkParameters(const Signature& signature) {
    std::map<std::string_view, const ast::Name*> names;
    for (const Signature::Formal& formal : signature.formals) {
      if (isUnitName(formal.name->text)) {
        scope_.report(DiagnosticId::unitAsName, formal.name->where, formal.name->text,
                      "a parameter");
      }
      const auto [place, fresh] = names.emplace(formal.name->text, formal.name);
      if (!fresh) {
        scope_.report(DiagnosticId::duplicateName, formal.name->where, formal.name->text)
            .note(place->second->where, "the first is here");
      }
    }
  }

  void enter(const ast::Name& name, ast::BehaviourKind kind, BehaviourDeclaration declaration) {
    declaration.name = &name;
    declaration.kind =
        kind == ast::BehaviourKind::Profile ? ir::BehaviourKind::Profile : ir::BehaviourKind::Route;
    const auto [place, fresh] = scope_.behaviours.emplace(name.text, std::move(declaration));
    if (!fresh) {
      scope_.report(DiagnosticId::duplicateName, name.where, name.text)
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
      declarations.enterConstant(*constant);
    } else if (const auto* parameter = std::get_if<ast::Param>(item)) {
      declarations.enterParameter(*parameter);
    } else if (const auto* variable = std::get_if<ast::Var>(item)) {
      declarations.enterVariable(*variable);
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
}

}  // namespace glider::frontend
