// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The table from which alternatives are chosen (frontend/parse/prediction_table.h) chooses what
// ANTLR's parser chooses by itself. A wrong choice would not be seen in an AST: the parser would
// only start again in its slow mode.

#include "frontend/parse/prediction_table.h"

#include "support/files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

namespace glider::frontend {
namespace {

using antlr4::atn::ParserATNSimulator;
using antlr4::atn::PredictionMode;
using grammar::GliderParser;

/// ANTLR's own choice, compared with the table's.
class ComparedChoices final : public ParserATNSimulator {
 public:
  ComparedChoices(GliderParser& reader, LexemeStream& tokens, size_t& choices)
      : ParserATNSimulator(&reader, reader.getATN(),
                           reader.getInterpreter<ParserATNSimulator>()->decisionToDFA,
                           reader.getInterpreter<ParserATNSimulator>()->getSharedContextCache()),
        table_(reader, tokens),
        choices_(choices) {
    setPredictionMode(PredictionMode::SLL);
    table_.setPredictionMode(PredictionMode::SLL);
  }

  size_t adaptivePredict(antlr4::TokenStream* input, size_t decision,
                         antlr4::ParserRuleContext* context) override {
    const size_t expected = ParserATNSimulator::adaptivePredict(input, decision, context);
    EXPECT_EQ(table_.adaptivePredict(input, decision, context), expected)
        << "decision " << decision << " at byte " << input->LT(1)->getStartIndex();
    ++choices_;
    return expected;
  }

 private:
  PredictionTable table_;
  size_t& choices_;
};

/// The number of choices in `text`, all compared.
size_t choicesIn(const std::string& text) {
  const std::vector<Lexeme> lexemes = lex(text, 0);
  LexemeStream tokens(lexemes);
  GliderParser parser(&tokens);
  parser.removeErrorListeners();
  parser.setErrorHandler(std::make_shared<antlr4::BailErrorStrategy>());
  size_t choices = 0;
  parser.setInterpreter(new ComparedChoices(parser, tokens, choices));  // the parser owns it
  try {
    parser.file();
  } catch (const antlr4::ParseCancellationException&) {
    // At what repair joins to one token: `3 uM`. The choices before it are compared.
  }
  return choices;
}

TEST(PredictionTable, ChoosesAsAntlrDoesInAllMissions) {
  const std::filesystem::path root = GLIDER_SOURCE_DIR;
  size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "missions")) {
    if (entry.path().extension() == ".mission") {
      SCOPED_TRACE(entry.path().string());
      const auto text = support::readFile(entry.path());
      ASSERT_TRUE(text.has_value());
      EXPECT_GT(choicesIn(*text), 0U);
      ++files;
    }
  }
  EXPECT_GT(files, 10U);
}

/// Operators choose by how tightly those around them bind.
TEST(PredictionTable, ChoosesAsAntlrDoesBetweenOperators) {
  std::string text = "mission m\n";
  for (const char* a : {"+", "*", "<", "&&", "||", "/", "-"}) {
    for (const char* b : {"-", "/", ">=", "&&", "||", "*", "+"}) {
      text += std::string("const x = -1 ") + a + " 2 " + b + " !a(3, b = 4) " + a + " 5 N 6 E\n";
    }
  }
  EXPECT_GT(choicesIn(text), 500U);
}

}  // namespace
}  // namespace glider::frontend
