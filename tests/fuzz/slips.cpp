// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/fuzz/slips.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <map>
#include <utility>

namespace glider::fuzz {
namespace {

bool isWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

size_t pick(std::mt19937_64& random, size_t n) {
  return n == 0 ? 0 : random() % n;
}

/// What other languages and habits write in place of a word.
constexpr std::pair<const char*, const char*> kIdioms[] = {{"&&", "AND"},
                                                           {"&&", "and"},
                                                           {"||", "OR"},
                                                           {"||", "or"},
                                                           {"&&", "&"},
                                                           {"!", "not "},
                                                           {">=", "=>"},
                                                           {"=", "=="},
                                                           {"end", "end state"},
                                                           {"end", "end if"},
                                                           {"end", "end look"},
                                                           {"goto", "then goto"},
                                                           {"call", ": call"},
                                                           {"exit", ": exit"},
                                                           {"exit", "then exit"},
                                                           {"case", "if"},
                                                           {"case", "when"},
                                                           {"m", "metres"},
                                                           {"m", "meter"},
                                                           {"h", "hours"},
                                                           {"min", "minutes"},
                                                           {"deg", "degrees"},
                                                           {"degC", "deg C"},
                                                           {"degC", "C"},
                                                           {"begin", "{"},
                                                           {"end", "}"},
                                                           {"do", "{"},
                                                           {"flightprofile", "flightprofile ="},
                                                           {"events", "events:"},
                                                           {"sensors", "sensors ="},
                                                           {">", "is above"},
                                                           {"set", ""},
                                                           {"flightprofile", "flightProfile"},
                                                           {"state", "State"},
                                                           {"begin", "BEGIN"},
                                                           {"s", "sec"},
                                                           {"deg", "°"},
                                                           {"<", "below"},
                                                           {"exit", "end"},
                                                           {">", "above"},
                                                           {">", "exceeds"},
                                                           {">", "is greater than"},
                                                           {"<", "is less than"},
                                                           {">=", "is at least"},
                                                           {"<=", "at most"},
                                                           {"!", "NOT "},
                                                           {"degC", "°C"},
                                                           {"degC", "degrees C"},
                                                           {"case", "When"},
                                                           {"case", "on"},
                                                           {"case", "IF"},
                                                           {"case", ""},
                                                           {"case", "CASE"},
                                                           {"goto", "=> goto"},
                                                           {"goto", "go to"},
                                                           {"goto", "goto state"},
                                                           {"goto", "Goto"},
                                                           {"call", "-> call"},
                                                           {"call", "call state"},
                                                           {"call", "jump"},
                                                           {"exit", ", exit"},
                                                           {"exit", "exit mission"},
                                                           {"exit", "EXIT"},
                                                           {"return", "return up"},
                                                           {"stay", "stay exit"},
                                                           {"=", ":="},
                                                           {"..", "to"},
                                                           {"..", "-"},
                                                           {"log", "print"},
                                                           {"do", ""},
                                                           {"then", ""},
                                                           {",", ",,"},
                                                           {")", ",)"},
                                                           {"]", ",]"},
                                                           {"N", "N,"},
                                                           {"&&", ","},
                                                           {"events", "EVENTS"},
                                                           {"set", "Set"},
                                                           {"true", "TRUE"},
                                                           {"sensors", "SENSORS:"}};

class Slips {
 public:
  Slips(const std::string& mission, std::mt19937_64& random)
      : mission_(mission), tokens_(mission), random_(random) {}

  std::optional<Slipped> draw() {
    if (tokens_.all().size() < 4) {
      return std::nullopt;
    }
    using Draw = std::optional<Slipped> (Slips::*)();
    constexpr std::array<Draw, 15> kDraws = {
        &Slips::deleted,     &Slips::doubled,     &Slips::swapped, &Slips::misspelt,
        &Slips::replaced,    &Slips::punctuation, &Slips::header,  &Slips::header,
        &Slips::lineChanged, &Slips::lookalike,   &Slips::idiom,   &Slips::idiom,
        &Slips::idiom,       &Slips::comment,     &Slips::value};
    return (this->*kDraws.at(pick(random_, kDraws.size())))();
  }

 private:
  Slipped put(std::string kind, size_t begin, size_t end, const std::string& by) {
    Slipped slipped{std::move(kind), mission_, begin, begin + by.size()};
    slipped.text.replace(begin, end - begin, by);
    return slipped;
  }
  size_t token() { return pick(random_, tokens_.all().size()); }
  Tokens::Token at(size_t n) { return tokens_.all()[n]; }
  std::string text(size_t n) { return std::string(tokens_.text(n)); }

