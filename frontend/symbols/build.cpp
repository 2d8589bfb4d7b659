// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Builds a table of what the outlines of the files declare and use.

#include "frontend/parse/outline.h"
#include "frontend/symbols/built_in.h"
#include "frontend/symbols/descriptions.h"
#include "frontend/symbols/meanings.h"
#include "frontend/symbols/type_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace glider::frontend {
namespace {

bool takesArguments(SymbolKind kind) {
  return kind == SymbolKind::State || kind == SymbolKind::Profile || kind == SymbolKind::Route ||
         kind == SymbolKind::Function;
}

/// Whether imported files may contain it.
bool mayBeShared(const OutlineDeclaration& declaration) {
  const SymbolKind kind = declaration.kind;
  const bool local = declaration.body.has_value() && kind == SymbolKind::Variable;
  return local || declaration.external || kind == SymbolKind::Constant ||
         kind == SymbolKind::Profile || kind == SymbolKind::Route;
}

class TableBuilder {
 public:
  TableBuilder(const ast::File& mission, const AnalysisInputs& inputs)
      : mission_(mission), inputs_(inputs), constant_types_(constantTypes(mission, inputs)) {}

  SymbolTable build() {
    std::vector<uint32_t> files = {mission_.file};
    for (const ast::File* library : inputs_.library) {
      files.push_back(library->file);
    }
    for (const uint32_t file : files) {
      outlines_.push_back(outlineOf(inputs_.sources, file));
      addFile(file, outlines_.back());
    }
    std::ranges::move(builtIn(inputs_.platform), std::back_inserter(symbols_));
    enterAll();
    for (size_t i = 0; i < outlines_.size(); ++i) {
      resolve(outlines_[i], bodies_[i]);
    }
    for (Symbol& symbol : symbols_) {
      std::ranges::sort(symbol.uses, {}, [](const support::SourceRange& use) {
        return std::tuple(use.file, use.begin);
      });
    }
    return {std::move(symbols_), std::move(isolated_)};
  }

 private:
  [[nodiscard]] std::string text(const support::SourceRange& range) const {
    return std::string(inputs_.sources.text(range));
  }

  // --- declarations ---

  void addFile(uint32_t file, const Outline& outline) {
    std::vector<SymbolBody>& bodies = bodies_.emplace_back();
    for (const OutlineBody& body : outline.bodies) {
      const bool isolated = outline.declarations[body.declaration].kind != SymbolKind::State;
      bodies.push_back({body.where, {}, isolated, {}});
      if (isolated) {
        isolated_.push_back(body.where);
      }
    }
    size_t next_body = 0;
    for (uint32_t i = 0; i < outline.declarations.size(); ++i) {
      const OutlineDeclaration& declaration = outline.declarations[i];
      const bool has_body =
          next_body < outline.bodies.size() && outline.bodies[next_body].declaration == i;
      if (file == mission_.file || mayBeShared(declaration)) {
        add(declaration, has_body ? &bodies[next_body] : nullptr, bodies);
      }
      next_body += has_body ? 1U : 0U;
    }
  }

  /// `own`: the body that it begins.
  void add(const OutlineDeclaration& declaration, SymbolBody* own,
           std::vector<SymbolBody>& bodies) {
    Symbol symbol;
    symbol.kind = declaration.kind;
    symbol.name = text(declaration.name);
    symbol.type = typeOf(declaration);
    symbol.unit = unitOf(symbol.type.substr(0, symbol.type.find('[')));
    symbol.description = describe(inputs_.sources, declaration.where);
    symbol.where = declaration.name;
    SymbolBody* holder = declaration.body ? &bodies[*declaration.body] : nullptr;
    if (holder != nullptr && declaration.kind == SymbolKind::Variable) {
      symbol.scope = holder->where;
      symbol.owner = holder->owner;
    }
    const auto index = static_cast<uint32_t>(symbols_.size());
    symbols_.push_back(std::move(symbol));
    if (symbols_.back().scope.valid()) {
      holder->names.emplace(symbols_.back().name, index);
    }
    if (own != nullptr) {
      own->owner = index;
      addFormals(declaration, *own);
    }
  }

  void addFormals(const OutlineDeclaration& declaration, SymbolBody& body) {
    for (const OutlineFormal& formal : declaration.formals) {
      Symbol symbol;
      symbol.kind = SymbolKind::Parameter;
      symbol.name = text(formal.name);
      symbol.type = knownType(formal.type);
      symbol.unit = unitOf(symbol.type);
      symbol.description =
          fmt::format("parameter of {} `{}`", word(declaration.kind), text(declaration.name));
      symbol.where = formal.name;
      symbol.scope = body.where;
      symbol.owner = body.owner;
      body.names.emplace(symbol.name, static_cast<uint32_t>(symbols_.size()));
      symbols_.push_back(std::move(symbol));
    }
  }

  [[nodiscard]] std::string typeOf(const OutlineDeclaration& declaration) const {
    if (takesArguments(declaration.kind)) {
      return signatureOf(declaration);
    }
    if (declaration.kind == SymbolKind::Mission) {
      return text(declaration.name);
    }
    if (declaration.typed || declaration.kind != SymbolKind::Constant) {
      const std::string type = knownType(declaration.type);
      return type.empty() ? type : type + declaration.size;
    }
    const auto found =
        constant_types_.find(std::pair(declaration.name.file, declaration.name.begin));
    return found == constant_types_.end() ? "" : found->second;
  }

  /// "leg(to: position, limit: time)"; empty if a part of it is not known.
  [[nodiscard]] std::string signatureOf(const OutlineDeclaration& declaration) const {
    std::string all;
    bool known = !declaration.formals_broken;
    for (const OutlineFormal& formal : declaration.formals) {
      known = known && !knownType(formal.type).empty();
      all += fmt::format("{}{}: {}", all.empty() ? "" : ", ", text(formal.name), formal.type);
      all += formal.usual.valid() ? " = " + text(formal.usual) : "";
    }
    std::string result = text(declaration.name);
    result += declaration.parenthesised ? "(" + all + ")" : "";
    if (declaration.kind == SymbolKind::Function) {
      known = known && !knownType(declaration.type).empty();
      result += ": " + declaration.type;
    }
    return known ? result : "";
  }

  // --- uses ---

  void enterAll() {
    for (uint32_t i = 0; i < symbols_.size(); ++i) {
      if (!symbols_[i].scope.valid()) {
        meanings_.enter(symbols_[i], i);
      }
    }
  }

  void resolve(const Outline& outline, const std::vector<SymbolBody>& bodies) {
    for (const OutlineUse& use : outline.uses) {
      const SymbolBody* body = use.body ? &bodies[*use.body] : nullptr;
      auto symbol = meanings_.find(use.naming, text(use.where), body);
      if (!symbol && use.naming == Naming::Value) {
        symbol = meanings_.find(Naming::State, text(use.where), body);  // a place of a promise
      }
      if (symbol) {
        symbols_[*symbol].uses.push_back(use.where);
      }
    }
  }

  const ast::File& mission_;
  const AnalysisInputs& inputs_;
  ConstantTypes constant_types_;
  std::vector<Outline> outlines_;
  std::vector<std::vector<SymbolBody>> bodies_;  ///< by file, as in outlines_
  std::vector<support::SourceRange> isolated_;
  std::vector<Symbol> symbols_;
  Meanings meanings_;
};

}  // namespace

SymbolTable symbolsOf(const ast::File& mission, const AnalysisInputs& inputs) {
  return TableBuilder(mission, inputs).build();
}

}  // namespace glider::frontend
