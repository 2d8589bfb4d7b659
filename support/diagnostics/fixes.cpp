// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/diagnostics/fixes.h"

#include "support/word_byte.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace glider::support {
namespace {

/// Insertions at the same place touch, because their order would be a guess.
bool touch(const FixIt& a, const FixIt& b) {
  return a.range.begin <= b.range.end && b.range.begin <= a.range.end;
}

bool fits(const std::vector<FixIt>& chosen, const FixIt& fix, std::string_view text,
          uint32_t file) {
  return fix.range.file == file && fix.range.begin <= fix.range.end &&
         fix.range.end <= text.size() &&
         std::ranges::none_of(chosen, [&fix](const FixIt& other) { return touch(fix, other); });
}

/// What `fix` writes into `text`, apart from the words beside it: a word for `{` in `{depth` does
/// not become one with `depth`.
std::string apart(const FixIt& fix, std::string_view text) {
  std::string written = fix.replacement;
  const std::string_view removed = text.substr(fix.range.begin, fix.range.end - fix.range.begin);
  if (written.empty() || removed.empty()) {
    return written;
  }
  if (isWordByte(written.back()) && !isWordByte(removed.back()) && fix.range.end < text.size() &&
      isWordByte(text[fix.range.end])) {
    written += ' ';
  }
  if (isWordByte(written.front()) && !isWordByte(removed.front()) && fix.range.begin > 0 &&
      isWordByte(text[fix.range.begin - 1])) {
    written.insert(0, 1, ' ');
  }
  return written;
}

bool isSpaceOrTab(char c) {
  return c == ' ' || c == '\t';
}

/// The bytes that a deletion also takes, from `begin` on: one of the blanks on both sides of it, or
/// those before it at the end of a line.
SourceRange withBlanks(const FixIt& fix, std::string_view text, uint32_t begin) {
  SourceRange range = fix.range;
  if (!fix.replacement.empty() || range.begin == range.end) {
    return range;
  }
  const bool line_ends = range.end == text.size() || text[range.end] == '\n';
  if (line_ends) {
    while (range.begin > begin && isSpaceOrTab(text[range.begin - 1])) {
      --range.begin;
    }
  } else if (range.begin > 0 && isSpaceOrTab(text[range.begin - 1]) &&
             isSpaceOrTab(text[range.end])) {
    ++range.end;
  }
  return range;
}

/// The number of errors of each stage.
using Errors = std::array<size_t, 3>;

constexpr size_t kPerStage = 1000;  // GL1xxx is syntax

bool isSyntax(const Diagnostic& d) {
  return static_cast<size_t>(d.id) / kPerStage == 1;
}

Errors errorsOf(const std::vector<Diagnostic>& diagnostics) {
  Errors errors{};
  for (const Diagnostic& diagnostic : diagnostics) {
    const size_t stage = static_cast<size_t>(diagnostic.id) / kPerStage;
    errors[std::clamp<size_t>(stage, 1, errors.size()) - 1] +=
        diagnostic.severity == Severity::Error ? 1U : 0U;
  }
  return errors;
}

/// Which fixes are automatic: those of errors that follow from no other.
class Choice {
 public:
  Choice(uint32_t file, const std::vector<Diagnostic>& diagnostics, const Constructs& constructs)
      : file_(file), constructs_(constructs) {
    for (const Diagnostic& d : diagnostics) {
      if (d.severity == Severity::Error) {
        errors_ = true;
        if (d.range.file == file) {
          places_.emplace(d.range.begin, d.id);
          if (isSyntax(d)) {
            syntax_.insert(d.range.begin);
          }
        }
      }
    }
  }

  [[nodiscard]] bool automatic(const Diagnostic& d) const {
    if (d.fixes.empty()) {
      return false;
    }
    if (d.severity != Severity::Error) {
      return !errors_;
    }
    if (d.range.file != file_) {
      return false;
    }
    const bool structural =
        std::ranges::any_of(d.fixes, [this](const FixIt& fix) { return changesStructure(fix); });
    if (structural && places_.at(d.range.begin) != d.id) {
      return false;  // the first error at this place says what is wrong there
    }
    const uint32_t first = beginOf(d, structural ? constructs_.items : constructs_.parts);
    // What analysis found cannot be the cause of an error in the syntax.
    const bool follows =
        isSyntax(d) ? syntaxIn(first, d.range.begin) : errorIn(first, d.range.begin);
    return !follows && !errorInHeader(d) && !isHalfRead(d);
  }

 private:
  /// Where the construct begins that contains the diagnostic and its fixes.
  [[nodiscard]] static uint32_t beginOf(const Diagnostic& d, const std::vector<uint32_t>& begins) {
    uint32_t place = d.range.begin;
    for (const FixIt& fix : d.fixes) {
      place = std::min(place, fix.range.begin);
    }
    return beginAt(place, begins);
  }

  [[nodiscard]] static uint32_t beginAt(uint32_t place, const std::vector<uint32_t>& begins) {
    const auto after = std::ranges::upper_bound(begins, place);
    return after == begins.begin() ? 0 : *std::prev(after);
  }

  [[nodiscard]] bool errorIn(uint32_t from, uint32_t to) const {
    const auto next = places_.lower_bound(from);
    return next != places_.end() && next->first < to;
  }

  [[nodiscard]] bool syntaxIn(uint32_t from, uint32_t to) const {
    const auto next = syntax_.lower_bound(from);
    return next != syntax_.end() && *next < to;
  }

