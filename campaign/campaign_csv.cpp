// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/campaign_csv.h"

#include "campaign/campaign_table.h"
#include "support/csv.h"
#include "support/diagnostics/ids/flights.h"
#include "support/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>
#include <string_view>
#include <vector>

namespace glider::campaign {

using simulator::Verdict;

namespace {

constexpr std::string_view kMark = "# glidercc campaign ";
constexpr std::string_view kColumns =
    "flight,mission,fault,when,sbc,seed,outcome,releases,instructions,end (s),deepest (m),"
    "violation (s),violation,requirements violated,"
    "assumptions broken\n";
// Columns that do not follow from the number of a flight.
constexpr size_t kOutcome = 6, kReleases = 7, kInstructions = 8, kEnd = 9, kDeepest = 10,
                 kViolationTime = 11, kViolation = 12, kRequirements = 13, kAssumptions = 14,
                 kCount = 15;

/// The fields of a line, without their quotes.
std::vector<std::string> fieldsOf(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += line[++i];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  return fields;
}

template <typename Number>
bool parse(const std::string& text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

bool parseOutcome(const std::vector<std::string>& fields, Verdict& verdict) {
  for (const auto outcome :
       {Verdict::Outcome::Exited, Verdict::Outcome::Released, Verdict::Outcome::Violation}) {
    verdict.outcome = outcome;
    if (fields[kOutcome] == outcomeName(verdict)) {
      return true;
    }
  }
  return false;
}

/// "1;3", those of numbers `from` to `to`, counted from 1.
std::string numbersText(const Verdict& verdict, size_t from, size_t to) {
  std::string text;
  for (const size_t number : verdict.requirements) {
    if (number >= from && number < to) {
      text += fmt::format("{}{}", text.empty() ? "" : ";", number - from + 1);
    }
  }
  return text;
}

/// The reverse of numbersText; whether there are so many, csvRow decides.
void parseNumbers(const std::string& field, size_t from, Verdict& verdict) {
  std::istringstream in(field);
  for (std::string text; std::getline(in, text, ';');) {
    size_t number = 0;
    if (parse(text, number) && number > 0) {
      verdict.requirements.push_back(from + number - 1);
    }
  }
}

std::unexpected<support::Failure> refuse(const std::string& file, const std::string& why,
                                         const std::string& hint) {
  return support::fail(support::diagnostics::campaignNotResumed, file, why, hint);
}

}  // namespace

std::string csvHead(const std::string& identity) {
  return fmt::format("{}{}\n{}", kMark, identity, kColumns);
}

std::string csvRow(const CampaignPlan& plan, const CampaignFlight& flight, const Verdict& verdict) {
  const bool violated = verdict.outcome == Verdict::Outcome::Violation;
  const auto& mission = plan.missions[flight.mission];
  const size_t required = mission.assumptions_from;
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", flight.number,
                     support::csvQuoted(mission.file), simulator::nameOf(flight.kind),
                     simulator::nameOf(flight.manner),
                     flight.board ? plan.boards[*flight.board] : "in process", flight.seed,
                     outcomeName(verdict), verdict.releases, verdict.instructions, verdict.end_s,
                     verdict.deepest_m, violated ? fmt::to_string(verdict.violation_s) : "",
                     support::csvQuoted(verdict.violation), numbersText(verdict, 0, required),
                     numbersText(verdict, required, mission.requirements.size()));
}

bool parseRow(const CampaignPlan& plan, std::string_view line, uint64_t& number, Verdict& verdict) {
  const std::vector<std::string> fields = fieldsOf(line);
  if (fields.size() != kCount || !parse(fields[0], number) || number >= plan.flights ||
      !parse(fields[kReleases], verdict.releases) ||
      !parse(fields[kInstructions], verdict.instructions) || !parse(fields[kEnd], verdict.end_s) ||
      !parse(fields[kDeepest], verdict.deepest_m) || !parseOutcome(fields, verdict)) {
    return false;
  }
  verdict.violation = fields[kViolation];
  const auto& mission = plan.missions[flightOf(plan, number).mission];
  parseNumbers(fields[kRequirements], 0, verdict);
  parseNumbers(fields[kAssumptions], mission.assumptions_from, verdict);
  if (std::ranges::any_of(verdict.requirements,
                          [&](size_t one) { return one >= mission.requirements.size(); })) {
    return false;
  }
  const bool violated = verdict.outcome == Verdict::Outcome::Violation;
  if (violated && !parse(fields[kViolationTime], verdict.violation_s)) {
    return false;
  }
  // The columns that follow from the number must be in the row.
  return csvRow(plan, flightOf(plan, number), verdict) == std::string(line) + "\n";
}

std::string campaignCsv(const CampaignPlan& plan, const CampaignResult& result,
                        const std::string& identity) {
  std::string out = csvHead(identity);
  for (uint64_t i = 0; i < result.verdicts.size(); ++i) {
    if (result.verdicts[i]) {
      out += csvRow(plan, flightOf(plan, i), *result.verdicts[i]);
    }
  }
  return out;
}

support::Result<void> readCsv(const std::string& file, const CampaignPlan& plan,
                              const std::string& identity, CampaignResult& result) {
  const auto content = support::readFile(file);
  if (!content) {
    return std::unexpected(content.error());
  }
  std::string_view rest = *content;
  if (!rest.starts_with(kMark)) {
    return refuse(file, "it is not the CSV file of a campaign",
                  "give a file that was begun with `--csv`");
  }
  const std::string head = csvHead(identity);
  if (!rest.starts_with(head)) {
    return refuse(file, "it belongs to another campaign",
                  "give the same missions, scenario, seed and options, unchanged, and the same "
                  "glidercc; or begin with `--csv`");
  }
  rest.remove_prefix(head.size());
  for (size_t line = 3; rest.find('\n') != std::string_view::npos; ++line) {
    const size_t end = rest.find('\n');
    uint64_t number = 0;
    Verdict verdict;
    if (!parseRow(plan, rest.substr(0, end), number, verdict)) {
      return refuse(file, fmt::format("line {} is not a flight of this campaign", line),
                    "remove that line: its flight is flown again");
    }
    const CampaignFlight flight = flightOf(plan, number);
    auto& known = result.verdicts[number];
    if (known && csvRow(plan, flight, *known) != csvRow(plan, flight, verdict)) {
      return refuse(
          file,
          fmt::format("line {}: flight {} has another outcome in a file before it", line, number),
          "keep one of the two lines");
    }
    known = std::move(verdict);
    rest.remove_prefix(end + 1);
  }
  return {};
}

}  // namespace glider::campaign
