// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/positions/written_position.h"

#include "frontend/bare_positions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <vector>

namespace glider::frontend {
namespace {

constexpr double kMinutesOfDegree = 60;
constexpr size_t kMostDegrees = 3;  // digits
constexpr double kMostOfLongitude = 180;
constexpr std::string_view kBlanks = " \t";

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// "39.175": without zeros at the end.
std::string decimal(double degrees) {
  std::string text = fmt::format("{:.6f}", degrees);
  text.erase(text.find_last_not_of('0') + 1);
  return text + (text.back() == '.' ? "0" : "");
}

/// Reads half a position from left to right.
class HalfReader {
 public:
  HalfReader(std::string_view text, size_t at) : text_(text), at_(at) {
    half_.begin = at;
    half_.number = at;
  }

  std::optional<WrittenHalf> run(bool letter_first) {
    half_.letter_first = letter_first;
    if (letter_first && !letter()) {
      return std::nullopt;
    }
    blanks();
    half_.number = at_;
    if (!numbers()) {
      return std::nullopt;
    }
    half_.end = at_;
    if (!letter_first) {
      blanks();
      if (!letter()) {
        return std::nullopt;
      }
      half_.end = at_;
    }
    return judged();
  }

  std::optional<std::string> digits() {
    if (!numbers() || at_ != text_.size()) {
      return std::nullopt;
    }
    const auto half = judged();
    return half && half->certain ? std::optional(half->digits) : std::nullopt;
  }

 private:
  [[nodiscard]] char peek(size_t k = 0) const {
    return at_ + k < text_.size() ? text_[at_ + k] : 0;
  }

  bool blanks() {
    const size_t from = at_;
    at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size());
    return at_ > from;
  }

  bool take(std::initializer_list<std::string_view> words) {
    for (const std::string_view word : words) {
      if (text_.substr(at_).starts_with(word)) {
        at_ += word.size();
        return true;
      }
    }
    return false;
  }

  /// The digits of a number, with a point for its decimal comma; empty if there is none.
  std::string number() {
    std::string digits;
    const auto some = [&] {
      while (isDigit(peek())) {
        digits += text_[at_++];
      }
    };
    some();
    if (digits.empty() && peek() == '.' && isDigit(peek(1))) {
      digits = text_[at_++];
      some();
    } else if (!digits.empty() && (peek() == '.' || peek() == ',') && isDigit(peek(1))) {
      half_.comma = half_.comma || peek() == ',';
      digits += '.';
      ++at_;
      some();
    }
    half_.number_end = digits.empty() ? half_.number_end : at_;
    return digits;
  }

  /// `39-10`, `39:10`: a sign between two digits.
  bool touchingSign() {
    if (!isDigit(peek(1)) || (peek() != '-' && peek() != ':')) {
      return false;
    }
    half_.sign = true;
    ++at_;
    return true;
  }

  /// What may be between degrees and minutes.
  bool degreeSign() {
    const bool gap = blanks();
    if (!gap && touchingSign()) {
      return true;
    }
    const bool sign = take({"°", "º", "degrees", "deg"}) ||
                      ((peek() == 'd' || peek() == 'D') && take({"d", "D"}));
    half_.sign = half_.sign || sign;
    return blanks() || gap || sign;
  }

  /// What may be between minutes and seconds.
  bool minuteSign() {
    const bool gap = blanks();
    if (!gap && touchingSign()) {
      return true;
    }
    const bool sign = !take({"''"}) && take({"'", "′", "’", "´", "min", "m"});
    half_.sign = half_.sign || sign;
    return blanks() || gap || sign;
  }

  void secondSign() {
    const size_t from = at_;
    blanks();
    const bool sign = take({"\"", "″", "''", "”", "sec"}) || isSecondsLetter();
    half_.sign = half_.sign || sign;
    at_ = sign ? at_ : from;
  }

  /// The `s` of `39d10m30s N`, which is not the letter of the south.
  bool isSecondsLetter() {
    const size_t from = at_;
    if (take({"s"})) {
      blanks();
      constexpr std::string_view kLetters = "NSEWnsew";
      if (peek() != 0 && kLetters.contains(peek())) {
        return true;
      }
    }
    at_ = from;
    return false;
  }

