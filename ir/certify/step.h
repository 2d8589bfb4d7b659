// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/certify/certificate.h"
#include "ir/certify/expressions.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// One step of a flight in SMT-LIB: the start, or time that passes and one tick.
namespace glider::ir::certify {

/// One way in which a step may end.
struct Ending {
  Term condition;
  std::string words;
  std::optional<Configuration> to;  ///< empty: the mission has finished
  bool impossible = false;          ///< must not be reached: a `return` without a caller
  std::vector<Term> values;         ///< of namesIn(to)
  Term violates;                    ///< that this start or tick violates the requirement
  Term well_formed;                 ///< that wellFormed holds of `values`
};

struct Step {
  std::string text;   ///< declarations, definitions and assertions
  Term leaves_range;  ///< that some variable is given a value outside of its range
  std::vector<Ending> endings;
  std::map<uint32_t, Reading> readings;  ///< of the sensors that the tick may read, by number
};

Step startOf(const Setting& setting);
/// The step from `at`, whose names are constants of the text. Everything is assumed to be well
/// formed and variables to be in their declared ranges; nothing else is.
Step stepOf(const Setting& setting, const Configuration& at, double longest_gap_s);

/// "`home`, called by `look`": for the words of obligations.
std::string wordsOf(const Mission& mission, const Configuration& at);

}  // namespace glider::ir::certify
