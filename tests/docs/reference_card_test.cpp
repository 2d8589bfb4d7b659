// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// docs/reference-card.md beside the compiler's own lists: every name of the lists is on the card,
// and what the card has of functions, profiles, routes, commands and options is in the lists.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <cctype>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

std::string source(const std::string& path) {
  return slurp(std::string(GLIDER_SOURCE_DIR) + "/" + path);
}

/// All matches of the first group.
std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  std::vector<std::string> found;
  const std::regex expression(pattern);
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at) {
    found.push_back((*at)[1].str());
  }
  return found;
}

const std::string& card() {
  static const std::string text = source("docs/reference-card.md");
  return text;
}

/// The text between backticks.
std::vector<std::string> codeOf(const std::string& text) {
  return matches(text, "`([^`\n]+)`");
}

/// Whether a word is on the card, as code.
bool isOnCard(const std::string& word) {
  static const std::vector<std::string> code = codeOf(card());
  const auto isLetter = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
  };
  for (const std::string& piece : code) {
    for (size_t at = piece.find(word); at != std::string::npos; at = piece.find(word, at + 1)) {
      const size_t after = at + word.size();
      const bool begins = at == 0 || !isLetter(piece[at - 1]) || !isLetter(word.front());
      const bool ends = after == piece.size() || !isLetter(piece[after]) || !isLetter(word.back());
      if (begins && ends) {
        return true;
      }
    }
  }
  return false;
}

/// The table of the card with this heading.
std::string tableOf(const std::string& heading) {
  const size_t begin = card().find("| " + heading + " |");
  EXPECT_NE(begin, std::string::npos) << heading;
  return card().substr(begin, card().find("\n\n", begin) - begin);
}

std::set<std::string> callsIn(const std::string& heading) {
  std::set<std::string> calls;
  for (const std::string& code : codeOf(tableOf(heading))) {
    if (std::regex_match(code, std::regex("\\w+(\\(.*\\))?"))) {
      calls.insert(code);
    }
  }
  return calls;
}

/// "clamp(x, lowest, highest)", of each function.
std::set<std::string> functions() {
  std::set<std::string> calls;
#define FUNCTION(name, op, what, ...) calls.insert(#name "(" #__VA_ARGS__ ")");
#define FREE_FUNCTION(name, op, what, ...) calls.insert(#name "(" #__VA_ARGS__ ")");
#define EARTH_FUNCTION(name, use, what) calls.insert(use);
#define PLACE_FUNCTION(name, use, what) calls.insert(use);
#define SPAN_FUNCTION(name, use, what) calls.insert(use);
#define WINDOW_FUNCTION(name, kind, use, what) calls.insert(use);
#define LEG_FUNCTION(name, kind, use, what) calls.insert(use);
#define HEADING_FUNCTION(name, use, what) calls.insert(use);
#include "frontend/sema/names/functions.def"
  return calls;
}

/// "yo(top, bottom, dive, climb)", of each profile, or each route, of the library.
std::set<std::string> library(const std::string& kind) {
  std::set<std::string> calls;
  const std::string text = source("missions/library/standard.mission");
  const std::regex declaration("\n" + kind + " (\\w+)(\\(([^)]*)\\))?");
  for (std::sregex_iterator at(text.begin(), text.end(), declaration), end; at != end; ++at) {
    const std::string without_types = std::regex_replace(
        (*at)[3].str(), std::regex(": *\\w+(/\\w+)?( = \\w+)?(\\s+in [^,)]*)?"), "");
    const std::string names = std::regex_replace(without_types, std::regex(",\\s+"), ", ");
    calls.insert((*at)[1].str() + (names.empty() ? "" : "(" + names + ")"));
  }
  return calls;
}

std::set<std::string> commands() {
  std::set<std::string> calls;
  for (const std::string& row :
       matches(source("ir/core/commands.def"), "(COMMAND\\(\\w+, \".*)\n")) {
    std::string names;
    for (const std::string& name : matches(row, "PARAMETER\\((\\w+),")) {
      names += (names.empty() ? "" : ", ") + name;
    }
    // A position is one argument of the language.
    names = names == "latitude, longitude" ? "where" : names;
    if (row.find("_at\"") != std::string::npos) {
      continue;  // of a vehicle with a propeller, where missions write them without that ending
    }
    calls.insert(matches(row, "\"(\\w+)\", \"").at(0) + "(" + names + ")");
  }
  return calls;
}

