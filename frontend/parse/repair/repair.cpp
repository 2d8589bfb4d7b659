// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/repair/repair.h"

#include "frontend/parse/foreign_characters.h"
#include "frontend/parse/phrases/phrases.h"
#include "frontend/parse/repair/names.h"
#include "frontend/parse/repair/structure.h"
#include "frontend/parse/repair/words.h"
#include "frontend/parse/unit_names.h"

namespace glider::frontend {

Repaired repair(const std::vector<Lexeme>& lexemes, SyntaxReporter& reporter) {
  const Source& source = reporter.source();
  const Rephrased phrases =
      repairPhrases(separateForeign(nameDeclaredUnits(lexemes, source), source), reporter);
  WordRepair words(reporter);
  NameRepair names(reporter);
  const std::vector<Lexeme> clean = names.run(words.run(phrases.lexemes));
  StructureRepair structure(clean, words.cut(), reporter);
  Repaired repaired = structure.run();
  repaired.named = !names.guessed() && phrases.as_meant && !structure.guessed();
  repaired.parseable = repaired.parseable && !words.cut();
  return repaired;
}

}  // namespace glider::frontend
