// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/import/waypoint_list.h"

#include "frontend/bare_positions.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>
#include <vector>

namespace glider::frontend {
namespace {

constexpr std::string_view kBlanks = " \t\r\f\v";
constexpr std::string_view kDigits = "0123456789";

/// A part of the text, from its beginning.
struct Piece {
  std::string_view text;
  size_t at = 0;
};

/// The words of a line, without its comment.
std::vector<Piece> wordsOf(Piece line) {
  std::vector<Piece> words;
  const std::string_view text = line.text.substr(0, line.text.find('#'));
  size_t begin = text.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const size_t end = std::min(text.find_first_of(kBlanks, begin), text.size());
    words.push_back({text.substr(begin, end - begin), line.at + begin});
    begin = text.find_first_not_of(kBlanks, end);
  }
  return words;
}

/// A number in ddmm.mmmm as the language writes it with a letter: `0713.000 E` for `713.000`.
std::optional<ast::Literal> half(std::string_view word, bool latitude) {
  constexpr size_t kDegreesMinutes = 4;  // digits before the point
  constexpr size_t kMost = 5;
  const bool negative = word.starts_with('-');
  word.remove_prefix(negative || word.starts_with('+') ? 1 : 0);
  const size_t whole = std::min(word.find_first_not_of(kDigits), word.size());
  const std::string_view rest = word.substr(whole);
  const bool good = whole > 0 && whole <= kMost && isPlainlyDdmm(word) &&
                    (rest.empty() || (rest.front() == '.' && rest.find_first_not_of(kDigits, 1) ==
                                                                 std::string_view::npos));
  if (!good) {
    return std::nullopt;
  }
  std::string digits(kDegreesMinutes - std::min(whole, kDegreesMinutes), '0');
  digits += word;
  digits += digits.back() == '.' ? "0" : "";
  return ast::Literal{digits, latitude ? (negative ? "S" : "N") : (negative ? "W" : "E"), {}};
}

class ListReader {
 public:
  ListReader(const support::SourceManager& sources, uint32_t number,
             support::DiagnosticEngine& diagnostics)
      : text_(sources.text(number)), file_(number), diagnostics_(diagnostics) {}

  /// False, and reported, if a line is not a waypoint.
  bool read() {
    bool good = true;
    bool inside = false;
    for (size_t begin = 0; begin < text_.size();) {
      const size_t end = std::min(text_.find('\n', begin), text_.size());
      const auto words = wordsOf({text_.substr(begin, end - begin), begin});
      begin = end + 1;
      if (words.empty()) {
        continue;
      }
      if (words.front().text == "<end:waypoints>") {
        inside = false;
      } else if (!inside && words.front().text == "b_arg:") {
        noteBeginning(words);
      }
      good = (!inside || add(words)) && good;
      inside = inside || words.front().text == "<start:waypoints>";
    }
    return good;
  }

  ast::List list;

 private:
  [[nodiscard]] support::SourceRange range(const Piece& from, const Piece& to) const {
    return {file_, static_cast<uint32_t>(from.at), static_cast<uint32_t>(to.at + to.text.size())};
  }

  /// The vehicle chooses the first waypoint by `initial_wpt`; a path has an order only.
  void noteBeginning(const std::vector<Piece>& words) {
    constexpr int kNearest = -2, kAfterLastReached = -1, kFirst = 0;
    if (words.size() < 3 || words[1].text.substr(0, words[1].text.find('(')) != "initial_wpt") {
      return;
    }
    int which = kFirst;
    const std::string_view value = words[2].text;
    std::from_chars(value.data(), value.data() + value.size(), which);
    if (which != kFirst) {
      diagnostics_.report(support::diagnostics::listBeginsElsewhere, range(words[1], words[2]),
                          which == kNearest ? "the nearest waypoint"
                          : which == kAfterLastReached
                              ? "the waypoint after the last one reached"
                              : fmt::format("waypoint {}, counted from 0", which));
    }
  }

  bool add(const std::vector<Piece>& words) {
    auto longitude = half(words[0].text, false);
    auto latitude = words.size() == 2 ? half(words[1].text, true) : std::nullopt;
    const support::SourceRange line = range(words.front(), words.back());
    if (!longitude || !latitude) {
      diagnostics_.report(support::diagnostics::waypointLine, line,
                          support::onOneLine(text_.substr(line.begin, line.end - line.begin)));
      return false;
    }
    const support::SourceRange east = range(words[0], words[0]);
    const support::SourceRange north = range(words[1], words[1]);
    latitude->unit_where = north;
    longitude->unit_where = east;
    list.items.push_back(
        {ast::Position{std::move(*latitude), std::move(*longitude), north, east}, line});
    return true;
  }

  std::string_view text_;
  uint32_t file_;
  support::DiagnosticEngine& diagnostics_;
};

}  // namespace

bool isWaypointList(const std::filesystem::path& file) {
  return inLowerCase(file.extension().string()) == ".ma";
}

std::optional<ast::File> readWaypointList(const support::SourceManager& sources, uint32_t number,
                                          const ast::Name& name,
                                          support::DiagnosticEngine& diagnostics) {
  ListReader reader(sources, number, diagnostics);
  if (!reader.read()) {
    return std::nullopt;
  }
  if (reader.list.items.empty()) {
    diagnostics.report(support::diagnostics::noWaypoints, name.where, sources.name(number));
    return std::nullopt;
  }
  ast::File file;
  file.file = number;
  file.items.push_back(ast::Const{name, {}, {std::move(reader.list), name.where}, name.where});
  return file;
}

}  // namespace glider::frontend