TEST(ReferenceCard, HasTheFunctionsProfilesRoutesAndCommands) {
  EXPECT_EQ(callsIn("functions"), functions());
  EXPECT_EQ(callsIn("profiles"), library("flightprofile"));
  EXPECT_EQ(callsIn("routes"), library("flightroute"));
  EXPECT_EQ(callsIn("commands, in own profiles and routes"), commands());
  EXPECT_GE(commands().size(), 7U);
  EXPECT_GE(library("flightprofile").size(), 10U);
}

TEST(ReferenceCard, HasEveryWordOfTheLanguage) {
  const auto words = matches(source("grammar/GliderLexer.g4"), "\n[A-Z_]+ : '([a-z]+)' ;");
  EXPECT_GE(words.size(), 70U);
  for (const std::string& word : words) {
    EXPECT_TRUE(isOnCard(word)) << word;
  }
}

TEST(ReferenceCard, HasEveryUnitTypeAndName) {
  std::vector<std::string> names;
#define UNIT(name, dimension, factor) names.emplace_back(name);
#include "support/units/units.def"
#undef UNIT
  for (const std::string& name :
       matches(source("frontend/sema/names/values.def"), "\nVALUE\\((\\w+),")) {
    names.push_back(name);
  }
  for (const std::string& name :
       matches(source("support/units/dimensions.def"), "\nDIMENSION\\((\\w+),")) {
    names.push_back(name);
  }
  for (const std::string& name : matches(source("ir/core/ops.def"), "\nCLOCK\\(\\w+, \"(\\w+)\"")) {
    names.push_back(name);
  }
  const std::string states =
      matches(source("platforms/slocum.toml"), "\nstates = \\[(.*)\\]").at(0);
  for (const std::string& name : matches(states, "\"(\\w+)\"")) {
    names.push_back(name);
  }
  EXPECT_GE(names.size(), 50U);
  for (const std::string& name : names) {
    EXPECT_TRUE(isOnCard(name)) << name;
  }
}

TEST(ReferenceCard, HasEverySubcommandAndNoOptionThatIsNone) {
  const std::string help = runShell("$GLIDERCC --help").out;
  const std::string list = help.substr(help.find("Subcommands:"));
  const auto subcommands = matches(list, "\n  ([a-z]+)  ");
  EXPECT_GE(subcommands.size(), 15U);
  const std::string table = tableOf("command line");
  for (const std::string& command : subcommands) {
    EXPECT_NE(table.find("`glidercc " + command), std::string::npos) << command;
  }
  int options = 0;
  std::string command;
  for (const std::string& code : codeOf(table)) {
    const auto named = matches(code, "^glidercc (\\w+)");
    command = named.empty() ? command : named[0];
    for (const std::string& option : matches(code, "^(--?[a-z-]+)")) {
      ++options;
      const std::string text = runShell("$GLIDERCC help " + command).out;
      EXPECT_TRUE(std::regex_search(text, std::regex("(^|[\\s,])" + option + "[\\s,=]")))
          << command << " " << option;
    }
  }
  EXPECT_GE(options, 30);
}

/// The states of hookbeh on the page for the dock.
TEST(OnMyGlider, HasTheStatesOfHookbeh) {
  const std::string page = source("docs/on-my-glider.md");
  const std::string list = source("hooks/protocol/values.def");
  const std::regex state("\nHOOK_STATE\\((\\w+), ([1-9])\\)");
  int states = 0;
  for (std::sregex_iterator at(list.begin(), list.end(), state), end; at != end; ++at, ++states) {
    const std::string row = "| " + (*at)[2].str() + " | " + (*at)[1].str() + " |";
    EXPECT_NE(page.find(row), std::string::npos) << row;
  }
  EXPECT_EQ(states, 5);
}

}  // namespace
}  // namespace glider::tests
