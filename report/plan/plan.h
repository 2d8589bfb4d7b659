// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// What `glidercc plan` found, as data, and what it shows of it.
namespace glider::report {

/// What a mission leaves open.
struct PlanChoice {
  std::string name;
  size_t values = 0;            ///< how many can be chosen
  std::string lowest, highest;  ///< of them, as the mission writes them: "60 m"
  std::string before;           ///< what is written now; empty: nothing
};

/// A part of what is preferred.
struct PlanObjective {
  std::string text;      ///< "greatest hours", "endurance"
  std::string quantity;  ///< "hours", "energy at most": over a column, beside an axis
  std::string unit;      ///< "h", "Wh"; may be empty
  std::string until;     ///< of energy, what a score is of: "until the mission ends"; else empty
};

/// One way to settle all that is open.
struct PlanOption {
  std::vector<std::string> values;  ///< of the choices, as the mission writes them
  std::vector<double> scores;       ///< of the objectives, in their units
};

/// Why some ways were not chosen.
struct PlanRefusal {
  std::string reason;   ///< "`require …` stays undecided"
  size_t ways = 0;      ///< how many
  std::string example;  ///< "bottom = 60 m, hours = 44 h: it may take 71 Wh": the best of them
};

struct Plan {
  std::string path;
  std::string mission;
  std::vector<PlanChoice> choices;
  std::vector<PlanObjective> objectives;  ///< the most important first
  size_t ways = 0;                        ///< how many there are to choose
  size_t possible = 0;                    ///< of them without errors in the text
  size_t warnings = 0;                    ///< of a check of the chosen one
  size_t promises = 0;                    ///< requirements of the mission
  std::optional<PlanOption> chosen;       ///< empty: none can be proved
  /// Those that no other beats in all that is preferred, the chosen one first; all are proved.
  std::vector<PlanOption> front;
  bool whole_front = true;  ///< false: it may have more
  std::vector<PlanRefusal> refused;
};

/// For people, of several lines.
std::string planText(const Plan& plan);
/// The front as an SVG: the first objective to the right, the second upwards. There are at least
/// two objectives, and something was chosen.
std::string planPicture(const Plan& plan);
/// "61.2 Wh", "44 h".
std::string scoreText(const PlanObjective& objective, double score);

}  // namespace glider::report
