// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/blocks/indentation.h"

#include "frontend/parse/token_kinds.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {
namespace {

/// The lines that the tokens are on.
class Lines {
 public:
  Lines(const Source& source, const std::vector<Lexeme>& in) : text_(source.text()), in_(in) {}

  [[nodiscard]] size_t begin(size_t k) const {
    return in_[k].begin == 0 ? 0 : text_.rfind('\n', in_[k].begin - 1) + 1;
  }
  /// The white space at the beginning of its line.
  [[nodiscard]] std::string_view indent(size_t k) const {
    const size_t from = begin(k);
    return text_.substr(from, std::min(text_.find_first_not_of(" \t", from), text_.size()) - from);
  }
  [[nodiscard]] bool isFirst(size_t k) const {
    return in_[k].begin != in_[k].end && begin(k) + indent(k).size() == in_[k].begin;
  }
  /// The first token of its line.
  [[nodiscard]] size_t first(size_t k) const {
    while (k > 0 && !isFirst(k) && begin(k - 1) == begin(k)) {
      --k;
    }
    return k;
  }

 private:
  std::string_view text_;
  const std::vector<Lexeme>& in_;
};

/// Whether `indent` is certainly less than `other`: tabs and spaces are not compared.
bool isLess(std::string_view indent, std::string_view other) {
  return indent.size() < other.size() && other.starts_with(indent);
}

/// The first token after the actions of the block: it stands no deeper than the block's own line.
size_t firstAfter(const Lines& lines, const std::vector<Lexeme>& in, size_t opener, size_t end) {
  const std::string_view indent = lines.indent(opener);
  size_t deep = 0;
  for (size_t k = opener + 1; k < end; ++k) {
    const uint32_t type = in[k].type;
    const bool shallow = lines.isFirst(k) && indent.starts_with(lines.indent(k));
    if (deep == 0 && shallow && !oneOf(type, {GliderLexer::ELSE, GliderLexer::THEN})) {
      return k;
    }
    deep += oneOf(type, {GliderLexer::IF, GliderLexer::DO}) ? 1U : 0U;
    deep -= type == GliderLexer::END && deep > 0 ? 1U : 0U;
  }
  return end;
}

}  // namespace

EndOfBlock endByIndentation(const Source& source, const std::vector<Lexeme>& in, size_t outer,
                            size_t opener, size_t end) {
  const Lines lines(source, in);
  if (lines.begin(opener) == lines.begin(end)) {
    return {.sure = true, .unended = std::nullopt};
  }
  const std::string_view indent = lines.indent(opener);
  if (!lines.isFirst(end) || !isLess(lines.indent(outer), indent)) {
    return {};
  }
  if (lines.indent(end) == indent) {
    return {.sure = true, .unended = std::nullopt};
  }
  const size_t first = lines.first(opener);
  const size_t after = firstAfter(lines, in, opener, end);
  const bool begins = oneOf(in[first].type, {GliderLexer::IF, GliderLexer::FOR, GliderLexer::ELSE});
  // Without actions before it, the indentation says nothing.
  const bool empty =
      oneOf(in[after - 1].type, {GliderLexer::THEN, GliderLexer::DO, GliderLexer::ELSE});
  const bool statement = isAnyName(in[after].type) ||
                         oneOf(in[after].type, {GliderLexer::SET, GliderLexer::LOG, GliderLexer::IF,
                                                GliderLexer::FOR, GliderLexer::END});
  if (!isLess(lines.indent(end), indent) || !begins || empty || !statement) {
    return {};
  }
  const bool loop = in[first].type == GliderLexer::FOR;
  return {.sure = false,
          .unended = UnendedBlock{.opener = loop ? in[first] : in[opener],
                                  .what = loop ? "this `for`" : "this `if`",
                                  .before = in[after],
                                  .place = static_cast<uint32_t>(lines.begin(after)),
                                  .text = fmt::format("{}end\n", indent)}};
}

}  // namespace glider::frontend