  std::optional<Slipped> deleted() {
    const auto t = at(token());
    return put("token deleted", t.begin, t.end, "");
  }

  std::optional<Slipped> doubled() {
    const size_t n = token();
    return put("token doubled", at(n).end, at(n).end, " " + text(n));
  }

  std::optional<Slipped> swapped() {
    const size_t n = pick(random_, tokens_.all().size() - 1);
    const std::string between = mission_.substr(at(n).end, at(n + 1).begin - at(n).end);
    if (between.find('#') != std::string::npos || between.find('/') != std::string::npos) {
      return std::nullopt;
    }
    return put("tokens swapped", at(n).begin, at(n + 1).end, text(n + 1) + between + text(n));
  }

  std::optional<Slipped> misspelt() {
    const size_t n = token();
    std::string word = text(n);
    if (!std::isalpha(static_cast<unsigned char>(word[0]))) {
      return std::nullopt;
    }
    const size_t k = pick(random_, word.size());
    const char letter = static_cast<char>('a' + pick(random_, 26));
    switch (pick(random_, 5)) {
      case 0:
        word.erase(k, 1);
        break;
      case 1:
        word.insert(k, 1, letter);
        break;
      case 2:
        word[k] = letter;
        break;
      case 3:
        std::swap(word[k], word[std::min(k + 1, word.size() - 1)]);
        break;
      default:
        std::ranges::transform(word, word.begin(), [](unsigned char c) { return std::toupper(c); });
    }
    return put("word misspelt", at(n).begin, at(n).end, word);
  }

  std::optional<Slipped> replaced() {
    const size_t n = token();
    return put("token replaced", at(n).begin, at(n).end, text(token()));
  }

  std::optional<Slipped> punctuation() {
    constexpr std::array<std::string_view, 24> kSigns = {":", ";", ",", ".", "=",  "{", "}", "(",
                                                         ")", "[", "]", "'", "\"", "!", "?", "-",
                                                         "<", ">", "&", "|", "==", "*", "/", "%"};
    const auto t = at(token());
    const size_t place = pick(random_, 2) == 0 ? t.begin : t.end;
    return put("sign inserted", place, place, std::string(kSigns.at(pick(random_, kSigns.size()))));
  }

  /// `state go home`, `state hold-deep`, `mission "x"`.
  std::optional<Slipped> header() {
    std::vector<size_t> names;
    for (size_t n = 0; n + 1 < tokens_.all().size(); ++n) {
      const std::string_view word = tokens_.text(n);
      if (word == "state" || word == "mission" || word == "goto" || word == "call") {
        names.push_back(n + 1);
      }
    }
    if (names.empty()) {
      return std::nullopt;
    }
    const size_t n = names[pick(random_, names.size())];
    const std::string name = text(n);
    constexpr std::array<std::pair<std::string_view, std::string_view>, 18> kSlips = {{
        {"", ":"},
        {"", " begin"},
        {"go ", ""},
        {"", " deep"},
        {"", "-deep"},
        {"go-", ""},
        {"1", ""},
        {"\"", "\""},
        {"", ","},
        {"", "."},
        {"", "()"},
        {"", ";"},
        {"“", "”"},
        {"the ", ""},
        {": ", ""},
        {"= ", ""},
        {"", " 2"},
        {"", " {"},
    }};
    const auto& [before, after] = kSlips.at(pick(random_, kSlips.size()));
    if (pick(random_, 6) == 0 && name.find('_') != std::string::npos) {
      std::string apart = name;
      std::ranges::replace(apart, '_', pick(random_, 2) == 0 ? ' ' : '-');
      return put("name in two words", at(n).begin, at(n).end, apart);
    }
    return put("header slip", at(n).begin, at(n).end,
               std::string(before) + name + std::string(after));
  }

  std::optional<Slipped> lineChanged() {
    const size_t place =
        mission_.find(pick(random_, 2) == 0 ? '\n' : ' ', pick(random_, mission_.size()));
    if (place == std::string::npos) {
      return std::nullopt;
    }
    const bool join = mission_[place] == '\n';
    return put(join ? "lines joined" : "line split", place, place + 1, join ? " " : "\n");
  }

  std::optional<Slipped> lookalike() {
    static const std::multimap<std::string, std::string, std::less<>> kAlike = {
        {"-", "–"},
        {"-", "−"},
        {">=", "≥"},
        {"<=", "≤"},
        {"*", "×"},
        {" ", "\xC2\xA0"},
        {"a", "а"},
        {"o", "о"},
        {"e", "е"},
        {"deg", "°"},
        {" ", "\xE2\x80\xAF"},
        {",", "，"},
        {"(", "（"},
        {" ", "\xE2\x80\x8B"},
        {"\"", "”"}};
    auto row = kAlike.begin();
    std::advance(row, pick(random_, kAlike.size()));
    const size_t place = mission_.find(row->first, pick(random_, mission_.size()));
    return place == std::string::npos
               ? std::nullopt
               : std::optional(put("look-alike", place, place + row->first.size(), row->second));
  }

