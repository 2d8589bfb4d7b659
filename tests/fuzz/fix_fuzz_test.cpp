// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `glidercc fix` on correct missions with one slip each: it changes nothing outside the slip, adds
// no error, and is done after one run. GLIDER_FIX_ROUNDS (default 400), GLIDER_FIX_SECONDS and
// GLIDER_FIX_SEED (default 1) set how many missions, for how long and which; GLIDER_FIX_SHOW shows
// examples of missions that have another meaning after the fix than before the slip.

#include "frontend/constructs.h"
#include "frontend/frontend.h"
#include "ir/text/print.h"
#include "ir/verify/verify.h"
#include "platforms/load/load_platform.h"
#include "support/diagnostics/fixes.h"
#include "support/files.h"
#include "tests/fuzz/slips.h"

#include <climits>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

namespace glider::fuzz {
namespace {

using support::Diagnostic;
using support::Severity;

constexpr uint32_t kMission = 0;
constexpr uint32_t kLibrary = 1;

/// Compiles missions for the same vehicle, with the standard library, which is parsed once.
class Reader {
 public:
  Reader()
      : library_text_(*support::readFile(GLIDER_SOURCE_DIR "/missions/library/standard.mission")) {
    auto loaded = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
    platform_ = std::move(*loaded);
    support::SourceManager sources;
    support::DiagnosticEngine diagnostics;
    sources.add("mission", "");
    sources.add("standard.mission", library_text_);
    library_ = *frontend::parse(sources, kLibrary, diagnostics);
  }

  /// The diagnostics; `ir` receives the mission if it has no error.
  std::vector<Diagnostic> read(const std::string& text, std::string* ir = nullptr) const {
    support::SourceManager sources;
    support::DiagnosticEngine diagnostics;
    sources.add("test.mission", text);
    sources.add("standard.mission", library_text_);
    const auto parsed = frontend::parse(sources, kMission, diagnostics);
    const auto mission =
        parsed ? frontend::analyse(*parsed, {platform_, {&library_}, sources}, diagnostics)
               : std::nullopt;
    if (mission && !diagnostics.hasErrors()) {
      ir::verify(*mission, diagnostics);
    }
    if (ir != nullptr && mission && !diagnostics.hasErrors()) {
      *ir = ir::print(*mission);
    }
    return diagnostics.sorted();
  }

