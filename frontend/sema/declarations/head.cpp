// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/declarations.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"
#include "support/word_byte.h"

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

/// The name of a file as that of a mission: "hold_deep" of "dir/hold-deep.mission".
std::string stemOf(std::string_view file) {
  file.remove_prefix(file.find_last_of('/') + 1);  // of npos: 0
  std::string name(file.substr(0, file.find('.')));
  std::ranges::replace_if(name, [](char c) { return !support::isWordByte(c); }, '_');
  const bool letter = !name.empty() && (name.front() < '0' || name.front() > '9');
  return letter ? name : "survey";
}

}  // namespace

void checkHead(const ast::File& file, Scope& scope) {
  HeadCheck check(scope);
  for (const ast::Item& item : file.items) {
    std::visit([&](const auto& node) { check.visit(node); }, item);
  }
  const support::SourceRange start{file.file, 0, 0};
  if (check.mission() == nullptr) {
    const std::string name = stemOf(scope.fileName(file.file));
    scope.report(support::diagnostics::noMissionLine, start)
        .hint("begin the file with `mission` and a name, such as `mission " + name + "`");
  }
  const bool anyState = std::ranges::any_of(
      file.items, [](const ast::Item& item) { return std::holds_alternative<ast::State>(item); });
  if (!anyState && check.mission() != nullptr) {
    scope.report(support::diagnostics::noState, check.mission()->where, check.mission()->name.text);
  }
}

}  // namespace glider::frontend
