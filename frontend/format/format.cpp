// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/format/format.h"

#include "frontend/format/align.h"
#include "frontend/format/layout.h"
#include "frontend/format/tokens.h"
#include "frontend/format/wrap.h"
#include "frontend/frontend.h"
#include "support/check.h"

#include <algorithm>
#include <initializer_list>

namespace glider::frontend {
namespace {

using namespace formatting;  // NOLINT(google-build-using-namespace): all of it is for this file

constexpr size_t kMemberWidth = std::string_view("flightprofile").size();

bool oneOf(const Token& token, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, token.text) != words.end();
}

bool isTransition(const Token& token) {
  return oneOf(token, {"goto", "call", "return", "exit", "stay"}) ||
         (token.is("done") && !token.name);
}

/// The rank of a line break before `token`, which comes after `last`.
int breakRank(const Token& last, const Token& token) {
  const int outer = 4 * static_cast<int>(token.depth);
  if (last.is(",") || last.is("||")) {
    return outer;
  }
  if (last.operation) {
    const bool comparison = oneOf(last, {"<", "<=", ">", ">=", "==", "!="});
    return outer + (last.is("&&") ? 1 : comparison ? 2 : 3);
  }
  const bool clause = isTransition(token) || token.is("do") ||
                      (oneOf(token, {"in", "where", "reads", "stale"}) && !token.name);
  if (clause && !oneOf(last, {"end", "require", "entry"})) {
    return outer;
  }
  constexpr int kLastResort = 1000;
  return last.is("=") ? kLastResort : kNoBreak;
}

/// The lines of a file with their comments.
class Composer {
 public:
  explicit Composer(const std::vector<Token>& tokens) : tokens_(tokens) {}

  std::vector<Row> run(const std::vector<Line>& lines) {
    for (const Line& line : lines) {
      const size_t inlined = commentsBefore(line);
      if (line.first + 1 < tokens_.size()) {
        compose(line, inlined);
      }
    }
    return std::move(rows_);
  }

 private:
  /// The rows of comments before a line: a remark on the line above, or lines of their own. Returns
  /// how many comments are on the line itself.
  size_t commentsBefore(const Line& line) {
    const Token& token = tokens_[line.first];
    const bool at_end = line.first + 1 == tokens_.size();
    const bool gap = token.newlines_before > 1 ||
                     std::ranges::any_of(
                         token.rows, [](const CommentRow& row) { return row.newlines_before > 1; });
    apart_ = line.apart && !gap && !rows_.empty();
    const bool opened =
        line.first > 0 && oneOf(tokens_[line.first - 1], {"begin", "do", "then", "else", "events"});
    const bool closes = oneOf(token, {"begin", "end", "else"});
    for (size_t i = 0; i < token.rows.size(); ++i) {
      const CommentRow& row = token.rows[i];
      if (i == 0 && row.newlines_before == 0 && line.first > 0) {
        rows_.back().remark = row.text();
        continue;
      }
      newRow(row.newlines_before > 1 && !(opened && fresh_));
      if (!at_end && i + 1 == token.rows.size() && token.newlines_before == 0) {
        return 1;
      }
      rows_.back().text = std::string(line.comment_indent, ' ') + row.text();
    }
    if (!at_end) {
      newRow(token.newlines_before > 1 && !closes && !(opened && fresh_));
    }
    return 0;
  }

  void newRow(bool blank) {
    const bool first = rows_.empty();
    rows_.emplace_back();
    rows_.back().blank_before = !first && (blank || apart_);
    apart_ = false;
    fresh_ = false;
  }

  void compose(const Line& line, size_t inlined) {
    pieces_.clear();
    starts_.clear();
    if (inlined > 0) {
      pieces_.push_back({tokens_[line.first].rows.back().text()});
    }
    for (size_t i = line.first; i < line.end; ++i) {
      if (i > line.first) {
        commentsInside(tokens_[i]);
      }
      add(line, i);
    }
    const bool sensors = tokens_[line.first].is("sensors") || tokens_[line.first].isSample();
    const size_t hang = line.indent + (sensors ? kMemberWidth + 1 : 2 * kIndent);
    std::vector<std::string> lines = wrap(pieces_, line.indent, hang);
    rows_.back().text = std::string(line.indent, ' ') + lines[0];
    if (lines.size() == 1 && lines[0].find('\n') == std::string::npos) {
      shape(line);
    }
    for (size_t i = 1; i < lines.size(); ++i) {
      rows_.emplace_back().text = std::move(lines[i]);
    }
    fresh_ = true;
  }

  /// The comments before a token within a line.
  void commentsInside(const Token& token) {
    for (size_t i = 0; i < token.rows.size(); ++i) {
      const CommentRow& row = token.rows[i];
      const bool remark = i == 0 && row.newlines_before == 0;
      const bool joined = i + 1 == token.rows.size() && token.newlines_before == 0;
      const bool must_break = broken_ || (!remark && !joined);
      pieces_.push_back({.text = row.text(),
                         .blanks = row.open_ended ? 2U : 1U,
                         .must_break = must_break,
                         .role = remark ? Piece::Role::Remark : Piece::Role::Word});
      broken_ = row.open_ended || (!remark && !joined);
    }
  }

