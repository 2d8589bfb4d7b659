// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/brief/given.h"
#include "compiler/compilation.h"
#include "report/brief/brief.h"

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glider::analysis {

/// The comment lines directly above the place `begin`, as one line; empty if there are none.
std::string commentAbove(std::string_view text, size_t begin);
/// The comment after the place `end` on its line, and the lines that continue it in the same
/// column.
std::string commentBeside(std::string_view text, size_t end);
/// The comments before the first word of a file, without its licence.
std::string commentAtHead(std::string_view text);

/// `text` of the mission as code for the page (report::Brief).
std::string inCode(std::string_view text);

/// What a mission's text says beyond its IR: names of arguments, comments, named values. For the
/// IR's text form there is nothing.
class Written {
 public:
  /// `compilation` outlives this.
  explicit Written(const compiler::Compilation& compilation);

  /// The comment at the head of the mission's file.
  [[nodiscard]] std::string head() const;
  /// The comment above the declaration of a state.
  [[nodiscard]] std::string commentOf(const std::string& state) const;
  /// How a state uses a profile or a route; only the name if the state does not name one.
  [[nodiscard]] report::BriefUse use(const std::string& state, ir::BehaviourKind kind,
                                     const std::string& name) const;
  /// Adds what is written of the parameters: value, range, comment.
  void describe(std::vector<report::BriefValue>& parameters) const;
  /// What the parameters must satisfy (`where`).
  [[nodiscard]] std::vector<std::string> conditions() const;
  /// Fixed values, variables and places of the mission's own file, and the lists of waypoints that
  /// it imports.
  [[nodiscard]] std::vector<report::BriefValue> values() const;
  /// The numbers of the files that the mission consists of, itself first.
  [[nodiscard]] std::vector<uint32_t> files() const;

 private:
  struct Declared {
    const ast::Formals* formals = nullptr;
    std::string comment;
  };

  void read(const ast::File& file);
  [[nodiscard]] std::span<const ast::Item> items() const;
  [[nodiscard]] std::string_view textOf(support::SourceRange range) const;
  [[nodiscard]] std::string line(support::SourceRange range) const;
  [[nodiscard]] std::string above(support::SourceRange range) const;
  [[nodiscard]] std::string about(support::SourceRange range) const;
  [[nodiscard]] std::vector<report::BriefValue> waypointLists() const;
  [[nodiscard]] std::string value(const ast::Expr& value) const;
  [[nodiscard]] std::string given(const Given& given) const;
  [[nodiscard]] std::string argument(const ast::Expr& value, std::string_view type) const;
  void notePositions(const ast::Item& item);
  void notePositions(const ast::State& state);
  [[nodiscard]] bool isPosition(const ast::Expr& value) const;

  const support::SourceManager& sources_;
  const compiler::Parsed* parsed_;  ///< null: the IR's text form
  std::map<std::string, Declared> behaviours_;
  std::map<std::string, const ast::Const*> constants_;
  std::set<std::string> positions_;  ///< the names of values that are one each
  std::map<std::string, const ast::State*> states_;
};

}  // namespace glider::analysis
