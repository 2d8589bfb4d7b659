// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/outline.h"

#include "frontend/parse/outline_header.h"
#include "frontend/parse/outline_naming.h"
#include "frontend/parse/token_kinds.h"

#include <algorithm>
#include <utility>

namespace glider::frontend {
namespace {

/// Whether it ends the declaration before it.
bool startsAnything(uint32_t type) {
  return isHardKeyword(type) &&
         !oneOf(type, {GliderLexer::TRUE, GliderLexer::FALSE, GliderLexer::AND_WORD,
                       GliderLexer::OR_WORD, GliderLexer::NOT_WORD});
}

/// After the `end` of actions, not of a state.
bool goesOnInState(uint32_t type) {
  return isTransition(type) ||
         oneOf(type, {GliderLexer::DONE, GliderLexer::CASE, GliderLexer::END, GliderLexer::EVENTS,
                      GliderLexer::ENTRY, GliderLexer::SENSORS, GliderLexer::SAMPLE});
}

bool opensBlock(uint32_t type) {
  return oneOf(type, {GliderLexer::BEGIN, GliderLexer::DO, GliderLexer::IF});
}

SymbolKind behaviourKind(uint32_t type) {
  return type == GliderLexer::FLIGHTPROFILE ? SymbolKind::Profile : SymbolKind::Route;
}

/// One walk over the tokens of a file.
class OutlineReader {
 public:
  OutlineReader(const Source& source, const std::vector<Lexeme>& lexemes)
      : source_(source), lexemes_(lexemes) {}

  Outline run() {
    while (type(0) != kEof) {
      if (startsAnything(type(0)) || startsSoftItem()) {
        declaration_ = nullptr;
      }
      step();
      if (declaration_ != nullptr && at_ > 0) {
        extend(lexemes_[at_ - 1]);
      }
    }
    closeBody(lexemes_.back().begin);
    return std::move(outline_);
  }

 private:
  [[nodiscard]] const Lexeme& peek(size_t k) const {
    return lexemes_[std::min(at_ + k, lexemes_.size() - 1)];
  }
  [[nodiscard]] uint32_t type(size_t k) const { return peek(k).type; }
  [[nodiscard]] uint32_t before() const { return at_ == 0 ? kEof : lexemes_[at_ - 1].type; }

  /// `resume within …`, `declination …`, `assume …`, `pack …`, `nap at most …`, `place NAME = …`
  [[nodiscard]] bool startsSoftItem() const {
    return (type(0) == GliderLexer::RESUME && type(1) == GliderLexer::WITHIN) || startsShare() ||
           startsVehicles() || startsNap() ||
           (oneOf(type(0), {GliderLexer::DECLINATION, GliderLexer::ASSUME, GliderLexer::PACK}) &&
            endsValue(before())) ||
           startsChoice() || startsPreference() ||
           (type(0) == GliderLexer::PLACE && isAnyName(type(1)) && type(2) == GliderLexer::ASSIGN);
  }

  /// `nap at most …`, but not of `visit nap at most 3 times`
  [[nodiscard]] bool startsNap() const {
    return type(0) == GliderLexer::NAP && type(1) == GliderLexer::AT &&
           type(2) == GliderLexer::MOST && endsValue(before()) && before() != GliderLexer::VISIT;
  }

  /// `choose NAME : …`
  [[nodiscard]] bool startsChoice() const {
    return type(0) == GliderLexer::CHOOSE && isAnyName(type(1)) && type(2) == GliderLexer::COLON;
  }

  /// `prefer least …`
  [[nodiscard]] bool startsPreference() const {
    return type(0) == GliderLexer::PREFER && endsValue(before()) &&
           oneOf(type(1), {GliderLexer::LEAST, GliderLexer::GREATEST, GliderLexer::ENDURANCE});
  }

  /// `share NAME …`
  [[nodiscard]] bool startsShare() const {
    return type(0) == GliderLexer::SHARE && endsValue(before()) && isAnyName(type(1));
  }

  /// `vehicles ada, bob`, at the beginning of a line
  [[nodiscard]] bool startsVehicles() const {
    const uint32_t end = at_ == 0 ? 0 : lexemes_[at_ - 1].end;
    return type(0) == GliderLexer::VEHICLES && isAnyName(type(1)) && endsValue(before()) &&
           source_.text().substr(end, peek(0).begin - end).contains('\n');
  }

  /// The names of vehicles are names of nothing in the mission.
  void skipVehicles() {
    at_ += 2;
    while (type(0) == GliderLexer::COMMA && isAnyName(type(1))) {
      at_ += 2;
    }
  }

  /// Reads one construct, and at least one token.
  void step() {
    if (startsItem(type(0)) && before() != GliderLexer::REQUIRE) {
      closeBody(peek(0).begin);
    }
    if (definesBehaviour()) {
      closeBody(peek(0).begin);
      return declareWithBody(behaviourKind(type(0)));
    }
    if (startsVehicles()) {
      return skipVehicles();
    }
    switch (type(0)) {
      case GliderLexer::MISSION:
        return declare(SymbolKind::Mission, 1);
      case GliderLexer::CONST:
        return declare(SymbolKind::Constant, 1);
      case GliderLexer::PARAM:
        return declare(SymbolKind::Parameter, 1);
      case GliderLexer::VAR:
        return declare(SymbolKind::Variable, 1);
      case GliderLexer::STATE:
        return declareWithBody(SymbolKind::State);
      case GliderLexer::EXTERN:
        return declareExternal();
      case GliderLexer::CHOOSE:
        if (startsChoice()) {
          return declare(SymbolKind::Constant, 1);
        }
        block();
        return use();
      case GliderLexer::SHARE:
        if (startsShare() && type(2) == GliderLexer::COLON) {
          return declare(SymbolKind::Variable, 1);
        }
        [[fallthrough]];
      default:
        block();
        return use();
    }
  }

