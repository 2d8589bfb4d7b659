// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/phrases/choices/clauses.h"
#include "frontend/parse/phrases/phrase.h"
#include "support/source_range.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glider::frontend::phrases {

/// The word that leads a part, and its type.
std::string_view leadOf(Part part);
uint32_t leadType(Part part);

/// A line `choose`, whose errors are reported one by one. What was meant is put in its place.
class ChoiceLine {
 public:
  explicit ChoiceLine(Phrase& phrase) : phrase_(phrase) {}

  /// The tokens of the line; 0: nothing in it is wrong, or it is none.
  size_t repair();

 private:
  [[nodiscard]] bool lacksName() const;
  size_t reportLackOfName();
  bool readName();
  bool reportVerb();
  void reportName();
  void reportArray();
  void reportNames();
  void reportClauses(bool typed);
  void reportClause(const Clause& clause);
  void reportType(const Clause& clause);
  void reportRange(const Clause& clause);
  void reportList(const Clause& clause);
  bool reportValues(const Clause& clause);
  void reportLaunch(const Clause& clause);
  void reportWithoutType();
  void reportWithoutRange();
  bool reportOrder();
  void reportRest();
  void put();
  void putClause(const Clause& clause);
  void putRange(const Clause& clause);

  [[nodiscard]] const Clause* find(Part part) const;
  [[nodiscard]] std::string text(const Clause& clause) const;
  [[nodiscard]] std::string sorted() const;
  [[nodiscard]] std::string_view unitType() const;
  [[nodiscard]] std::string evenly(const Clause& clause) const;
  [[nodiscard]] bool endsLine() const;
  [[nodiscard]] size_t end() const { return clauses_.empty() ? after_name_ : clauses_.back().end; }
  [[nodiscard]] support::SourceRange range(size_t first, size_t end) const {
    return phrase_.source().range(phrase_.whole(first, end - first));
  }

  Phrase& phrase_;
  size_t name_ = 1;        ///< the first token of the name
  size_t name_end_ = 2;    ///< past its last
  size_t after_name_ = 2;  ///< past what stands where a name should
  std::string named_;      ///< the name that was meant
  std::vector<Clause> clauses_;
  size_t values_end_ = 0;  ///< past a list of values without brackets; 0: there is none
  bool as_meant_ = true;
};

}  // namespace glider::frontend::phrases
