// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/choices/clauses.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/phrases/written_type.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

// The line `pack 168 Ah at 14.4 V reserve 20 %`, as pilots write it.

namespace glider::frontend::phrases {
namespace {

/// A number with its unit, as written.
struct Amount {
  size_t first = 0;
  size_t tokens = 0;  ///< 0: there is none
  std::string text;
  std::string_view type;
  bool word = false;  ///< of its unit another repair reports what is meant: `volts`
};

/// The unit that was meant by the words from token `k` on, and their number: `amp hours` is `Ah`.
struct UnitWord {
  size_t tokens = 0;
  std::string unit;
};

UnitWord unitAt(const Phrase& phrase, size_t k) {
  if (const size_t words = tokensOfOne(phrase, k, {"amp hours", "amp hour", "ampere hours"})) {
    return {words, "Ah"};
  }
  if (tokensOfOne(phrase, k, {"amphr", "amphrs", "amph"}) > 0) {
    return {1, "Ah"};
  }
  if (const size_t words = tokensOfOne(phrase, k, {"watt hours", "watt hour"})) {
    return {words, "Wh"};
  }
  if (!phrase.text(k).empty() && !typeOfUnit(phrase.text(k)).empty()) {
    return {1, std::string(phrase.text(k))};
  }
  const std::string_view unit = phrase.says(k, "percent") ? "%" : unitForWord(phrase.text(k));
  return {unit.empty() ? size_t{0} : size_t{1}, std::string(unit)};
}

Amount amountAt(const Phrase& phrase, size_t k) {
  if (phrase.type(k) != GliderLexer::NUMBER) {
    return {};
  }
  const UnitWord unit = phrase.startsLine(k + 1) ? UnitWord{} : unitAt(phrase, k + 1);
  return {k, 1 + unit.tokens,
          unit.tokens == 0 ? std::string(phrase.text(k))
                           : fmt::format("{} {}", phrase.text(k), unit.unit),
          typeOfUnit(unit.unit),
          unit.tokens == 1 && unit.unit != phrase.text(k + 1) &&
              (!unitForWord(phrase.text(k + 1)).empty() || unit.unit == "%")};
}

/// A line whose parts are all numbers. It is read as far as its parts are known.
class PackLine {
 public:
  explicit PackLine(Phrase& phrase) : phrase_(phrase) {}

  /// The tokens of the line; 0: it is right, or something else.
  size_t repair() {
    const bool right = phrase_.type() == GliderLexer::PACK;
    k_ = 1;
    if (!right && phrase_.type(1) != GliderLexer::NUMBER) {
      return 0;
    }
    signs({":", "=", "("});
    one_ = read();
    if (one_.tokens == 0 || phrase_.startsLine(1)) {
      return 0;
    }
    between();
    two_ = read();
    readReserve();
    signs({")"});
    if (!phrase_.startsLine(k_) || (!right && two_.tokens == 0)) {
      return 0;
    }
    return two_.tokens == 0 ? reportVoltage() : report();
  }

 private:
  Amount read() {
    const Amount one = phrase_.startsLine(k_) ? Amount{} : amountAt(phrase_, k_);
    k_ += one.tokens;
    return one;
  }

  void signs(std::initializer_list<std::string_view> texts) {
    for (const std::string_view text : texts) {
      k_ += !phrase_.startsLine(k_) && phrase_.text(k_) == text ? 1U : 0U;
    }
  }

  /// `at`, and what stands for it.
  void between() {
    signs({","});
    if (!phrase_.startsLine(k_)) {
      k_ += tokensOfOne(phrase_, k_, {"at", "of", "with", "and", "x"});
      signs({"@", "*", "/"});
    }
  }

  /// `reserve 20 %`, `, with a reserve of 20 %`, `20 % reserve`.
  void readReserve() {
    const size_t before = k_;
    signs({","});
    if (phrase_.startsLine(k_)) {
      k_ = before;
      return;
    }
    k_ += tokensOfOne(phrase_, k_, {"with a", "with", "and"});
    const size_t word = wordOfReserve();
    k_ += word;
    signs({"=", ":"});
    k_ += tokensOfOne(phrase_, k_, {"of"});
    reserve_ = read();
    const size_t after = word == 0 && reserve_.tokens > 0 ? wordOfReserve() : 0;
    k_ += after;
    if (reserve_.tokens == 0 || (word == 0 && after == 0)) {
      reserve_ = {};
      k_ = before;
    }
  }

