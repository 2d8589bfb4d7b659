// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/symbols.h"
#include "platforms/load/load_platform.h"
#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>

#include <string>

namespace glider::frontend::testing_support {

/// The names of a text, right or wrong, and of the standard library.
struct SymbolsRun {
  explicit SymbolsRun(std::string text)
      : file(sources.add("test.mission", std::move(text))), table(tableOf(sources, file)) {}

  static SymbolTable tableOf(support::SourceManager& sources, uint32_t file) {
    static const platforms::Platform platform =
        *platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
    static const std::string library = readSource("missions/library/standard.mission");
    const ast::File standard = parseIntact(sources, sources.add("standard.mission", library));
    return symbolsOf(parseIntact(sources, file), {platform, {&standard}, sources});
  }

  [[nodiscard]] std::string lineOf(const support::SourceRange& range) const {
    const support::LineColumn at = sources.place(range.file, range.begin);
    return fmt::format("{}:{}", at.line, at.column);
  }

  /// "parameter bottom: length [m] at 3:7, used 9:20", with its owner in front.
  [[nodiscard]] std::string show(const Symbol& symbol) const {
    std::string text = fmt::format("{} {}{}", word(symbol.kind), ownerOf(symbol), symbol.name);
    text += ": " + (symbol.type.empty() ? "?" : symbol.type);
    text += symbol.unit.empty() ? "" : " [" + symbol.unit + "]";
    text += symbol.where.valid() ? " at " + lineOf(symbol.where) : "";
    std::string uses;
    for (const support::SourceRange& use : symbol.uses) {
      if (use.file == file) {
        uses += (uses.empty() ? ", used " : " ") + lineOf(use);
      }
    }
    return text + uses;
  }

  [[nodiscard]] std::string ownerOf(const Symbol& symbol) const {
    return symbol.owner ? table.symbols()[*symbol.owner].name + "." : "";
  }

  /// What the text declares, a line each.
  [[nodiscard]] std::string declared() const {
    std::string all;
    for (const Symbol& symbol : table.symbols()) {
      all += symbol.where.file == file ? show(symbol) + "\n" : "";
    }
    return all;
  }

  /// The byte after the first `text`.
  [[nodiscard]] uint32_t after(std::string_view text) const {
    const size_t at = sources.text(file).find(text);
    EXPECT_NE(at, std::string::npos) << text;
    return static_cast<uint32_t>(at + text.size());
  }

  /// What the name is that ends with the first `text`: "length"; "nothing".
  [[nodiscard]] std::string at(std::string_view text) const {
    const Symbol* symbol = table.at(file, after(text));
    return symbol == nullptr ? "nothing" : show(*symbol);
  }

  /// Whether `name` can be used right after the first `text`.
  [[nodiscard]] bool sees(std::string_view text, std::string_view name) const {
    for (const Symbol* symbol : table.visibleAt(file, after(text))) {
      if (symbol->name == name) {
        return true;
      }
    }
    return false;
  }

  support::SourceManager sources;
  uint32_t file;
  SymbolTable table;
};

}  // namespace glider::frontend::testing_support