  void add(const Line& line, size_t i) {
    const Token& token = tokens_[i];
    const bool commented = !token.rows.empty() && i > line.first;
    const bool first = pieces_.empty();
    Piece piece{
        .text = std::string(token.text),
        .blanks = token.tight && !(commented && !token.closes() && !token.is(",")) ? 0U : 1U,
        .rank = i > line.first ? breakRank(tokens_[i - 1], token) : kNoBreak,
        .must_break = broken_,
        .role = role(i)};
    broken_ = false;
    const bool member =
        line.indent > 0 && (oneOf(token, {"flightroute", "sensors"}) || token.isSample());
    if (first && member && tokens_[i + 1].rows.empty()) {
      piece.text.resize(kMemberWidth, ' ');
    }
    starts_.push_back(pieces_.size());
    pieces_.push_back(std::move(piece));
  }

  [[nodiscard]] Piece::Role role(size_t i) const {
    const Token& token = tokens_[i];
    if (token.opens()) {
      const Token& next = tokens_[i + 1];
      return next.broken() && !next.closes() ? Piece::Role::ListOpener : Piece::Role::Opener;
    }
    return token.closes()  ? Piece::Role::Closer
           : token.is(",") ? Piece::Role::Comma
                           : Piece::Role::Word;
  }

  /// Records which parts of a one-line row are aligned with those of its neighbours.
  void shape(const Line& line) {
    Row& row = rows_.back();
    std::vector<size_t> cells;
    const Token& head = tokens_[line.first];
    if (head.is("case")) {
      row.shape = caseCells(line, cells);
    } else if (oneOf(head, {"const", "param", "var"})) {
      row.shape = declarationCells(line, cells);
    }
    for (const size_t token : cells) {
      row.cells.push_back(offset(line, token));
    }
  }

  /// The byte of the row's text where `token` begins.
  [[nodiscard]] size_t offset(const Line& line, size_t token) const {
    const size_t piece = starts_[token - line.first];
    size_t bytes = line.indent;
    for (size_t i = 0; i <= piece; ++i) {
      bytes += (i > 0 ? pieces_[i].blanks : 0) + (i < piece ? pieces_[i].text.size() : 0);
    }
    return bytes;
  }

  [[nodiscard]] std::string caseCells(const Line& line, std::vector<size_t>& cells) const {
    const std::string shape = "case";
    size_t end = 0;
    for (size_t i = line.first; i < line.end; ++i) {
      if (cells.empty() && (tokens_[i].is("do") || isTransition(tokens_[i]))) {
        cells.push_back(i);
      }
      end = tokens_[i].is("end") ? i : end;
    }
    if (cells.empty() || !tokens_[cells[0]].is("do")) {
      return shape;
    }
    if (end == 0) {
      cells.clear();  // its block is on separate lines
      return "";
    }
    cells.push_back(end);
    return shape + " do";
  }

  [[nodiscard]] std::string declarationCells(const Line& line, std::vector<size_t>& cells) const {
    cells.push_back(line.first + 1);
    std::string shape = "value";
    for (size_t i = line.first + 2; i < line.end; ++i) {
      const Token& token = tokens_[i];
      const bool clause = oneOf(token, {"in", "where"}) && !token.name;
      if (token.depth == 0 && (clause || oneOf(token, {":", "="}))) {
        cells.push_back(i);
        shape += token.text;
      }
    }
    return shape;
  }

  const std::vector<Token>& tokens_;
  std::vector<Row> rows_;
  std::vector<Piece> pieces_;   ///< of the line that is being composed
  std::vector<size_t> starts_;  ///< the piece of each of its tokens
  bool broken_ = false;         ///< the next piece begins a line
  bool apart_ = false;          ///< the next row comes after a blank line
  bool fresh_ = false;          ///< there has been no row since the last line
};

std::string write(const std::vector<Row>& rows) {
  std::string out;
  for (const Row& row : rows) {
    out += row.blank_before ? "\n" : "";
    out += row.text + "\n";
  }
  return out;
}

std::vector<std::string> commentsOf(const std::vector<Token>& tokens) {
  std::vector<std::string> comments;
  for (const Token& token : tokens) {
    for (const CommentRow& row : token.rows) {
      comments.insert(comments.end(), row.comments.begin(), row.comments.end());
    }
  }
  return comments;
}

/// A formatter that changes a mission would be worse than none.
void checkUnchanged(const std::vector<Token>& before, const std::vector<Token>& after) {
  CHECK(std::ranges::equal(before, after, {}, &Token::text, &Token::text),
        "formatting would change the words of a mission");
  CHECK(commentsOf(before) == commentsOf(after), "formatting would change a mission's comments");
}

}  // namespace

std::optional<std::string> format(const support::SourceManager& sources, uint32_t file,
                                  support::DiagnosticEngine& diagnostics) {
  const size_t errors = diagnostics.errorCount();
  if (!parse(sources, file, diagnostics) || diagnostics.errorCount() > errors) {
    return std::nullopt;
  }
  const std::vector<Token> tokens = readTokens(sources.text(file));
  std::vector<Row> rows = Composer(tokens).run(layOut(tokens));
  align(rows);
  std::string text = write(rows);
  checkUnchanged(tokens, readTokens(text));
  return text;
}

}  // namespace glider::frontend
