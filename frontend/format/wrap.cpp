// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/format/wrap.h"

#include "frontend/format/layout.h"

namespace glider::frontend::formatting {
namespace {

using Role = Piece::Role;

constexpr size_t kFurthestColumn = 60;  ///< of a bracket that its items are aligned with

/// Gives each item of a list a line of its own.
void breakLists(std::vector<Piece>& pieces) {
  std::vector<bool> lists;
  bool item_follows = false;
  for (Piece& piece : pieces) {
    const bool in_list = !lists.empty() && lists.back();
    if (piece.role == Role::Remark) {
      continue;
    }
    piece.must_break = piece.must_break || item_follows || (in_list && piece.role == Role::Closer);
    item_follows = piece.role == Role::ListOpener || (in_list && piece.role == Role::Comma);
    if (piece.role == Role::Opener || piece.role == Role::ListOpener) {
      lists.push_back(piece.role == Role::ListOpener);
    } else if (piece.role == Role::Closer && !lists.empty()) {
      lists.pop_back();
    }
  }
}

class Wrapper {
 public:
  Wrapper(const std::vector<Piece>& pieces, size_t indent, size_t hang)
      : pieces_(pieces), hang_(hang), line_indent_(indent) {}

  std::vector<std::string> run() {
    std::vector<std::string> lines;
    for (size_t i = 0; i < pieces_.size();) {
      if (i > 0) {
        line_indent_ = continuation(pieces_[i]);
      }
      const size_t end = lineEnd(i);
      lines.push_back(i > 0 ? std::string(line_indent_, ' ') : "");
      write(i, end, lines.back());
      i = end;
    }
    return lines;
  }

 private:
  struct Bracket {
    size_t column;  ///< the column where lines inside continue
    size_t base;    ///< the indent of the line that it is on
    bool list;
  };

  [[nodiscard]] size_t continuation(const Piece& piece) const {
    if (brackets_.empty()) {
      return hang_;
    }
    const Bracket& bracket = brackets_.back();
    return bracket.list && piece.role == Role::Closer ? bracket.base : bracket.column;
  }

  /// The end of the line that begins with piece `first`: at a required break, or otherwise, if the
  /// line is too long, at the last of its best breaks.
  [[nodiscard]] size_t lineEnd(size_t first) const {
    size_t best = 0;
    size_t column = line_indent_;
    for (size_t i = first; i < pieces_.size(); ++i) {
      const Piece& piece = pieces_[i];
      if (i > first) {
        if (piece.must_break) {
          return column > kColumns && best > 0 ? best : i;
        }
        if (column > kColumns && best > 0) {
          return best;
        }
        if (piece.rank != kNoBreak && (best == 0 || piece.rank <= pieces_[best].rank)) {
          best = i;
        }
      }
      const bool remark_at_end =
          piece.role == Role::Remark && i + 1 < pieces_.size() && pieces_[i + 1].must_break;
      if (!remark_at_end) {  // a remark may exceed the limit
        column += width(piece.text) + (i > first ? piece.blanks : 0);
      }
    }
    return column > kColumns && best > 0 ? best : pieces_.size();
  }

  void write(size_t first, size_t end, std::string& line) {
    const size_t before = first == 0 ? line_indent_ : 0;
    for (size_t i = first; i < end; ++i) {
      const Piece& piece = pieces_[i];
      line.append(i > first ? piece.blanks : 0, ' ');
      line += piece.text;
      if (piece.role == Role::Opener || piece.role == Role::ListOpener) {
        open(before + width(line), piece.role == Role::ListOpener);
      } else if (piece.role == Role::Closer && !brackets_.empty()) {
        brackets_.pop_back();
      }
    }
  }

  void open(size_t column, bool list) {
    if (list) {
      column = line_indent_ + kIndent;
    } else if (column > kFurthestColumn) {
      column = line_indent_ + 2 * kIndent;
    }
    brackets_.push_back({column, line_indent_, list});
  }

  const std::vector<Piece>& pieces_;
  size_t hang_;
  size_t line_indent_;
  std::vector<Bracket> brackets_;
};

}  // namespace

std::vector<std::string> wrap(std::vector<Piece> pieces, size_t indent, size_t hang) {
  breakLists(pieces);
  return Wrapper(pieces, indent, hang).run();
}

}  // namespace glider::frontend::formatting
