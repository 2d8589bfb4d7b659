// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Every mission of the project: whole, every name in it is known; cut off or with a word missing,
// what stands before the damage stays as it was.

#include "frontend/parse/lexeme.h"
#include "support/units/units.h"
#include "tests/unit/frontend/symbols_of.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

namespace glider::frontend {
namespace {

using testing_support::readSource;
using testing_support::SymbolsRun;

std::vector<std::string> missions() {
  std::vector<std::string> paths;
  const std::filesystem::path root = GLIDER_SOURCE_DIR;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "missions")) {
    if (entry.path().extension() == ".mission") {
      paths.push_back(std::filesystem::relative(entry.path(), root).string());
    }
  }
  std::ranges::sort(paths);
  return paths;
}

std::string wordAt(const std::string& text, const Lexeme& lexeme) {
  return text.substr(lexeme.begin, lexeme.end - lexeme.begin);
}

/// Whether the word at `i` belongs to a type: `: temperature/length`.
bool inType(const std::string& text, const std::vector<Lexeme>& lexemes, size_t i) {
  const std::string before = i == 0 ? "" : wordAt(text, lexemes[i - 1]);
  const bool compound = (before == "/" || before == "*") && i > 1 && inType(text, lexemes, i - 2) &&
                        isName(lexemes[i - 2].type);
  return before == ":" || compound;
}

/// Whether the word at `i` is the name of an argument, which belongs to what is called: `(top = 5
/// m`.
bool namesArgument(const std::string& text, const std::vector<Lexeme>& lexemes, size_t i) {
  const std::string before = i == 0 ? "" : wordAt(text, lexemes[i - 1]);
  return (before == "(" || before == ",") && wordAt(text, lexemes[i + 1]) == "=";
}

/// Whether the word at `i` is the name of a kind of vehicle, which is a file's, or of a vehicle.
bool namesPlatform(const std::string& text, const std::vector<Lexeme>& lexemes, size_t i) {
  size_t before = i;
  while (before > 1 && wordAt(text, lexemes[before - 1]) == ",") {
    before -= 2;
  }
  return i != 0 && (wordAt(text, lexemes[i - 1]) == "platform" ||
                    (before != 0 && wordAt(text, lexemes[before - 1]) == "vehicles"));
}

/// Whether the word at `i` is a unit that is a name elsewhere: `85 Wh`.
bool isSoftUnit(const std::string& text, const std::vector<Lexeme>& lexemes, size_t i) {
  const std::string before = i == 0 ? "" : wordAt(text, lexemes[i - 1]);
  return !before.empty() && before.front() >= '0' && before.front() <= '9' &&
         support::findUnit(wordAt(text, lexemes[i])).has_value();
}

TEST(SymbolsOfMissions, EveryNameIsKnown) {
  size_t names = 0;
  for (const std::string& path : missions()) {
    const std::string text = readSource(path);
    const SymbolsRun run(text);
    const std::vector<Lexeme> lexemes = lex(text, 0);
    for (size_t i = 0; i < lexemes.size(); ++i) {
      const bool name = isName(lexemes[i].type) && !isSoftKeyword(lexemes[i].type);
      // What an `extern` calls its parameters can be used nowhere.
      const bool formal = wordAt(text, lexemes[i + (name ? 1 : 0)]) == ":";
      if (name && !inType(text, lexemes, i) && !namesArgument(text, lexemes, i) &&
          !namesPlatform(text, lexemes, i) && !isSoftUnit(text, lexemes, i) &&
          !(formal && run.table.at(run.file, lexemes[i].begin) == nullptr)) {
        ++names;
        const Symbol* symbol = run.table.at(run.file, lexemes[i].begin);
        ASSERT_NE(symbol, nullptr) << path << ": " << wordAt(text, lexemes[i]) << " at "
                                   << run.lineOf({run.file, lexemes[i].begin, lexemes[i].end});
        const std::string word = wordAt(text, lexemes[i]);
        EXPECT_TRUE(word == symbol->name || word == symbol->vehicle_name) << word;
      }
    }
    for (const Symbol& symbol : run.table.symbols()) {
      EXPECT_FALSE(symbol.type.empty()) << path << ": " << symbol.name;
    }
  }
  EXPECT_GT(names, 800U);
}

/// The declarations of the text that are followed by another of the mission before `damage`.
std::vector<const Symbol*> standBefore(const SymbolsRun& whole, size_t damage) {
  std::vector<const Symbol*> before;
  for (const Symbol& symbol : whole.table.symbols()) {
    if (symbol.where.file == whole.file && symbol.where.end <= damage) {
      before.push_back(&symbol);
    }
  }
  // The last is still being written, with its parameters and variables.
  while (!before.empty() && before.back()->owner) {
    before.pop_back();
  }
  if (!before.empty()) {
    before.pop_back();
  }
  return before;
}

void expectUnharmed(const SymbolsRun& whole, const std::string& broken, size_t damage) {
  const SymbolsRun run(broken);
  const std::vector<const Symbol*> before = standBefore(whole, damage);
  const uint32_t safe = before.empty() ? 0 : before.back()->where.begin;
  for (const Symbol* symbol : before) {
    const Symbol* now = run.table.at(run.file, symbol->where.begin);
    ASSERT_NE(now, nullptr) << symbol->name << "\n" << broken;
    EXPECT_EQ(
        std::tuple(now->kind, now->name, now->type, now->unit, run.ownerOf(*now)),
        std::tuple(symbol->kind, symbol->name, symbol->type, symbol->unit, whole.ownerOf(*symbol)))
        << broken;
    for (const support::SourceRange& use : symbol->uses) {
      if (use.file == whole.file && use.end <= safe) {
        EXPECT_EQ(run.table.at(run.file, use.begin), now) << symbol->name << "\n" << broken;
      }
    }
  }
}

TEST(SymbolsOfMissions, CutOffAnywhere) {
  constexpr size_t kStep = 67;
  for (const std::string& path : missions()) {
    const std::string text = readSource(path);
    const SymbolsRun whole(text);
    for (size_t at = 0; at < text.size() && !HasFailure(); at += kStep) {
      expectUnharmed(whole, text.substr(0, at), at);
    }
  }
}

TEST(SymbolsOfMissions, WithoutAnyOneWord) {
  constexpr size_t kStep = 5;
  size_t first = 0;
  for (const std::string& path : missions()) {
    const std::string text = readSource(path);
    const SymbolsRun whole(text);
    const std::vector<Lexeme> lexemes = lex(text, 0);
    // Another phase in each mission, so that every word of the language is missing somewhere.
    for (size_t i = first++ % kStep; i < lexemes.size() && !HasFailure(); i += kStep) {
      const Lexeme& gone = lexemes[i];
      expectUnharmed(whole, text.substr(0, gone.begin) + text.substr(gone.end), gone.begin);
    }
  }
}

}  // namespace
}  // namespace glider::frontend
