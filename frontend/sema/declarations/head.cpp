// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/declarations.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"

#include <algorithm>

namespace glider::frontend {

namespace {

/// Checks that the items of the head come first, once each.
class HeadCheck {
 public:
  explicit HeadCheck(Scope& scope) : scope_(scope) {}

  void visit(const ast::MissionLine& line) {
    if (mission_ != nullptr) {
      scope_
          .report(support::diagnostics::secondMission, line.where, line.name.text,
                  mission_->name.text)
          .note(mission_->where, "the first is here");
      return;
    }
    if (others_ > 0) {
      scope_.report(support::diagnostics::headerOrder, line.where, "mission", "first");
    }
    mission_ = &line;
    scope_.mission.name = line.name.text;
  }
  void visit(const ast::PlatformLine& line) {
    if (platform_ != nullptr) {
      scope_.report(support::diagnostics::memberTwice, line.where, "a mission", "platform")
          .note(platform_->where, "the first is here");
      return;
    }
    if (others_ > imports_) {
      scope_.report(support::diagnostics::headerOrder, line.where, "platform",
                    "right after the `mission` line");
    }
    platform_ = &line;
  }
  void visit(const ast::Import& line) {
    if (others_ > imports_) {
      scope_.report(support::diagnostics::headerOrder, line.where, "import",
                    "after the `mission` and `platform` lines, before everything else");
    }
    ++imports_;
    ++others_;
  }
  template <typename T>
  void visit(const T&) {
    ++others_;
  }

  [[nodiscard]] const ast::MissionLine* mission() const { return mission_; }

 private:
  Scope& scope_;
  const ast::MissionLine* mission_ = nullptr;
  const ast::PlatformLine* platform_ = nullptr;
  size_t imports_ = 0;
  size_t others_ = 0;
};

}  // namespace

void checkHead(const ast::File& file, Scope& scope) {
  HeadCheck check(scope);
  for (const ast::Item& item : file.items) {
    std::visit([&](const auto& node) { check.visit(node); }, item);
  }
  const support::SourceRange start{file.file, 0, 0};
  if (check.mission() == nullptr) {
    scope.report(support::diagnostics::noMissionLine, start);
  }
  const bool anyState = std::ranges::any_of(
      file.items, [](const ast::Item& item) { return std::holds_alternative<ast::State>(item); });
  if (!anyState && check.mission() != nullptr) {
    scope.report(support::diagnostics::noState, check.mission()->where, check.mission()->name.text);
  }
}

}  // namespace glider::frontend
