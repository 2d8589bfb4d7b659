// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include <memory>

#include "frontend/frontend.h"
#include "frontend/parse/build_ast.h"
#include "frontend/parse/error_strategy.h"
#include "frontend/parse/lexeme_source.h"
#include "frontend/parse/repair.h"
#include "frontend/parse/token_kinds.h"

namespace glider::frontend {

using grammar::GliderParser;
using support::DiagnosticId;

namespace {

constexpr size_t kLargestFile = 8U << 20U;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// The length of the UTF-8 character at `at`; 0 if there is none (RFC 3629, table 3-7 of the Unicode standard).
size_t characterLength(std::string_view text, size_t at) {
  auto byte = [&](size_t k) { return at + k < text.size() ? static_cast<unsigned char>(text[at + k]) : 0U; };
  auto follows = [&](size_t k, unsigned low, unsigned high) { return byte(k) >= low && byte(k) <= high; };
  const unsigned b = byte(0);
  if (b < 0x80U) {
    return 1;
  }
  if (b >= 0xC2U && b <= 0xDFU) {
    return follows(1, 0x80, 0xBF) ? 2 : 0;
  }
  if (b >= 0xE0U && b <= 0xEFU) {
    const bool second = follows(1, b == 0xE0U ? 0xA0 : 0x80, b == 0xEDU ? 0x9F : 0xBF);
    return second && follows(2, 0x80, 0xBF) ? 3 : 0;
  }
  if (b >= 0xF0U && b <= 0xF4U) {
    const bool second = follows(1, b == 0xF0U ? 0x90 : 0x80, b == 0xF4U ? 0x8F : 0xBF);
    return second && follows(2, 0x80, 0xBF) && follows(3, 0x80, 0xBF) ? 4 : 0;
  }
  return 0;
}

/// Checks that the file is text at all. False if it is not worth reading.
bool checkEncoding(const Source& source, SyntaxReporter& reporter) {
  const std::string_view text = source.text();
  auto line = [&](size_t at) { return source.sources.place(source.file, static_cast<uint32_t>(at)).line; };
  auto at = [](size_t place) { return Lexeme{0, static_cast<uint32_t>(place), static_cast<uint32_t>(place)}; };
  if (text.size() > kLargestFile) {
    reporter.at(at(0), DiagnosticId::fileTooLarge, text.size(), kLargestFile);
    return false;
  }
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    reporter.at(at(0), DiagnosticId::utf16);
    return false;
  }
  if (const size_t nul = text.find('\0'); nul != std::string_view::npos) {
    reporter.at(at(nul), DiagnosticId::nulByte, line(nul));
    return false;
  }
  for (size_t i = 0; i < text.size();) {
    const size_t length = characterLength(text, i);
    if (length == 0) {
      reporter.at(at(i), DiagnosticId::notUtf8, static_cast<unsigned char>(text[i]), line(i));
      return true;
    }
    i += length;
  }
  return true;
}

/// The parse tree with what it lives on.
class Parse {
 public:
  Parse(const std::vector<Lexeme>& lexemes, SyntaxReporter& reporter)
      : source_(lexemes), tokens_(&source_), parser_(&tokens_), reporter_(reporter) {
    parser_.removeErrorListeners();
  }

  /// Null if the tokens do not make a mission; reported.
  GliderParser::FileContext* tree() {
    auto* simulator = parser_.getInterpreter<antlr4::atn::ParserATNSimulator>();
    // Right missions, nearly all, parse in the faster mode; only what fails there is read again in full.
    simulator->setPredictionMode(antlr4::atn::PredictionMode::SLL);
    parser_.setErrorHandler(std::make_shared<antlr4::BailErrorStrategy>());
    try {
      return parser_.file();
    } catch (const antlr4::ParseCancellationException&) {
    }
    tokens_.seek(0);
    parser_.reset();
    simulator->setPredictionMode(antlr4::atn::PredictionMode::LL);
    parser_.setErrorHandler(std::make_shared<ErrorStrategy>(reporter_));
    const size_t before = reporter_.count();
    try {
      GliderParser::FileContext* tree = parser_.file();
      return reporter_.count() == before ? tree : nullptr;
    } catch (const antlr4::ParseCancellationException&) {
      return nullptr;  // too many mistakes
    }
  }

 private:
  LexemeSource source_;
  antlr4::CommonTokenStream tokens_;
  GliderParser parser_;
  SyntaxReporter& reporter_;
};

}  // namespace

std::optional<ast::File> parse(const support::SourceManager& sources, uint32_t file,
                               support::DiagnosticEngine& diagnostics) {
  const Source source{sources, file};
  SyntaxReporter reporter(source, diagnostics);
  if (!checkEncoding(source, reporter)) {
    return std::nullopt;
  }
  const size_t start = source.text().starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  const std::vector<Lexeme> lexemes = lex(source.text(), start);
  if (lexemes.size() == 1) {
    reporter.at(lexemes.back(), DiagnosticId::emptyFile);
    return std::nullopt;
  }
  Repaired repaired = repair(lexemes, reporter);
  std::optional<ast::File> result;
  if (repaired.parseable) {
    Parse run(repaired.lexemes, reporter);
    if (GliderParser::FileContext* tree = run.tree()) {
      result = AstBuilder(source).file(tree);
    }
  }
  if (reporter.full()) {
    reporter.at(lexemes.back(), DiagnosticId::tooManyMistakes, SyntaxReporter::kMostMistakes);
  }
  return result;
}

}  // namespace glider::frontend