  [[nodiscard]] bool beginsNumber() const {
    return isDigit(peek()) || (peek() == '.' && isDigit(peek(1)));
  }

  /// `.39.175`: two numbers without anything between them.
  bool touchesNext() {
    touching_ = peek() == '.' && isDigit(peek(1));
    return touching_;
  }

  bool numbers() {
    const std::string first = number();
    if (first.empty()) {
      return false;
    }
    parts_.push_back(first);
    size_t end = at_;
    if ((degreeSign() || touchesNext()) && beginsNumber()) {
      parts_.push_back(number());
      end = at_;
      if (minuteSign() && isDigit(peek())) {
        parts_.push_back(number());
        secondSign();
        end = at_;
      } else {
        end = pastSign(end);
      }
    } else {
      end = pastSign(end);
    }
    at_ = end;
    return true;
  }

  /// A sign behind the last number belongs to it, the blanks before the letter do not.
  size_t pastSign(size_t end) {
    const size_t read = text_.find_last_not_of(kBlanks, at_ == 0 ? 0 : at_ - 1) + 1;
    return std::max(end, std::min(read, at_));
  }

  bool letter() {
    struct Word {
      std::string_view name;
      char letter;
    };
    constexpr Word kWords[] = {{"north", 'N'}, {"south", 'S'}, {"east", 'E'}, {"west", 'W'}};
    size_t length = 0;
    std::string word;
    while (std::isalpha(static_cast<unsigned char>(peek(length))) != 0) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(peek(length))));
      ++length;
    }
    const auto* const row = std::ranges::find_if(kWords, [&](const Word& candidate) {
      return word == candidate.name || (word.size() == 1 && word[0] == candidate.name[0]);
    });
    if (row == std::end(kWords) || peek(length) == '_') {
      return false;
    }
    half_.letter = row->letter;
    half_.letter_at = at_;
    half_.word = length > 1;
    half_.small = length == 1 && text_[at_] != row->letter;
    at_ += length;
    return true;
  }

  /// What its numbers say.
  std::optional<WrittenHalf> judged() {
    half_.numbers = static_cast<int>(parts_.size());
    double part = 1;
    for (const std::string& digits : parts_) {
      half_.degrees += valueOf(digits) * part;
      part /= kMinutesOfDegree;
    }
    half_.whole = valueOf(parts_[0]);
    const size_t digits = std::min(parts_[0].find('.'), parts_[0].size());
    if (parts_.size() > 1 && (digits > kMostDegrees || half_.degrees > kMostOfLongitude)) {
      return std::nullopt;
    }
    return finished();
  }

  WrittenHalf finished() {
    const auto whole = [](const std::string& digits) { return digits.find('.') == digits.npos; };
    const size_t n = parts_.size();
    half_.minutes = n > 1 ? valueOf(parts_[1]) : 0;
    half_.minutes_over_60 = n > 1 && half_.minutes >= kMinutesOfDegree;
    half_.certain = !touching_ && (n < 2 || (whole(parts_[0]) && !half_.minutes_over_60)) &&
                    (n < 3 || (whole(parts_[1]) && valueOf(parts_[2]) < kMinutesOfDegree));
    const bool minutes = n == 2 && whole(parts_[0]);
    half_.digits = n == 1    ? parts_[0]
                   : minutes ? parts_[0] + " " + parts_[1]
                             : decimal(half_.degrees);
    const bool ours = (n == 1 || minutes) && !half_.sign && !half_.comma && !half_.word &&
                      !half_.small && !half_.letter_first;
    half_.form = ours ? WrittenHalf::Form::Ours : WrittenHalf::Form::Other;
    return half_;
  }

  std::string_view text_;
  size_t at_;
  WrittenHalf half_;
  std::vector<std::string> parts_;
  bool touching_ = false;
};

}  // namespace

std::optional<WrittenHalf> writtenHalf(std::string_view text, size_t at, bool letter_first) {
  return HalfReader(text, at).run(letter_first);
}

std::optional<std::string> positionDigits(std::string_view text) {
  return HalfReader(text, 0).digits();
}

}  // namespace glider::frontend
