// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/spelling.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

namespace glider::frontend {
namespace {

constexpr size_t kLongestWord = 64;

constexpr std::pair<std::string_view, std::string_view> kUnitWords[] = {
    {"meter", "m"},      {"meters", "m"},      {"metre", "m"},      {"metres", "m"},
    {"kilometer", "km"}, {"kilometers", "km"}, {"kilometre", "km"}, {"kilometres", "km"},
    {"nm", "nmi"},       {"feet", "ft"},       {"foot", "ft"},      {"sec", "s"},
    {"secs", "s"},       {"second", "s"},      {"seconds", "s"},    {"mins", "min"},
    {"minute", "min"},   {"minutes", "min"},   {"hr", "h"},         {"hrs", "h"},
    {"hour", "h"},       {"hours", "h"},       {"d", "day"},        {"degree", "deg"},
    {"degrees", "deg"},  {"degs", "deg"},      {"radian", "rad"},   {"radians", "rad"},
    {"c", "degC"},       {"celsius", "degC"},  {"degreec", "degC"}, {"degc", "degC"},
    {"knot", "kn"},      {"knots", "kn"},      {"kts", "kn"},       {"bars", "bar"},
    {"decibar", "dbar"}, {"db", "dbar"},       {"volt", "V"},       {"volts", "V"},
    {"v", "V"},          {"amp", "A"},         {"amps", "A"},       {"watt", "W"},
    {"watts", "W"},      {"w", "W"},           {"joule", "J"},      {"joules", "J"},
    {"percent", "%"},    {"mps", "m/s"}};

constexpr std::string_view kUnits[] = {
#define UNIT(spelling, dim, to_si) spelling,
#include "support/units/units.def"
#undef UNIT
};

}  // namespace

std::string inLowerCase(std::string_view word) {
  std::string out(word);
  std::ranges::transform(out, out.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> before(b.size() + 1);
  std::vector<size_t> row(b.size() + 1);
  std::vector<size_t> next(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) {
    row[j] = j;
  }
  for (size_t i = 1; i <= a.size(); ++i) {
    next[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t change = row[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      next[j] = std::min({row[j] + 1, next[j - 1] + 1, change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        next[j] = std::min(next[j], before[j - 2] + 1);
      }
    }
    before.swap(row);
    row.swap(next);
  }
  return row[b.size()];
}

std::string_view closest(std::string_view word, const std::vector<std::string_view>& candidates) {
  if (word.size() > kLongestWord) {
    return {};
  }
  const std::string wanted = inLowerCase(word);
  // A third of the letters may be wrong: with more, unrelated words would be suggested.
  size_t best = std::max<size_t>(word.size() / 3, word.size() > 1 ? 1 : 0) + 1;
  std::string_view found;
  for (std::string_view candidate : candidates) {
    if (candidate.size() > kLongestWord) {
      continue;
    }
    const size_t distance = editDistance(wanted, inLowerCase(candidate));
    if (distance < best && distance < candidate.size()) {
      best = distance;
      found = candidate;
    }
  }
  return found;
}

std::string_view related(std::string_view word, const std::vector<std::string_view>& candidates) {
  constexpr size_t kShortest = 3;   // `lat` of `latitude`
  constexpr size_t kShortWord = 4;  // `hover` of `hover_at`
  const std::string wanted = inLowerCase(word);
  std::string_view found;
  for (const std::string_view candidate : candidates) {
    const std::string name = inLowerCase(candidate);
    const bool within = name.size() >= kShortest && name.size() < wanted.size() &&
                        (wanted.starts_with(name) || wanted.ends_with("_" + name));
    const bool around = wanted.size() >= kShortWord && name.starts_with(wanted + "_");
    if ((within || around) && candidate.size() > found.size()) {
      found = candidate;
    }
  }
  return found;
}

Suggestion didYouMean(std::string_view word, const std::vector<std::string_view>& candidates,
                      std::string otherwise) {
  const std::string wanted = inLowerCase(word);
  std::set<std::string_view> same;
  for (const std::string_view candidate : candidates) {
    if (inLowerCase(candidate) == wanted) {
      same.insert(candidate);
    }
  }
  std::string_view found = closest(word, candidates);
  const bool near = !found.empty() && editDistance(wanted, inLowerCase(found)) <= 1;
  // Of `latitude`, `lat` is nearer than `altitude`: the first letter is seldom wrong.
  const bool begins = near && inLowerCase(found)[0] == wanted[0];
  if (const std::string_view other = related(word, candidates); !begins && !other.empty()) {
    found = other;
  }
  Suggestion suggestion;
  suggestion.hint =
      found.empty() ? std::move(otherwise) : "did you mean `" + std::string(found) + "`?";
  // With capitals in the name itself, its definition may be what is wrong.
  const bool certain = same.size() == 1 && *same.begin() == wanted;
  suggestion.fix = certain ? wanted : "";
  return suggestion;
}

bool mayBeThousands(std::string_view before, std::string_view after) {
  constexpr size_t kGroup = 3;
  return after.size() == kGroup && !before.empty() && before.size() <= kGroup &&
         before.front() != '0';
}

std::string_view unitForWord(std::string_view word) {
  const std::string wanted = inLowerCase(word);
  const auto* found =
      std::ranges::find(kUnitWords, wanted, [](const auto& row) { return row.first; });
  if (found != std::end(kUnitWords)) {
    return found->second;
  }
  for (std::string_view unit : kUnits) {
    if (inLowerCase(unit) == wanted) {
      return unit;
    }
  }
  return {};
}

}  // namespace glider::frontend