  // --- declarations ---

  /// Declares the name `name_at` tokens ahead, if there is one; what follows its header is read
  /// next.
  void declare(SymbolKind kind, size_t name_at) {
    const Lexeme first = peek(0);
    at_ += name_at;
    if (!isAnyName(type(0))) {
      return;
    }
    OutlineDeclaration declaration;
    declaration.kind = kind;
    declaration.name = source_.range(peek(0));
    declaration.where = {source_.file, first.begin, peek(0).end};
    declaration.body = body_;
    declaration.external = first.type == GliderLexer::EXTERN;
    ++at_;
    at_ = readHeader(source_, lexemes_, at_, declaration);
    for (const support::SourceRange& name : declaration.usual_names) {
      outline_.uses.push_back({Naming::Value, name, std::nullopt});
    }
    outline_.declarations.push_back(std::move(declaration));
    declaration_ = &outline_.declarations.back();
    extend(lexemes_[at_ - 1]);
  }

  void declareWithBody(SymbolKind kind) {
    const Lexeme first = peek(0);
    const size_t before = outline_.declarations.size();
    declare(kind, 1);
    declaration_ = nullptr;
    if (outline_.declarations.size() == before) {
      return;
    }
    body_ = static_cast<uint32_t>(outline_.bodies.size());
    outline_.bodies.push_back(
        {{source_.file, first.begin, lexemes_[at_ - 1].end}, static_cast<uint32_t>(before)});
    depth_ = 0;
  }

  void declareExternal() {
    switch (type(1)) {
      case GliderLexer::FUNCTION:
        return declare(SymbolKind::Function, 2);
      case GliderLexer::SENSOR:
        return declare(SymbolKind::Sensor, 2);
      case GliderLexer::FLIGHTPROFILE:
      case GliderLexer::FLIGHTROUTE:
        return declare(behaviourKind(type(1)), 2);
      default:
        ++at_;
    }
  }

  /// `flightprofile saw(top: length)` or `flightprofile saw begin`, not the use of one.
  [[nodiscard]] bool definesBehaviour() const {
    if (!isBehaviourWord(type(0)) || !isAnyName(type(1))) {
      return false;
    }
    const bool formals =
        type(2) == GliderLexer::LPAREN && isAnyName(type(3)) && type(4) == GliderLexer::COLON;
    return formals || type(pastParentheses(2)) == GliderLexer::BEGIN;
  }

  [[nodiscard]] size_t pastParentheses(size_t k) const {
    if (type(k) != GliderLexer::LPAREN) {
      return k;
    }
    while (type(k) != GliderLexer::RPAREN && type(k) != kEof && !isHardKeyword(type(k))) {
      ++k;
    }
    return type(k) == GliderLexer::RPAREN ? k + 1 : k;
  }

  void extend(const Lexeme& last) {
    const bool header_only = declaration_->kind == SymbolKind::Mission;
    if (!header_only) {
      declaration_->where.end = std::max(declaration_->where.end, last.end);
    }
  }

  // --- bodies ---

  /// Counts what the next token opens or closes.
  void block() {
    if (!body_) {
      return;
    }
    if (opensBlock(type(0))) {
      ++depth_;
    } else if (type(0) == GliderLexer::END) {
      // If a `begin`, `do` or `if` is missing, there is one `end` too many.
      const bool last = depth_ <= 1 && !goesOnInState(type(1));
      depth_ -= depth_ > 0 ? 1U : 0U;
      if (last) {
        closeBody(peek(0).end);
      }
    }
  }

  void closeBody(uint32_t end) {
    if (body_) {
      outline_.bodies[*body_].where.end = std::max(outline_.bodies[*body_].where.end, end);
      body_ = std::nullopt;
    }
  }

  // --- uses ---

  void use() {
    const uint32_t keyword = type(0);
    const std::optional<Naming> named = namingAfter(keyword, before());
    if (named && isAnyName(type(1))) {
      note(1, *named);
      at_ += 2;
      // `require never a after b`
      if (keyword == GliderLexer::NEVER && type(0) == GliderLexer::AFTER && isAnyName(type(1))) {
        note(1, Naming::State);
        at_ += 2;
      }
      return;
    }
    if (const auto naming = valueNaming(before(), type(0), type(1))) {
      note(0, *naming);
    }
    ++at_;
  }

  void note(size_t ahead, Naming naming) {
    outline_.uses.push_back({naming, source_.range(peek(ahead)), body_});
  }

  const Source& source_;
  const std::vector<Lexeme>& lexemes_;
  size_t at_ = 0;
  Outline outline_;
  OutlineDeclaration* declaration_ = nullptr;  ///< the one whose value is being read
  std::optional<uint32_t> body_;               ///< the open one
  size_t depth_ = 0;                           ///< open blocks in it
};

}  // namespace

Outline outlineOf(const support::SourceManager& sources, uint32_t file) {
  const Source source{sources, file};
  if (source.text().size() > kLargestFile) {
    return {};
  }
  const std::vector<Lexeme> lexemes = lex(source);
  return OutlineReader(source, lexemes).run();
}

}  // namespace glider::frontend
