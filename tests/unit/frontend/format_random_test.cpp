// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Formatted text keeps its AST and its comments, and is not changed by formatting it again.
// What is printed of the AST of the same texts reads back as that AST.

#include "frontend/format/format.h"
#include "tests/unit/frontend/compile.h"

#include <algorithm>
#include <filesystem>
#include <random>

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;
using testing_support::readSource;

/// The comments of a text, found by another way than the formatter's: without blanks and line ends.
std::string commentsOf(const std::string& text) {
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') {
      for (++i; i < text.size() && text[i] != '"'; ++i) {
        i += text[i] == '\\' ? 1U : 0U;
      }
    } else if (text.compare(i, 2, "/*") == 0 || text.compare(i, 2, "//") == 0 || text[i] == '#') {
      const bool block = text.compare(i, 2, "/*") == 0;
      const size_t end =
          std::min(block ? text.find("*/", i + 2) + 2 : text.find_first_of("\r\n", i), text.size());
      std::copy_if(text.begin() + static_cast<ptrdiff_t>(i),
                   text.begin() + static_cast<ptrdiff_t>(end), std::back_inserter(out), [](char c) {
                     return std::string_view(" \t\r\n\f").find(c) == std::string::npos;
                   });
      out += '\n';
      i = end - 1;
    }
  }
  return out;
}

/// False if `text` has errors.
bool expectKept(const std::string& text) {
  FrontendRun first(text);
  const auto once = format(first.sources, first.file, first.diagnostics);
  if (!once) {
    EXPECT_TRUE(first.diagnostics.hasErrors());
    return false;
  }
  FrontendRun second(*once);
  const auto twice = format(second.sources, second.file, second.diagnostics);
  EXPECT_TRUE(twice.has_value()) << second.said() << *once;
  EXPECT_EQ(twice.value_or(""), *once) << text;
  FrontendRun before(text);
  const auto parsed = before.parse();
  EXPECT_TRUE(parsed == second.parse()) << text << *once;
  const std::string printed = ast::print(*parsed);
  EXPECT_TRUE(FrontendRun(printed).parse() == parsed) << text << printed;
  EXPECT_EQ(commentsOf(text), commentsOf(*once)) << text << *once;
  for (const char* wrong : {" \n", "\n\n\n", "\t", "\r"}) {
    // Inside strings and comments a tab may stay.
    const bool tab = *wrong == '\t' && text.find(wrong) != std::string::npos;
    EXPECT_TRUE(tab || once->find(wrong) == std::string::npos) << *once;
  }
  return true;
}

TEST(FormatAll, EveryMissionOfTheProject) {
  size_t missions = 0;
  for (const char* folder : {"missions", "tests/golden"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             std::filesystem::path(GLIDER_SOURCE_DIR) / folder)) {
      if (entry.path().extension() == ".mission") {
        SCOPED_TRACE(entry.path().string());
        const auto text = support::readFile(entry.path());
        ASSERT_TRUE(text.has_value());
        missions += expectKept(*text) ? 1U : 0U;
      }
    }
  }
  EXPECT_GT(missions, 30U);
}

/// Random files of the whole grammar, without regard to meaning, oddly laid out, with comments
/// everywhere.
class RandomText {
 public:
  explicit RandomText(unsigned seed) : random_(seed) {}

  std::string file() {
    word("mission");
    name();
    times(8, [this] { item(); });
    gap();
    return std::move(text_);
  }

 private:
  size_t pick(size_t n) { return random_() % n; }
  bool maybe() { return pick(2) == 0; }
  template <typename F>
  void times(size_t most, F f) {
    for (size_t n = pick(most + 1); n > 0; --n) {
      f();
    }
  }
  template <typename F>
  void list(size_t most, F f) {
    f();
    times(most - 1, [&] {
      word(",");
      f();
    });
  }

  void gap() {
    static const char* const kGaps[] = {
        " ",           "  ",          "\n",         "\n\n",          "\n\n\n \t",
        " # c\n",      "\n# own\n",   " // d \n\n", "\n\n# far\n\n", " /* e */ ",
        "\n/* f */\n", "\n /* g */ ", " /* h */\n", "/* i\n   j */", " # k\n # l\n",
        "\r\n",        "\n//m\n/*n*/"};
    const bool plain = pick(100) >= comments_;
    text_ += plain ? (pick(8) == 0 ? "\n" : " ") : kGaps[pick(std::size(kGaps))];
  }
  void word(const std::string& w) {
    gap();
    text_ += w;
  }
  void any(std::initializer_list<const char*> words) {
    word(*(words.begin() + static_cast<ptrdiff_t>(pick(words.size()))));
  }
  void name() {
    any({"a", "depth", "in", "of", "where", "stack", "long_name_of_a_thing", "within"});
  }
  void anyName() { maybe() ? name() : any({"m", "S", "min", "deg"}); }

