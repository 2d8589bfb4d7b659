// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations.h"
#include "frontend/sema/evaluate.h"
#include "frontend/sema/lower_expr.h"
#include "frontend/spelling.h"

#include <fmt/format.h>

#include <cmath>

namespace glider::frontend {

using support::DiagnosticId;

namespace {

class Declarations {
 public:
  explicit Declarations(Scope& scope) : scope_(scope) {}

  /// Enters the names of constants, so that one used too early is known as such.
  void enterConstant(const ast::Const& node) {
    if (scope_.refuseName(node.name, "a constant")) {
      return;
    }
    Constant constant;
    constant.name = &node.name;
    const auto [place, fresh] = scope_.constants.emplace(node.name.text, constant);
    if (!fresh) {
      scope_.report(DiagnosticId::duplicateName, node.name.where, node.name.text)
          .note(place->second.name->where, "the first is here");
    }
  }

  void visit(const ast::Const& node) {
    const auto place = scope_.constants.find(node.name.text);
    if (place == scope_.constants.end() || place->second.name != &node.name) {
      return;  // refused
    }
    const auto type = node.type ? findTypeOf(*node.type) : std::optional<ir::Type>();
    if (!node.type || type) {
      work(node, type, place->second);
    }
    place->second.worked_out = true;
  }

  void visit(const ast::Param& node) {
    laterValue(node.name, node.where, "`param`", "use `const` for now");
  }
  void visit(const ast::Var& node) {
    laterValue(node.name, node.where, "`var`", "use `const` for now");
  }
  void visit(const ast::ExternSensor& node) {
    laterValue(node.name, node.where, "`extern sensor`", "");
  }
  void visit(const ast::ExternFunction& node) {
    scope_.notYet(node.where, "`extern function`");
    scope_.later_functions.emplace(node.name.text, &node.name);
  }
  void visit(const ast::Always& node) { scope_.notYet(node.where, "`always`"); }
  void visit(const ast::Import&) {}
  void visit(const ast::Requirement& node) { scope_.notYet(node.where, "`require`"); }

  void visit(const ast::Behaviour& node) {
    const bool profile = node.kind == ast::BehaviourKind::Profile;
    scope_.notYet(node.name.where,
                  profile ? "a flightprofile written in the language"
                          : "a flightroute written in the language",
                  "write it in C and declare it with `extern` for now");
    BehaviourDeclaration declaration;
    declaration.usable = false;
    enter(node.name, node.kind, std::move(declaration));
  }

  void visit(const ast::ExternBehaviour& node) {
    BehaviourDeclaration declaration;
    declaration.signature = node.name.text + signatureOf(node);
    if (node.formals) {
      for (const ast::Formal& formal : *node.formals) {
        addParameter(formal, declaration);
      }
    }
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
  void laterValue(const ast::Name& name, const support::SourceRange& where, std::string_view what,
                  std::string_view hint) {
    scope_.notYet(where, what, hint);
    scope_.later_values.emplace(name.text, &name);
  }

  std::optional<ir::Type> findTypeOf(const ast::TypeName& name) {
    const TypeLookup found = findType(name.text);
    if (found.status == NamedType::Known) {
      return found.type;
    }
    if (found.status == NamedType::Later) {
      scope_.notYet(name.where, "type `" + name.text + "` here");
      return std::nullopt;
    }
    static const std::vector<std::string_view> kTypes = {
        "bool", "latitude", "longitude", "position", "path",
#define DIMENSION(name, m, kg, s, a, k, rad, unit) #name,
#include "support/units/dimensions.def"
#undef DIMENSION
    };
    std::string all;
    for (std::string_view type : kTypes) {
      all += (all.empty() ? "types: " : ", ") + std::string(type);
    }
    scope_.report(DiagnosticId::unknownType, name.where, name.text,
                  didYouMean(name.text, kTypes, all));
    return std::nullopt;
  }

  /// Lowers the definition to IR, works its value out and takes the IR back.
  void work(const ast::Const& node, std::optional<ir::Type> type, Constant& constant) {
    const size_t before = scope_.mission.exprs.size();
    ExprLowering lowering(scope_);
    const auto value = lowering.lower(node.value, type);
    if (value && (!type || sameType(node, *value, *type))) {
      settleConstant(node, *value, constant);
    }
    scope_.mission.exprs.resize(before);
  }

  bool sameType(const ast::Const& node, const Value& value, const ir::Type& type) {
    if (!value.longitude.valid() && value.type == type) {
      return true;
    }
    scope_.report(DiagnosticId::wrongType, node.value.where, "`" + node.name.text + "`",
                  describe(type), scope_.text(node.value.where),
                  value.longitude.valid() ? "a position" : describe(value.type));
    return false;
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

  static std::string signatureOf(const ast::ExternBehaviour& node) {
    std::string out;
    for (const ast::Formal& formal : node.formals.value_or(std::vector<ast::Formal>())) {
      out += fmt::format("{}{}: {}", out.empty() ? "" : ", ", formal.name.text, formal.type.text);
    }
    return out.empty() ? "" : "(" + out + ")";
  }

  void addParameter(const ast::Formal& formal, BehaviourDeclaration& declaration) {
    if (isUnitName(formal.name.text)) {
      scope_.report(DiagnosticId::unitAsName, formal.name.where, formal.name.text, "a parameter");
    }
    for (const ir::Parameter& other : declaration.parameters) {
      if (other.name == formal.name.text) {
        scope_.report(DiagnosticId::duplicateName, formal.name.where, formal.name.text);
      }
    }
    const auto type = findTypeOf(formal.type);
    declaration.usable = declaration.usable && type.has_value();
    declaration.parameters.push_back({formal.name.text, type.value_or(plainNumber())});
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
  for (const ast::Item& item : file.items) {
    if (const auto* constant = std::get_if<ast::Const>(&item)) {
      declarations.enterConstant(*constant);
    }
  }
  for (const ast::Item& item : file.items) {
    if (!library || mayBeImported(item)) {
      std::visit([&](const auto& node) { declarations.visit(node); }, item);
    }
  }
}

}  // namespace glider::frontend
