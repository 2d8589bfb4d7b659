// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/check.h"
#include "analysis/difference/compare_bounds.h"
#include "analysis/difference/compare_missions.h"
#include "analysis/difference/parting.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/json_document.h"
#include "driver/output/check_on_terminal.h"
#include "driver/shared_options.h"
#include "driver/terminal.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace glider::driver {
namespace {

struct DiffOptions {
  bool json = false;
  std::string before, after;
  CheckOptions check;
  bool fly = true;
};

/// A version of the mission; null if it has errors other than violated requirements, or cannot be
/// read: that is then reported.
std::shared_ptr<const compiler::Checked> checkedOf(const CheckedFile& file) {
  if (file.found.failure) {
    reportFailure(*file.found.failure);
    return nullptr;
  }
  if (!file.compilation->checked) {
    reportDiagnostics(file.compilation->diagnostics, *file.compilation->sources);
  }
  return file.compilation->checked;
}

using Verdicts = std::map<std::string, std::string>;

Verdicts verdictsOf(const report::CheckedMission& found) {
  Verdicts verdicts;
  for (const report::JudgedRequirement& one : found.requirements) {
    verdicts[one.text] =
        one.verdict + (one.premise.empty() ? "" : fmt::format(" ({})", one.premise));
  }
  return verdicts;
}

/// The requirements whose verdicts differ.
std::vector<std::string> compareVerdicts(const report::CheckedMission& before,
                                         const report::CheckedMission& after) {
  const Verdicts was = verdictsOf(before);
  const Verdicts is = verdictsOf(after);
  Verdicts all = was;
  all.insert(is.begin(), is.end());
  const auto verdict = [](const Verdicts& verdicts, const std::string& text) {
    const auto found = verdicts.find(text);
    return found == verdicts.end() ? std::string("not required") : found->second;
  };
  std::vector<std::string> lines;
  for (const auto& [text, any] : all) {
    if (verdict(was, text) != verdict(is, text)) {
      lines.push_back(fmt::format("{}: {} → {}", text, verdict(was, text), verdict(is, text)));
    }
  }
  return lines;
}

/// The assumptions that only one version makes.
std::vector<std::string> compareAssumptions(const ir::Mission& before, const ir::Mission& after) {
  std::vector<std::string> lines;
  const auto only = [&](const ir::Mission& in, const ir::Mission& other, const char* word) {
    for (const ir::Assumption& assumption : in.assumptions) {
      if (std::ranges::find(other.assumptions, assumption.words, &ir::Assumption::words) ==
          other.assumptions.end()) {
        lines.push_back(fmt::format("assume {}: {}", assumption.words, word));
      }
    }
  };
  only(before, after, "no longer");
  only(after, before, "new");
  return lines;
}

std::string section(const std::string& title, const std::vector<std::string>& lines) {
  return lines.empty() ? "" : fmt::format("{}\n  {}\n", title, fmt::join(lines, "\n  "));
}

std::string flightText(const analysis::PartingSearch& search) {
  if (search.found) {
    const analysis::Parting& parting = search.parting;
    std::vector<std::string> lines = {
        fmt::format("{}: both do the same until {:.6g} s, in `{}`", parting.flight,
                    parting.mission_time, parting.state),
        "old: " + parting.old_does, "new: " + parting.new_does};
    if (!parting.readings.empty()) {
      lines.push_back(fmt::format("readings then: {}", fmt::join(parting.readings, ", ")));
    }
    return section("a flight on which they part", lines);
  }
  return search.random == 0
             ? "not flown: the missions need code in C, or are for different vehicles\n"
             : fmt::format(
                   "no flight was found on which they part: {} simulated, {} with random "
                   "readings\n",
                   search.flights, search.random);
}

Json flightJson(const analysis::PartingSearch& search) {
  Json flight = {{"simulated", search.flights}, {"random", search.random}, {"found", search.found}};
  if (search.found) {
    const analysis::Parting& parting = search.parting;
    flight["flight"] = parting.flight;
    flight["mission_time_s"] = parting.mission_time;
    flight["state"] = parting.state;
    flight["old"] = parting.old_does;
    flight["new"] = parting.new_does;
    flight["readings"] = parting.readings;
  }
  return flight;
}

/// All differences of two versions, in the sections in which they are shown.
struct Differences {
  std::vector<std::string> names;
  std::vector<analysis::DifferentPart> parts;
  std::vector<std::string> bounds, assumptions, requirements;
  std::optional<analysis::PartingSearch> search;
};

std::string textOf(const Differences& found) {
  std::string text = section("names", found.names);
  for (const analysis::DifferentPart& part : found.parts) {
    text += section(part.title, part.lines);
  }
  return text + section("bounds", found.bounds) + section("assumptions", found.assumptions) +
         section("requirements", found.requirements) +
         (found.search ? flightText(*found.search) : "") +
         (found.parts.empty() ? "no difference in behaviour\n" : "");
}

void put(Json& document, const Differences& found) {
  document["same"] = found.parts.empty();
  document["names"] = found.names;
  document["parts"] = Json::array();
  for (const analysis::DifferentPart& part : found.parts) {
    document["parts"].push_back({{"title", part.title}, {"lines", part.lines}});
  }
  document["bounds"] = found.bounds;
  document["assumptions"] = found.assumptions;
  document["requirements"] = found.requirements;
  document["flight"] = found.search ? flightJson(*found.search) : Json();
}

/// Prints what differs, or puts it into the document; returns the exit code.
int tellDifference(const DiffOptions& options, const CheckedFile& before, const CheckedFile& after,
                   Json* document) {
  const auto was = checkedOf(before);
  const auto is = checkedOf(after);
  if (!was || !is) {
    return kWorldFailed;
  }
  const analysis::MissionDifference difference = analysis::compareMissions(*was, *is);
  Differences found{difference.renamed,
                    difference.parts,
                    analysis::compareBounds(*was, *is),
                    compareAssumptions(was->mission(), is->mission()),
                    compareVerdicts(before.found, after.found),
                    std::nullopt};
  const bool same = difference.parts.empty();
  if (!same && options.fly) {
    auto search =
        analysis::searchParting(compiler::optimise(was), compiler::optimise(is), difference);
    if (!search) {
      return reportFailure(search.error());
    }
    found.search = std::move(*search);
  }
  if (document != nullptr) {
    put(*document, found);
  } else if (auto printed = printOut(textOf(found)); !printed) {
    return reportFailure(printed.error());
  }
  return same ? kFine : kMissionHasErrors;
}

int diff(const DiffOptions& options, Json* document) {
  const CheckedFile before = checkOnTerminal(options.before, options.check);
  const CheckedFile after = checkOnTerminal(options.after, options.check);
  return tellDifference(options, before, after, document);
}

}  // namespace

void addDiffCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<DiffOptions>();
  CLI::App* command = app.add_subcommand(
      "diff", "Show what differs in behaviour between two versions of a mission");
  command->add_option("OLD", options->before, "The mission file of the old version")->required();
  command->add_option("NEW", options->after, "The mission file of the new version")->required();
  command->add_flag_callback(
      "--no-flights", [options] { options->fly = false; },
      "Do not look for a flight on which the two part");
  acceptNoCache(*command);
  command->footer(
      "Exit codes: 0 no difference in behaviour, 1 they differ, 2 usage error, a mission with "
      "errors, or a file failed.");
  addFormatOption(*command, options->json);
  command->callback([options, &status] {
    status =
        inFormat(options->json, "diff", [&](Json* document) { return diff(*options, document); });
  });
}

}  // namespace glider::driver
