// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/as_written.h"

#include "support/one_line.h"

#include <type_traits>
#include <variant>

namespace glider::analysis {
namespace {

class LoopFinder {
 public:
  void file(const ast::File& file) {
    for (const ast::Item& item : file.items) {
      if (const auto* state = std::get_if<ast::State>(&item)) {
        members(state->members);
      } else if (const auto* behaviour = std::get_if<ast::Behaviour>(&item)) {
        members(behaviour->members);
      } else if (const auto* always = std::get_if<ast::Always>(&item)) {
        cases(always->cases);
      }
    }
  }
  std::vector<WrittenLoop> take() { return std::move(found_); }

 private:
  void members(const std::vector<ast::Member>& members) {
    for (const ast::Member& member : members) {
      if (const auto* entry = std::get_if<ast::EntryMember>(&member.node)) {
        statements(entry->block.statements);
      } else if (const auto* events = std::get_if<ast::EventsMember>(&member.node)) {
        cases(events->cases);
      }
    }
  }

  void cases(const std::vector<ast::Case>& cases) {
    for (const ast::Case& one : cases) {
      if (one.action) {
        statements(one.action->statements);
      }
    }
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  void statements(const std::vector<ast::Statement>& list) {
    for (const ast::Statement& statement : list) {
      if (const auto* loop = std::get_if<ast::For>(&statement.node)) {
        const support::SourceRange& whole = statement.where;
        found_.push_back({whole, {whole.file, whole.begin, loop->last.where.end}});
        statements(loop->body);
      } else if (const auto* choice = std::get_if<ast::If>(&statement.node)) {
        statements(choice->then);
        if (choice->otherwise) {
          statements(*choice->otherwise);
        }
      }
    }
  }

  std::vector<WrittenLoop> found_;
};

}  // namespace

std::vector<WrittenLoop> loopsOf(const compiler::Parsed* parsed) {
  LoopFinder finder;
  if (parsed != nullptr) {
    finder.file(parsed->mission);
    for (const ast::File& library : parsed->libraries) {
      finder.file(library);
    }
  }
  return finder.take();
}

bool isIn(const support::SourceRange& inner, const support::SourceRange& outer) {
  return inner.valid() && inner.file == outer.file && outer.begin <= inner.begin &&
         inner.end <= outer.end;
}

std::optional<WrittenSet> asSet(std::string_view statement) {
  constexpr std::string_view kWord = "set ";
  const std::string line = support::onOneLine(statement);
  const size_t close = line.find(']');
  const size_t from = close != std::string::npos && close < line.find(" =") ? close : 0;
  const size_t sign = line.find('=', from);
  if (!line.starts_with(kWord) || sign == std::string::npos) {
    return std::nullopt;
  }
  const auto trimmed = [](std::string text) {
    text.erase(0, text.find_first_not_of(' '));
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
  };
  return WrittenSet{trimmed(line.substr(kWord.size(), sign - kWord.size())),
                    trimmed(line.substr(sign + 1))};
}

bool isPush(std::string_view statement) {
  const std::string line = support::onOneLine(statement);
  return line.starts_with("push(") || line.starts_with("push (");
}

}  // namespace glider::analysis
