// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_proofs/tally.h"

#include <fmt/format.h>

#include <iterator>

namespace glider::random_proofs {

void Tally::add(const std::string& kind, const ir::prove::RequirementVerdict& verdict) {
  Verdicts& row = requirements[kind];
  switch (verdict.verdict) {
    case ir::prove::Verdict::Proved:
      ++row.proved;
      row.assuming += verdict.assumptions.empty() ? 0U : 1U;
      break;
    case ir::prove::Verdict::Refuted:
      ++row.refuted;
      break;
    case ir::prove::Verdict::Open:
      ++row.undecided;
      break;
  }
}

std::string Tally::text() const {
  std::string text = fmt::format("missions {}, flights {}, ticks {}, restarts {}, begun again {}\n",
                                 missions, flights, ticks, restarts, begun_again);
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{:<16}{:>9}{:>9}{:>10}{:>10}{:>11}\n", "requirements", "proved", "watched",
                 "assuming", "refuted", "undecided");
  for (const auto& [kind, row] : requirements) {
    fmt::format_to(out, "{:<16}{:>9}{:>9}{:>10}{:>10}{:>11}\n", kind, row.proved, row.met,
                   row.assuming, row.refuted, row.undecided);
  }
  fmt::format_to(out, "{:<16}{:>9}{:>9}\n", "findings", "made", "watched");
  for (const auto& [code, row] : findings) {
    fmt::format_to(out, "{:<16}{:>9}{:>9}\n", code, row.watched, row.met);
  }
  return text;
}

}  // namespace glider::random_proofs
