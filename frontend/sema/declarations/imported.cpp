// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/declarations.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"

#include <optional>
#include <string>

namespace glider::frontend {

namespace {

struct Refused {
  std::string what;
  support::SourceRange where;
};

/// What is wrong with an item in an imported file; empty for what may be there.
struct Judge {
  std::optional<Refused> operator()(const ast::Const&) const { return std::nullopt; }
  std::optional<Refused> operator()(const ast::Import&) const { return std::nullopt; }
  std::optional<Refused> operator()(const ast::Behaviour&) const { return std::nullopt; }
  std::optional<Refused> operator()(const ast::ExternFunction&) const { return std::nullopt; }
  std::optional<Refused> operator()(const ast::ExternBehaviour&) const { return std::nullopt; }
  std::optional<Refused> operator()(const ast::ExternSensor&) const { return std::nullopt; }
  std::optional<Refused> operator()(const ast::MissionLine& item) const {
    return Refused{"a mission", item.where};
  }
  std::optional<Refused> operator()(const ast::PlatformLine& item) const {
    return Refused{"`platform`", item.where};
  }
  std::optional<Refused> operator()(const ast::Param& item) const {
    return Refused{"parameter `" + item.name.text + "`", item.name.where};
  }
  std::optional<Refused> operator()(const ast::Var& item) const {
    return Refused{"variable `" + item.name.text + "`", item.name.where};
  }
  std::optional<Refused> operator()(const ast::State& item) const {
    return Refused{"state `" + item.name.text + "`", item.name.where};
  }
  std::optional<Refused> operator()(const ast::Always& item) const {
    return Refused{"`always`", item.where};
  }
  std::optional<Refused> operator()(const ast::PlaceDeclaration& item) const {
    return Refused{"place `" + item.name.text + "`", item.name.where};
  }
  std::optional<Refused> operator()(const ast::Requirement& item) const {
    return Refused{"a requirement", item.where};
  }
  std::optional<Refused> operator()(const ast::Assumption& item) const {
    return Refused{"an assumption", item.where};
  }
  std::optional<Refused> operator()(const ast::Resumption& item) const {
    return Refused{"`resume`", item.where};
  }
  std::optional<Refused> operator()(const ast::Nap& item) const {
    return Refused{"`nap`", item.where};
  }
  std::optional<Refused> operator()(const ast::Declination& item) const {
    return Refused{"`declination`", item.where};
  }
  std::optional<Refused> operator()(const ast::Share& item) const {
    return Refused{"share `" + item.name.text + "`", item.name.where};
  }
  std::optional<Refused> operator()(const ast::Vehicles& item) const {
    return Refused{"`vehicles`", item.where};
  }
  std::optional<Refused> operator()(const ast::Choice& item) const {
    return Refused{"choice `" + item.constant.name.text + "`", item.constant.name.where};
  }
  std::optional<Refused> operator()(const ast::Preference& item) const {
    return Refused{"`prefer`", item.where};
  }
  std::optional<Refused> operator()(const ast::Pack& item) const {
    return Refused{"`pack`", item.where};
  }
};

}  // namespace

bool mayBeImported(const ast::Item& item) {
  return !std::visit(Judge(), item);
}

void checkImported(const ast::File& file, Scope& scope) {
  bool others = false;
  for (const ast::Item& item : file.items) {
    const auto* import = std::get_if<ast::Import>(&item);
    if (import != nullptr && others) {
      scope.report(support::diagnostics::headerOrder, import->where, "import",
                   "before everything else");
    }
    others = others || import == nullptr;
    if (const auto refused = std::visit(Judge(), item)) {
      scope.report(support::diagnostics::notInLibrary, refused->where, refused->what);
      if (std::holds_alternative<ast::MissionLine>(item)) {
        return;  // other parts of a mission need not be reported
      }
    }
  }
}

}  // namespace glider::frontend