  void type() {
    name();
    times(2, [this] { any({"*", "/"}), name(); });
  }
  void formals() {
    word("(");
    if (maybe()) {
      list(4, [this] { anyName(), word(":"), type(); });
    }
    word(")");
  }
  void arguments() {
    word("(");
    if (pick(4) > 0) {
      list(4, [this] {
        expr();
        if (pick(4) == 0) {
          word("of"), name();
        }
      });
    }
    word(")");
  }

  void expr() {
    ++depth_;
    const size_t kind = depth_ > 4 ? pick(4) : pick(10);
    if (kind < 2) {
      any({"5", ".454", "1e3", "true", "39.2 N", "39.2 N 73.9 W", "5 degC/m", "2 m * s", "50%"});
    } else if (kind < 4) {
      name();
    } else if (kind < 5) {
      any({"-", "!"}), word("("), expr(), word(")");
    } else if (kind < 6) {
      any({"f", "min", "of"}), arguments();
    } else if (kind < 7) {
      word("["), list(5, [this] { expr(); }), word("]");
    } else if (kind < 8) {
      name(), word("["), expr(), word("]");
    } else {
      word("("), expr(), word(")"), any({"+", "-", "*", "/", "<", ">=", "==", "&&", "||"}),
          word("("), expr(), word(")");
    }
    --depth_;
  }

  void variable(const char* keyword) {
    word(keyword), anyName(), word(":"), type(), word("="), expr(), range();
  }
  void range() {
    if (maybe()) {
      word("in"), expr(), word(".."), expr();
    }
  }
  void statement() {
    ++blocks_;
    const size_t kind = blocks_ > 3 ? pick(3) : pick(4);
    if (kind == 0) {
      word("set"), name(), word("="), expr();
    } else if (kind == 1) {
      word("log"), word("\"# no \\\" comment\""), times(2, [this] { word(","), expr(); });
    } else if (kind == 2) {
      any({"hover", "ascend"}), arguments();
    } else {
      word("if"), expr(), word("then"), times(2, [this] { statement(); });
      if (maybe()) {
        word("else"), times(2, [this] { statement(); });
      }
      word("end");
    }
    --blocks_;
  }
  void block() {
    word("do"), times(3, [this] { statement(); }), word("end");
  }
  void eventCase() {
    word("case"), expr();
    if (maybe()) {
      block();
    }
    if (maybe()) {
      any({"return", "exit", "stay", "done"});
    } else {
      any({"goto", "call"}), anyName();
      if (maybe()) {
        arguments();
      }
    }
  }
  void use() {
    name();
    if (maybe()) {
      arguments();
    }
  }
  void member() {
    switch (pick(6)) {
      case 0:
        return word("flightroute"), use();
      case 1:
        return word("flightprofile"), use();
      case 2:
        word("sensors");
        return list(9, [this] {
          anyName();
          if (pick(4) == 0) {
            word("every"), expr();
          }
        });
      case 3:
        return variable("var");
      case 4:
        return word("entry"), block();
      default:
        return word("events"), times(4, [this] { eventCase(); });
    }
  }
  void members() {
    word("begin"), times(5, [this] { member(); }), word("end");
  }
  void item() {
    switch (pick(9)) {
      case 0:
        word("const"), anyName(), word("=");
        return expr();
      case 1:
        variable("param");
        return maybe() ? (word("where"), expr()) : void();
      case 2:
        return variable("var");
      case 3:
        word("always"), eventCase();
        return times(2, [this] { eventCase(); });
      case 4:
        word("state"), anyName();
        return maybe() ? formals() : void(), members();
      case 5:
        any({"flightprofile", "flightroute"}), name();
        return maybe() ? formals() : void(), members();
      case 6:
        return external();
      default:
        return requirement();
    }
  }
  void external() {
    word("extern");
    switch (pick(3)) {
      case 0:
        return word("function"), name(), formals(), word(":"), type(), range();
      case 1:
        word("sensor"), name(), word(":"), type(), range();
        return maybe() ? (word("stale"), word("after"), expr()) : void();
      default:
        any({"flightprofile", "flightroute"}), name();
        return maybe() ? (word("reads"), list(3, [this] { name(); })) : void();
    }
  }
  void requirement() {
    word("require");
    switch (pick(6)) {
      case 0:
        return word("always"), expr();
      case 1:
        return word("exit"), word("within"), expr();
      case 2:
        return word("stack"), word("<="), expr();
      case 3:
        return word("reach"), anyName();
      case 4:
        return word("never"), anyName(), word("after"), anyName();
      default:
        return word("surfaces"), word("every"), expr();
    }
  }

  std::mt19937 random_;
  std::string text_;
  size_t depth_ = 0;
  size_t blocks_ = 0;
  size_t comments_ = pick(3) * 15;  ///< gaps of a hundred that are odd
};

TEST(FormatAll, RandomFiles) {
  size_t sound = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    sound += expectKept(RandomText(seed).file()) ? 1U : 0U;
    if (HasFailure()) {
      return;
    }
  }
  EXPECT_GT(sound, 350U) << "the generator writes files with errors";
}

}  // namespace
}  // namespace glider::frontend