 private:
  std::string library_text_;
  platforms::Platform platform_;
  ast::File library_;
};

const Reader& reader() {
  static const Reader one;
  return one;
}

support::FixReader fixReader() {
  return {[](const std::string& text) {
            return support::Result<std::vector<Diagnostic>>(reader().read(text));
          },
          frontend::constructsOf};
}

bool hasErrors(const std::vector<Diagnostic>& diagnostics) {
  return std::ranges::any_of(diagnostics,
                             [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

/// The missions on a page of the documents, without those that show an error.
void addExamples(const std::string& page, std::vector<std::string>& texts) {
  constexpr std::string_view kBegin = "```mission\n";
  for (size_t at = page.find(kBegin); at != std::string::npos; at = page.find(kBegin, at + 1)) {
    const size_t from = at + kBegin.size();
    texts.push_back(page.substr(from, page.find("```", from) - from));
  }
}

/// Correct missions to which there is nothing to fix.
std::vector<std::string> seeds() {
  constexpr size_t kLargest = 5000;
  const std::filesystem::path root(GLIDER_SOURCE_DIR);
  std::vector<std::filesystem::path> paths;
  for (const char* folder : {"missions", "tests/golden", "docs", "support/diagnostics/explain"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      const bool wanted =
          entry.path().extension() == ".mission" || entry.path().extension() == ".md";
      if (wanted && entry.path().filename() != "standard.mission") {
        paths.push_back(entry.path());
      }
    }
  }
  std::ranges::sort(paths);
  std::vector<std::string> texts;
  for (const auto& path : paths) {
    const std::string text = *support::readFile(path.string());
    if (path.extension() == ".md") {
      addExamples(text, texts);
    } else if (text.size() < kLargest) {
      texts.push_back(text.substr(0, text.find("\n//|") + 1));
    }
  }
  std::erase_if(texts, [](const std::string& text) {
    const auto found = reader().read(text);
    return text.empty() || text.find("//@") != std::string::npos || hasErrors(found) ||
           std::ranges::any_of(found, [](const Diagnostic& d) { return !d.fixes.empty(); });
  });
  return texts;
}

/// The part of the text that a fix may change: the lines of the slip, from the token before it to
/// the token after it.
struct Part {
  size_t before = 0;  ///< bytes before it
  size_t after = 0;   ///< bytes after it
};

Part partOf(const Slipped& slipped) {
  size_t begin = slipped.begin;
  size_t end = slipped.end;
  const Tokens tokens(slipped.text);
  size_t earlier = 0;
  size_t later = slipped.text.size();
  for (const Tokens::Token& token : tokens.all()) {
    if (token.end <= slipped.begin) {
      earlier = token.begin;
    } else if (token.begin >= slipped.end) {
      later = token.end;
      break;
    }
  }
  const size_t line = slipped.text.rfind('\n', begin == 0 ? 0 : begin - 1);
  begin = std::min(line == std::string::npos ? 0 : line + 1, earlier);
  end = std::max(std::min(slipped.text.find('\n', end), slipped.text.size()), later);
  return {begin, slipped.text.size() - end};
}

int stageOf(const Diagnostic& d) {
  return static_cast<int>(d.id) / 1000;
}

int firstStage(const std::vector<Diagnostic>& diagnostics) {
  int stage = INT_MAX;
  for (const Diagnostic& d : diagnostics) {
    stage = d.severity == Severity::Error ? std::min(stage, stageOf(d)) : stage;
  }
  return stage;
}

/// What a fix did to a mission that it should not have done; empty: nothing.
std::string damageOf(const Slipped& slipped, const std::vector<Diagnostic>& at_first,
                     const support::Fixing& fixing) {
  const Part part = partOf(slipped);
  for (const support::Fixing::Round& round : fixing.rounds) {
    for (const Diagnostic& d : round.fixed) {
      for (const support::FixIt& fix : d.fixes) {
        const bool inside =
            fix.range.begin >= part.before && fix.range.end + part.after <= round.before.size();
        if (d.severity == Severity::Error && !inside) {
          return fmt::format("{} ({}) changes a place outside the slip", support::code(d.id),
                             d.message);
        }
      }
    }
  }
  const auto last = reader().read(fixing.text);
  std::set<support::DiagnosticId> known;
  for (const Diagnostic& d : at_first) {
    known.insert(d.id);
  }
  for (const Diagnostic& d : last) {
    if (d.severity == Severity::Error && !known.contains(d.id) &&
        stageOf(d) <= firstStage(at_first)) {
      return fmt::format("a new error: {} ({})", support::code(d.id), d.message);
    }
  }
  const auto again = support::fixAll(fixing.text, kMission, fixReader());
  return again->text == fixing.text ? "" : "it changes more when it runs again";
}

struct Counts {
  size_t missions = 0, valid = 0, unfixed = 0, better = 0, restored = 0, other = 0;
  std::map<std::string, std::pair<size_t, std::string>> others;  ///< with an example
};

/// What was fixed, for the table of missions with another meaning.
std::string fixesOf(const std::string& kind, const support::Fixing& fixing) {
  std::string all = kind + ":";
  for (const support::Fixing::Round& round : fixing.rounds) {
    for (const Diagnostic& d : round.fixed) {
      all += " " + support::code(d.id);
    }
  }
  return all;
}

void count(const Slipped& slipped, const std::string& ir, const support::Fixing& fixing,
           const std::string& mission, Counts& counts) {
  std::string after;
  (void)reader().read(fixing.text, &after);
  if (fixing.rounds.empty()) {
    ++counts.unfixed;
  } else if (after.empty()) {
    ++counts.better;
  } else if (after == ir) {
    ++counts.restored;
  } else {
    ++counts.other;
    auto& [times, example] = counts.others[fixesOf(slipped.kind, fixing)];
    ++times;
    if (example.empty()) {
      const size_t line = slipped.text.rfind('\n', slipped.begin) + 1;
      const size_t size = slipped.text.find('\n', slipped.end) - line;
      example = fmt::format("{}\n      {}\n      {}", mission.substr(line, size),
                            slipped.text.substr(line, size), fixing.text.substr(line, size));
    }
  }
}

size_t setting(const char* name, size_t otherwise) {
  const char* value = std::getenv(name);
  return value == nullptr ? otherwise : std::strtoul(value, nullptr, 10);
}

TEST(FixFuzz, NothingOutsideASlipIsChanged) {
  const std::vector<std::string> missions = seeds();
  ASSERT_GT(missions.size(), 100U);
  std::vector<std::string> irs(missions.size());
  for (size_t i = 0; i < missions.size(); ++i) {
    (void)reader().read(missions[i], &irs[i]);
  }
  const size_t rounds = setting("GLIDER_FIX_ROUNDS", 400);
  const auto until =
      std::chrono::steady_clock::now() + std::chrono::seconds(setting("GLIDER_FIX_SECONDS", 3600));
  std::mt19937_64 random(setting("GLIDER_FIX_SEED", 1));
  Counts counts;
  constexpr size_t kMostShown = 20;
  size_t damaged = 0;
  while (counts.missions < rounds && std::chrono::steady_clock::now() < until) {
    const size_t number = random() % missions.size();
    const auto slipped = slip(missions[number], random);
    if (!slipped) {
      continue;
    }
    ++counts.missions;
    const auto found = reader().read(slipped->text);
    if (!hasErrors(found)) {
      ++counts.valid;
      continue;
    }
    const auto fixing = support::fixAll(slipped->text, kMission, fixReader());
    ASSERT_TRUE(fixing.has_value());
    count(*slipped, irs[number], *fixing, missions[number], counts);
    const std::string damage = damageOf(*slipped, found, *fixing);
    if (!damage.empty() && ++damaged <= kMostShown) {
      ADD_FAILURE() << slipped->kind << ": " << damage << "\n--- with the slip\n"
                    << slipped->text << "\n--- fixed\n"
                    << fixing->text;
    }
  }
  EXPECT_EQ(damaged, 0U);
  fmt::print(
      "{} missions with a slip: {} still correct, {} not fixed, {} with fewer errors, {} as before "
      "the slip, {} with another meaning ({:.2f} % of those fixed)\n",
      counts.missions, counts.valid, counts.unfixed, counts.better, counts.restored, counts.other,
      100.0 * static_cast<double>(counts.other) /
          static_cast<double>(std::max<size_t>(1, counts.restored + counts.other)));
  if (std::getenv("GLIDER_FIX_SHOW") != nullptr) {
    for (const auto& [what, times] : counts.others) {
      fmt::print("  {} {}\n      {}\n", times.first, what, times.second);
    }
  }
}

}  // namespace
}  // namespace glider::fuzz