  [[nodiscard]] size_t wordOfReserve() const {
    return phrase_.startsLine(k_) ? 0
                                  : tokensOfOne(phrase_, k_,
                                                {"reserve", "reserved", "keep", "keeping", "leave",
                                                 "spare", "margin"});
  }

  /// `pack 168 Ah`.
  size_t reportVoltage() {
    if (reserve_.tokens == 0 &&
        oneOf(phrase_.type(k_ - 1), {GliderLexer::AT, GliderLexer::COMMA})) {
      return 0;
    }
    const Lexeme capacity = phrase_.whole(one_.first, one_.tokens);
    const std::string rest = reserve_.tokens == 0 ? "" : fmt::format(" reserve {}", reserve_.text);
    phrase_.reporter()
        .at(capacity, support::diagnostics::unexpectedToken,
            fmt::format("`at` and the voltage after `{}`", phrase_.source().text(capacity)),
            describe(phrase_.source(), phrase_.token(one_.first + one_.tokens)))
        .hint(fmt::format("write for example `pack {} at 14.4 V{}`", one_.text, rest));
    phrase_.notAsMeant();
    put();
    return k_;
  }

  size_t report() {
    const bool turned = one_.type == "voltage" && (two_.type == "charge" || two_.type == "energy");
    const Amount& capacity = turned ? two_ : one_;
    const Amount& voltage = turned ? one_ : two_;
    const std::string rest = reserve_.tokens == 0 ? "" : fmt::format(" reserve {}", reserve_.text);
    const std::string better = fmt::format("pack {} at {}{}", capacity.text, voltage.text, rest);
    const size_t wrong = firstWrong(better);
    if (wrong == k_ || (reserve_.tokens > 0 && reserve_.type != "number")) {
      return 0;
    }
    const Lexeme found =
        turned && wrong == one_.first ? phrase_.whole(wrong, one_.tokens) : phrase_.token(wrong);
    auto report = phrase_.reporter().at(found, support::diagnostics::unexpectedToken,
                                        expected(wrong, turned), describe(phrase_.source(), found));
    report.hint(fmt::format("write `{}`", better));
    const bool certain =
        (capacity.type == "charge" || capacity.type == "energy") && voltage.type == "voltage";
    if (certain) {
      report.fix(phrase_.source().range(phrase_.whole(0, k_)), better);
    }
    phrase_.notAsMeant();
    put();
    return k_;
  }

  /// What the line would have at its token `wrong`.
  [[nodiscard]] std::string_view expected(size_t wrong, bool turned) const {
    const size_t past = one_.first + one_.tokens;
    if (wrong == 0) {
      return "`pack`";
    }
    if (wrong < past) {
      return turned ? "a charge" : wrong == one_.first + 1 ? "a unit" : "a charge and a voltage";
    }
    return wrong <= two_.first ? "`at`" : "`reserve` and a share";
  }

  /// Whether token `k` is the unit of a number, in other letters.
  [[nodiscard]] bool isUnitWord(size_t k) const {
    return std::ranges::any_of(std::array{&one_, &two_, &reserve_}, [&](const Amount* amount) {
      return amount->word && k == amount->first + 1;
    });
  }

  /// The first token that is not in `better`; the end of the line if all are.
  [[nodiscard]] size_t firstWrong(std::string_view better) const {
    for (size_t k = 0; k < k_; ++k) {
      const std::string_view text = phrase_.text(k);
      if (isUnitWord(k)) {
        better.remove_prefix(std::min(better.find(' '), better.size()));
        better.remove_prefix(std::min(better.find_first_not_of(' '), better.size()));
        continue;
      }
      if (!better.starts_with(text)) {
        return k;
      }
      better.remove_prefix(text.size());
      better.remove_prefix(std::min(better.find_first_not_of(' '), better.size()));
    }
    return k_;
  }

  /// The line that was meant; its numbers are not read.
  void put() {
    const Lexeme number = phrase_.token(one_.first);
    phrase_.put({GliderLexer::PACK, phrase_.token().begin, phrase_.token().end});
    phrase_.put(number);
    phrase_.insert(GliderLexer::AT);
    phrase_.put(number);
  }

  Phrase& phrase_;
  size_t k_ = 0;  ///< past what was read
  Amount one_;
  Amount two_;
  Amount reserve_;
};

}  // namespace

size_t pack(Phrase& phrase) {
  const std::string_view text = phrase.text();
  const bool word = text == "pack" || text == "packs" || text == "battery" || text == "batteries";
  return word && mayBeginItem(phrase) ? PackLine(phrase).repair() : 0;
}

}  // namespace glider::frontend::phrases
