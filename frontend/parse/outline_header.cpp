// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/outline_header.h"

#include "frontend/parse/token_kinds.h"

namespace glider::frontend {
namespace {

class HeaderReader {
 public:
  HeaderReader(const Source& source, const std::vector<Lexeme>& lexemes, size_t at)
      : source_(source), lexemes_(lexemes), at_(at) {}

  size_t run(OutlineDeclaration& declaration) {
    if (takesFormals(declaration) && take(GliderLexer::LPAREN)) {
      formals(declaration);
    }
    if (takesSize(declaration) && type() == GliderLexer::LBRACKET) {
      declaration.size = size();
    }
    if (take(GliderLexer::COLON)) {
      declaration.typed = true;
      declaration.type = typeName();
    }
    return at_;
  }

 private:
  static bool takesFormals(const OutlineDeclaration& declaration) {
    return declaration.kind == SymbolKind::State || declaration.kind == SymbolKind::Profile ||
           declaration.kind == SymbolKind::Route || declaration.kind == SymbolKind::Function;
  }

  static bool takesSize(const OutlineDeclaration& declaration) {
    return declaration.kind == SymbolKind::Variable || declaration.kind == SymbolKind::Parameter;
  }

  [[nodiscard]] uint32_t type() const { return lexemes_[at_].type; }

  /// "[8]", with its brackets; "" if they do not close.
  std::string size() {
    const size_t begin = at_;
    while (!oneOf(type(), {GliderLexer::RBRACKET, GliderLexer::COLON, kEof}) &&
           !isHardKeyword(type())) {
      ++at_;
    }
    if (!take(GliderLexer::RBRACKET)) {
      return "";
    }
    const Lexeme whole{0, lexemes_[begin].begin, lexemes_[at_ - 1].end};
    return std::string(source_.text(whole));
  }

  /// The last token, the end of the file, is never taken.
  bool take(uint32_t wanted) {
    const bool there = type() == wanted;
    at_ += there ? 1U : 0U;
    return there;
  }

  void formals(OutlineDeclaration& declaration) {
    declaration.parenthesised = true;
    while (!take(GliderLexer::RPAREN)) {
      if (type() == kEof || isHardKeyword(type())) {
        declaration.formals_broken = true;
        return;
      }
      formal(declaration);
    }
  }

  /// `top: length` and the comma after it. Takes at least one token.
  void formal(OutlineDeclaration& declaration) {
    if (!isAnyName(type())) {
      declaration.formals_broken = true;
      ++at_;
      return;
    }
    OutlineFormal formal{source_.range(lexemes_[at_]), ""};
    ++at_;
    if (take(GliderLexer::COLON)) {
      formal.type = typeName();
    }
    if (take(GliderLexer::ASSIGN)) {
      formal.usual = passValue(declaration);
    }
    if (take(GliderLexer::IN)) {
      (void)passValue(declaration);
    }
    declaration.formals.push_back(std::move(formal));
    const bool separated =
        take(GliderLexer::COMMA) ? type() != GliderLexer::RPAREN : type() == GliderLexer::RPAREN;
    declaration.formals_broken = declaration.formals_broken || !separated;
  }

  /// Passes what ends before the next `in`, comma or parenthesis of this list.
  support::SourceRange passValue(OutlineDeclaration& declaration) {
    support::SourceRange value = source_.range(lexemes_[at_]);
    for (int inner = 0; type() != kEof && !isHardKeyword(type()); ++at_) {
      if (inner == 0 && oneOf(type(), {GliderLexer::COMMA, GliderLexer::RPAREN, GliderLexer::IN})) {
        break;
      }
      if (isName(type())) {
        declaration.usual_names.push_back(source_.range(lexemes_[at_]));
      }
      inner += type() == GliderLexer::LPAREN ? 1 : type() == GliderLexer::RPAREN ? -1 : 0;
      value.end = source_.range(lexemes_[at_]).end;
    }
    return value;
  }

  /// `temperature/length`
  std::string typeName() {
    std::string text;
    while (isName(type())) {
      text += source_.text(lexemes_[at_++]);
      if (!oneOf(type(), {GliderLexer::TIMES, GliderLexer::DIVIDE})) {
        return text;
      }
      text += source_.text(lexemes_[at_++]);
    }
    return "";
  }

  const Source& source_;
  const std::vector<Lexeme>& lexemes_;
  size_t at_;
};

}  // namespace

size_t readHeader(const Source& source, const std::vector<Lexeme>& lexemes, size_t at,
                  OutlineDeclaration& declaration) {
  return HeaderReader(source, lexemes, at).run(declaration);
}

}  // namespace glider::frontend