  /// A wrong header makes everything in its item doubtful.
  [[nodiscard]] bool errorInHeader(const Diagnostic& d) const {
    const uint32_t item = beginAt(d.range.begin, constructs_.items);
    const auto part = std::ranges::upper_bound(constructs_.parts, item);
    const uint32_t end = part == constructs_.parts.end() ? UINT32_MAX : *part;
    return errorIn(item, std::min(end, d.range.begin));
  }

  /// Whether a name or value is doubtful because something else in its part could not be read.
  [[nodiscard]] bool isHalfRead(const Diagnostic& d) const {
    if (isSyntax(d)) {
      return false;
    }
    const uint32_t part = beginAt(d.range.begin, constructs_.parts);
    const auto next = std::ranges::upper_bound(constructs_.parts, d.range.begin);
    const uint32_t end = next == constructs_.parts.end() ? UINT32_MAX : *next;
    const auto syntax = syntax_.lower_bound(part);
    return syntax != syntax_.end() && *syntax < end;
  }

  [[nodiscard]] bool changesStructure(const FixIt& fix) const {
    const auto word = std::ranges::lower_bound(constructs_.words, fix.range.begin + 1, {},
                                               &Constructs::Word::end);
    const bool replaces = word != constructs_.words.end() && word->begin < fix.range.end;
    constexpr std::string_view kBlank = " \n";
    std::string_view written = fix.replacement;
    written.remove_prefix(std::min(written.find_first_not_of(kBlank), written.size()));
    written = written.substr(0, written.find_first_of(kBlank));
    return replaces ||
           std::ranges::find(constructs_.structure, written) != constructs_.structure.end();
  }

  uint32_t file_;
  const Constructs& constructs_;
  bool errors_ = false;
  std::map<uint32_t, DiagnosticId> places_;  ///< of errors in the file, with the first of each
  std::set<uint32_t> syntax_;                ///< of those that are syntax
};

/// One text after another, each with fewer errors.
class Rounds {
 public:
  Rounds(std::string text, uint32_t file, const FixReader& reader) : file_(file), reader_(reader) {
    fixing_.text = std::move(text);
  }

  Result<Fixing> run() {
    constexpr size_t kMostRounds = 100;
    auto first = reader_.check(fixing_.text);
    if (!first) {
      return std::unexpected(first.error());
    }
    now_ = std::move(*first);
    while (fixing_.rounds.size() < kMostRounds) {
      const auto moved = round();
      if (!moved) {
        return std::unexpected(moved.error());
      }
      if (!*moved) {
        break;
      }
    }
    return std::move(fixing_);
  }

 private:
  /// False if nothing was changed. If all fixes together do not leave fewer errors, each is tried
  /// alone.
  Result<bool> round() {
    const Constructs constructs = reader_.constructs(fixing_.text);
    FixedText all = applyFixes(fixing_.text, file_, now_, constructs);
    if (all.fixed.empty()) {
      return false;
    }
    if (const auto kept = keep(all); !kept || *kept || all.fixed.size() == 1) {
      return kept;
    }
    for (const Diagnostic& one : std::vector(all.fixed)) {
      std::vector<Diagnostic> alone = now_;
      for (Diagnostic& other : alone) {
        if (other.range.begin != one.range.begin || other.id != one.id) {
          other.fixes.clear();
        }
      }
      FixedText single = applyFixes(fixing_.text, file_, alone, constructs);
      if (const auto kept = keep(single); !kept || *kept) {
        return kept;
      }
    }
    return false;
  }

  Result<bool> keep(FixedText& next) {
    auto then = reader_.check(next.text);
    if (!then) {
      return std::unexpected(then.error());
    }
    const Errors before = errorsOf(now_);
    const Errors after = errorsOf(*then);
    const bool fewer = after < before || (before == Errors{} && after == Errors{});
    if (!fewer || next.fixed.empty()) {
      fixing_.refused = true;
      return false;
    }
    fixing_.rounds.push_back({std::move(fixing_.text), std::move(next.fixed)});
    fixing_.text = std::move(next.text);
    now_ = std::move(*then);
    return true;
  }

  uint32_t file_;
  const FixReader& reader_;
  Fixing fixing_;
  std::vector<Diagnostic> now_;
};

}  // namespace

FixedText applyFixes(std::string_view text, uint32_t file,
                     const std::vector<Diagnostic>& diagnostics, const Constructs& constructs) {
  FixedText result{std::string(text), {}};
  const Choice choice(file, diagnostics, constructs);
  std::vector<FixIt> chosen;
  for (const Diagnostic& diagnostic : diagnostics) {
    const bool fitting = choice.automatic(diagnostic) &&
                         std::ranges::all_of(diagnostic.fixes, [&](const FixIt& fix) {
                           return fits(chosen, fix, text, file);
                         });
    if (fitting) {
      chosen.insert(chosen.end(), diagnostic.fixes.begin(), diagnostic.fixes.end());
      result.fixed.push_back(diagnostic);
    }
  }
  std::ranges::sort(chosen, {}, [](const FixIt& fix) { return fix.range.begin; });
  std::string fixed;
  uint32_t done = 0;  // bytes of the text that are in it, or gone
  for (const FixIt& fix : chosen) {
    const SourceRange range = withBlanks(fix, text, done);
    fixed += text.substr(done, range.begin - done);
    fixed += apart(fix, text);
    done = range.end;
  }
  if (!chosen.empty()) {
    result.text = fixed + std::string(text.substr(done));
  }
  return result;
}

Result<Fixing> fixAll(std::string text, uint32_t file, const FixReader& reader) {
  return Rounds(std::move(text), file, reader).run();
}

}  // namespace glider::support