  /// What other languages and habits write.
  std::optional<Slipped> idiom() {
    static const std::multimap<std::string, std::string, std::less<>> kByWord(std::begin(kIdioms),
                                                                              std::end(kIdioms));
    std::vector<std::pair<size_t, std::string>> places;
    for (size_t n = 0; n < tokens_.all().size(); ++n) {
      const auto [first, last] = kByWord.equal_range(text(n));
      for (auto row = first; row != last; ++row) {
        places.emplace_back(n, row->second);
      }
      std::string comma = text(n);
      if (std::isdigit(static_cast<unsigned char>(comma[0])) != 0 &&
          comma.find('.') != std::string::npos) {
        std::ranges::replace(comma, '.', ',');
        places.emplace_back(n, comma);
      }
    }
    if (places.empty()) {
      return std::nullopt;
    }
    const auto& [n, by] = places[pick(random_, places.size())];
    return put("idiom", at(n).begin, at(n).end, by);
  }

  /// A comment as in other languages, or without any sign.
  std::optional<Slipped> comment() {
    constexpr std::array<std::string_view, 6> kSigns = {"%", "--", ";", "!", "REM", ""};
    std::vector<size_t> places;
    for (size_t at = mission_.find('#'); at != std::string::npos; at = mission_.find('#', at + 1)) {
      places.push_back(at);
    }
    if (places.empty()) {
      return std::nullopt;
    }
    const size_t at = places[pick(random_, places.size())];
    const size_t line = std::min(mission_.find('\n', at), mission_.size());
    Slipped slipped =
        put("comment sign", at, at + 1, std::string(kSigns.at(pick(random_, kSigns.size()))));
    slipped.end += line - at - 1;
    return slipped;
  }

  /// A time of two parts, and values with the unit of another kind or system.
  std::optional<Slipped> value() {
    static const std::multimap<std::string, std::string, std::less<>> kValues = {
        {"h", "h 30 min"}, {"h", "h30"},  {"h", "h and 5 min"}, {"min", "m"},
        {"m", "degC"},     {"m", "ug/L"}, {"s", "ms"},          {"degC", "degF"},
        {"W", "-1 W"},     {"W", "X"},    {"dbar", "hPa"}};
    std::vector<std::pair<size_t, std::string>> places;
    for (size_t n = 1; n < tokens_.all().size(); ++n) {
      const auto [first, last] = kValues.equal_range(text(n));
      const bool unit = std::isdigit(static_cast<unsigned char>(text(n - 1)[0])) != 0;
      for (auto row = first; row != last && unit; ++row) {
        places.emplace_back(n, row->second);
      }
    }
    if (places.empty()) {
      return std::nullopt;
    }
    const auto& [n, by] = places[pick(random_, places.size())];
    return put("value", at(n).begin, at(n).end, by);
  }

  const std::string& mission_;
  Tokens tokens_;
  std::mt19937_64& random_;
};

}  // namespace

Tokens::Tokens(const std::string& text) : text_(text) {
  for (size_t i = 0; i < text.size();) {
    const bool line = text[i] == '#' || text.compare(i, 2, "//") == 0;
    if (line) {
      i = std::min(text.find('\n', i), text.size());
    } else if (text.compare(i, 2, "/*") == 0) {
      i = std::min(text.find("*/", i + 2), text.size() - 2) + 2;
    } else if (std::isspace(static_cast<unsigned char>(text[i])) != 0) {
      ++i;
    } else {
      const size_t begin = i++;
      if (text[begin] == '"') {
        i = std::min(text.find_first_of("\"\n", i), text.size() - 1) + 1;
      } else if (isWord(text[begin])) {
        while (i < text.size() && isWord(text[i])) {
          ++i;
        }
      } else if (i < text.size() && (text[i] == '=' || text[i] == '&' || text[i] == '|')) {
        ++i;
      }
      all_.push_back({begin, i});
    }
  }
}

std::string_view Tokens::text(size_t number) const {
  return std::string_view(text_).substr(all_[number].begin, all_[number].end - all_[number].begin);
}

std::optional<Slipped> slip(const std::string& mission, std::mt19937_64& random) {
  return Slips(mission, random).draw();
}

}  // namespace glider::fuzz
