// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/frontend.h"
#include "frontend/parse/build_ast.h"
#include "frontend/parse/error_strategy.h"
#include "frontend/parse/foreign_characters.h"
#include "frontend/parse/lexeme_stream.h"
#include "frontend/parse/prediction_table.h"
#include "frontend/parse/repair/repair.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <memory>

namespace glider::frontend {

using grammar::GliderParser;

namespace {

/// Checks that the file is text. False if it is not worth reading.
bool checkEncoding(const Source& source, SyntaxReporter& reporter) {
  const std::string_view text = source.text();
  auto line = [&](size_t at) {
    return source.sources.place(source.file, static_cast<uint32_t>(at)).line;
  };
  auto at = [](size_t place) {
    return Lexeme{0, static_cast<uint32_t>(place), static_cast<uint32_t>(place)};
  };
  if (text.size() > kLargestFile) {
    reporter.at(at(0), support::diagnostics::fileTooLarge, text.size(), kLargestFile);
    return false;
  }
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    reporter.at(at(0), support::diagnostics::utf16);
    return false;
  }
  if (const size_t nul = text.find('\0'); nul != std::string_view::npos) {
    reporter.at(at(nul), support::diagnostics::nulByte, line(nul));
    return false;
  }
  const auto isAscii = [](char c) { return static_cast<unsigned char>(c) < 0x80U; };
  for (size_t i = 0; i < text.size();) {
    const size_t length = isAscii(text[i]) ? 1 : characterLength(text, i);
    if (length == 0) {
      reporter.at(at(i), support::diagnostics::notUtf8, static_cast<unsigned char>(text[i]),
                  line(i));
      return true;
    }
    i += length;
  }
  return true;
}

/// One reading of repaired tokens.
class Parse {
 public:
  Parse(const std::vector<Lexeme>& lexemes, SyntaxReporter& reporter)
      : tokens_(lexemes), parser_(&tokens_), reporter_(reporter), builder_(reporter.source()) {
    parser_.removeErrorListeners();
    parser_.setInterpreter(new PredictionTable(parser_, tokens_));  // the parser owns it
  }

  /// Empty if the tokens are not a valid mission, which is reported.
  std::optional<ast::File> run() {
    // Valid missions, which are nearly all, parse in the faster mode; only what fails there is
    // parsed again in the full mode.
    if (auto file = fast()) {
      return file;
    }
    return thorough();
  }

  /// The items that parse, each separately.
  ast::File intact() {
    mode(antlr4::atn::PredictionMode::SLL, std::make_shared<antlr4::BailErrorStrategy>());
    ast::File file = emptyFile();
    while (tokens_.LA(1) != antlr4::Token::EOF) {
      const size_t start = tokens_.index();
      try {
        file.items.push_back(builder_.item(parser_.item()));
      } catch (const antlr4::ParseCancellationException&) {
        parser_.reset();
        skipToItem(start + 1);
      }
      parser_.getTreeTracker().reset();
    }
    return file;
  }

 private:
  void skipToItem(size_t from) {
    tokens_.seek(from);
    for (size_t type = tokens_.LA(1);
         type != antlr4::Token::EOF && !startsItem(static_cast<uint32_t>(type));
         type = tokens_.LA(1)) {
      tokens_.consume();
    }
  }

  void mode(antlr4::atn::PredictionMode mode,
            const std::shared_ptr<antlr4::ANTLRErrorStrategy>& strategy) {
    tokens_.seek(0);
    parser_.reset();
    parser_.getInterpreter<antlr4::atn::ParserATNSimulator>()->setPredictionMode(mode);
    parser_.setErrorHandler(strategy);
  }

  [[nodiscard]] ast::File emptyFile() const {
    ast::File file;
    file.file = reporter_.source().file;
    return file;
  }

  /// Item by item, so that the parse tree of a large mission is never completely in memory.
  std::optional<ast::File> fast() {
    mode(antlr4::atn::PredictionMode::SLL, std::make_shared<antlr4::BailErrorStrategy>());
    ast::File file = emptyFile();
    try {
      while (tokens_.LA(1) != antlr4::Token::EOF) {
        file.items.push_back(builder_.item(parser_.item()));
        parser_.getTreeTracker().reset();
      }
    } catch (const antlr4::ParseCancellationException&) {
      return std::nullopt;
    }
    return file;
  }

  std::optional<ast::File> thorough() {
    const auto strategy = std::make_shared<ErrorStrategy>(reporter_);
    mode(antlr4::atn::PredictionMode::LL, strategy);
    ast::File file = emptyFile();
    try {
      GliderParser::FileContext* tree = parser_.file();
      if (strategy->failed()) {
        return std::nullopt;
      }
      for (GliderParser::ItemContext* item : tree->item()) {
        file.items.push_back(builder_.item(item));
      }
    } catch (const antlr4::ParseCancellationException&) {
      return std::nullopt;  // too many errors
    }
    return file;
  }

  LexemeStream tokens_;
  GliderParser parser_;
  SyntaxReporter& reporter_;
  AstBuilder builder_;
};

}  // namespace

std::optional<ast::File> parse(const support::SourceManager& sources, uint32_t file,
                               support::DiagnosticEngine& diagnostics) {
  const Source source{sources, file};
  SyntaxReporter reporter(source, diagnostics);
  if (!checkEncoding(source, reporter)) {
    return std::nullopt;
  }
  const std::vector<Lexeme> lexemes = lex(source);
  if (lexemes.size() == 1) {
    reporter.at(lexemes.back(), support::diagnostics::emptyFile);
    return std::nullopt;
  }
  Repaired repaired = repair(lexemes, reporter);
  std::optional<ast::File> result;
  if (repaired.parseable) {
    result = Parse(repaired.lexemes, reporter).run();
  }
  if (!repaired.named) {
    result.reset();
  }
  if (reporter.full()) {
    reporter.at(lexemes.back(), support::diagnostics::tooManyErrors, SyntaxReporter::kMostMistakes);
  }
  return result;
}

ast::File parseIntact(const support::SourceManager& sources, uint32_t file) {
  support::DiagnosticEngine quiet;
  const Source source{sources, file};
  SyntaxReporter reporter(source, quiet);
  if (!checkEncoding(source, reporter)) {
    return {file, {}};
  }
  std::vector<Lexeme> lexemes = repair(lex(source), reporter).lexemes;
  if (lexemes.empty() || lexemes.back().type != kEof) {
    // Repair stops if there is too much to repair.
    const uint32_t end = lexemes.empty() ? 0 : lexemes.back().end;
    lexemes.push_back({kEof, end, end});
  }
  return Parse(lexemes, reporter).intact();
}

}  // namespace glider::frontend
