// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/findings/against.h"
#include "support/diagnostics/diagnostic.h"
#include "support/result.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// What `glidercc check` found, as data for editors and CI.
namespace glider::report {

/// A finding that is not an error but useful to know; its range is empty if it is about the whole
/// mission.
struct Remark {
  enum class Subject : uint8_t { Other, End, WayHome };
  support::SourceRange range;
  std::string text;
  Subject subject = Subject::Other;
};

/// Whether a flight of the simulator violates a refuted requirement.
struct FlightSearch {
  size_t flights = 0;    ///< flights that were flown
  std::string scenario;  ///< of the last flight, if it violates the requirement; otherwise empty
  uint64_t seed = 0;
  double when_s = 0;  ///< mission time
};

/// A `require` of the mission, and its verdict.
struct JudgedRequirement {
  support::SourceRange range;
  std::string text;                         ///< as written
  std::string verdict;                      ///< "proved", "refuted" or "undecided"
  std::optional<FlightSearch> closed_loop;  ///< of a refuted requirement, if it was searched for
  std::string premise = {};                 ///< the assumptions of its proof; may be empty
  std::string reason = {};                  ///< why it is undecided; may be empty
};

/// An upper bound of what a mission needs; `name` is its key in JSON.
struct Quantity {
  std::string name;
  std::optional<uint64_t> value;  ///< empty: no bound is known
  std::optional<uint64_t> limit;  ///< how much is available; empty: not stated
  std::string unit;
  std::string remark;  ///< what is counted, or why there is no bound
};

/// What a mission needs of a board, or of the lines to the vehicle.
struct Budget {
  std::string of;  ///< the board's name, or "lines"
  std::vector<Quantity> quantities;
};

/// One mission that was checked.
struct CheckedMission {
  std::string path;                                 ///< as the user named it
  const support::SourceManager* sources = nullptr;  ///< of all ranges; null if there is a failure
  std::vector<support::Diagnostic> diagnostics;     ///< in the order to be shown
  std::optional<support::Failure> failure;  ///< an I/O or system error: the check is incomplete
  std::string mission;                      ///< its name; empty if there are errors
  std::vector<std::string> states;
  std::vector<std::string> deepest_path;  ///< the states of a deepest call stack
  std::vector<Remark> remarks;
  std::vector<JudgedRequirement> requirements;  ///< empty if there are errors of another kind
  std::vector<Budget> budgets;
  std::vector<AgainstLogs> against;  ///< one for each vehicle, if asked for

  /// Whether it is free of errors, and all of it could be checked.
  [[nodiscard]] bool ok() const;
};

/// Returns the explanation of a diagnostic in Markdown: a heading `# GL2007: title`, then its text.
using ExplainPage = std::function<std::string(support::DiagnosticId)>;

/// "58,436 of 131,072 bytes".
std::string amount(const Quantity& quantity);
/// A key in words: "tick instructions" of "tick_instructions".
std::string spoken(std::string name);

/// The budgets as a table for people, one line for each quantity.
std::string budgetTable(const CheckedMission& mission);

/// The result of a search in words: "a simulated flight violates it too: …".
std::string searchInWords(const FlightSearch& search);

/// One JSON document with a member for each mission; docs/guide.md shows it.
std::string findingsToJson(const std::vector<CheckedMission>& missions, const std::string& version);

/// One SARIF 2.1.0 log (OASIS standard) with one run. Rules are the diagnostics that were reported,
/// each with its page as help. Columns count Unicode code points from 1. An I/O or system error is
/// a notification of the tool and makes the execution unsuccessful. `exit_code` is the exit code of
/// the command.
std::string findingsToSarif(const std::vector<CheckedMission>& missions, const std::string& version,
                            const ExplainPage& page, int exit_code);

}  // namespace glider::report
