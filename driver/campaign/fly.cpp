// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/campaign/fly.h"

#include "driver/campaign/progress_text.h"
#include "driver/campaign/result_json.h"
#include "driver/exit_code.h"
#include "driver/interruption.h"
#include "driver/output/flight_files.h"
#include "driver/output/time_left.h"
#include "driver/terminal.h"
#include "support/counted.h"
#include "support/diagnostics/ids/files.h"
#include "support/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <utility>

namespace glider::driver {
namespace {

/// The table of flights as it grows; without a file name nothing is written.
class FlightsFile {
 public:
  /// Begins it with `content`. GL9002.
  static support::Result<FlightsFile> begin(const std::string& name, const std::string& content) {
    FlightsFile file(name);
    if (!name.empty()) {
      file.out_.open(name, std::ios::trunc);
    }
    auto written = file.add(content);
    return written ? support::Result<FlightsFile>(std::move(file))
                   : std::unexpected(written.error());
  }
  /// Writes `text` through to the operating system, so that it is kept if this program ends in any
  /// way.
  support::Result<void> add(const std::string& text) {
    if (!name_.empty() && !(out_ << text << std::flush)) {
      return support::fail(support::diagnostics::cannotWrite, name_, std::strerror(errno));
    }
    return {};
  }

 private:
  explicit FlightsFile(std::string name) : name_(std::move(name)) {}
  std::string name_;
  std::ofstream out_;
};

/// The file that gets the rows; empty: none.
std::string fileOf(const campaign::CampaignOptions& options) {
  return options.csv.empty() && !options.resume.empty() ? options.resume.front() : options.csv;
}

std::string flightsText(const campaign::CampaignPlan& plan) {
  if (plan.parts == 1) {
    return support::counted(plan.flights, "flight");
  }
  const campaign::FlightRange range = campaign::rangeOf(plan);
  return fmt::format("part {} of {}: {} of {}", plan.part, plan.parts, range.end - range.begin,
                     support::counted(plan.flights, "flight"));
}

int statusOf(const campaign::CampaignResult& result) {
  if (result.interrupted) {
    // mpirun ends ranks by SIGTERM, and another rank may have been the one to receive it.
    return kInterrupted + (Interruption::signal() != 0 ? Interruption::signal() : SIGTERM);
  }
  const bool violated = std::ranges::any_of(result.verdicts, [](const auto& verdict) {
    return verdict && verdict->outcome == simulator::Verdict::Outcome::Violation;
  });
  return violated ? kMissionHasErrors : kFine;
}

/// How many of the flights a flight that hangs has left; empty: none hangs.
std::string whyNotAll(const campaign::CampaignResult& result, std::ptrdiff_t flown) {
  return result.hung ? fmt::format("a flight hangs, so others were not flown: {} of ", flown) : "";
}

/// Prints the result; sorts the file of flights by their numbers.
int tellResult(const campaign::CampaignPlan& plan, const campaign::CampaignOptions& options,
               const campaign::CampaignResult& result, const std::string& identity, double took_s,
               Json* document) {
  if (result.failure) {
    return reportFailure(*result.failure);
  }
  const auto flown = std::ranges::count_if(result.verdicts,
                                           [](const auto& verdict) { return verdict.has_value(); });
  const std::string file = fileOf(options);
  std::string last = fmt::format("{}{}, seed {}, {:.1f} s\n", whyNotAll(result, flown),
                                 flightsText(plan), plan.seed, took_s);
  if (result.interrupted) {
    last = fmt::format("interrupted after {} of {}, seed {}{}\n", flown,
                       support::counted(plan.flights, "flight"), plan.seed,
                       file.empty() ? ""
                                    : "; to continue, give the same options and --resume " +
                                          campaign::shellWord(file));
  }
  if (document != nullptr) {
    putResult(*document, plan, result);
    (*document)["took_s"] = took_s;
  }
  const auto printed =
      document != nullptr
          ? support::Result<void>{}
          : printOut(campaign::campaignTable(plan, result) +
                     campaign::requirementLines(plan, result) +
                     campaign::violationLines(plan, result, campaign::commandOf(options)) + last);
  // A pipe already has the rows, in the order in which the flights ended.
  const auto written =
      file.empty() || !support::isReplaceable(file)
          ? support::Result<void>{}
          : support::writeFileAtomically(file, campaign::campaignCsv(plan, result, identity));
  return !printed   ? reportFailure(printed.error())
         : !written ? reportFailure(written.error())
                    : statusOf(result);
}

}  // namespace

int flyOnly(const campaign::CampaignPlan& plan, const campaign::CampaignOptions& options,
            Json* document) {
  const campaign::CampaignFlight flight = campaign::flightOf(plan, *options.only);
  support::Trace trace;
  const auto verdict = campaign::flyOne(plan, flight, &trace);
  if (!verdict) {
    return reportFailure(verdict.error());
  }
  if (!options.output.empty()) {
    if (auto written = writeFlight(trace, options.output); !written) {
      return reportFailure(written.error());
    }
  }
  const bool violated = verdict->outcome == simulator::Verdict::Outcome::Violation;
  if (document != nullptr) {
    (*document)["flight"] = flightOf(plan, flight, *verdict);
    (*document)["faults"] = campaign::drawnToText(campaign::faultsOf(plan, flight));
    return violated ? kMissionHasErrors : kFine;
  }
  const auto printed = printOut(fmt::format(
      "flight {}: {}, {}, {}, {}, --seed {}\n{}{}\n", flight.number,
      plan.missions[flight.mission].file, simulator::nameOf(flight.kind),
      simulator::nameOf(flight.manner), flight.board ? plan.boards[*flight.board] : "in process",
      flight.seed, campaign::drawnToText(campaign::faultsOf(plan, flight)),
      violated ? fmt::format("VIOLATION at {:.0f} s: {}", verdict->violation_s, verdict->violation)
               : fmt::format("{}, deepest {:.1f} m", campaign::outcomeName(*verdict),
                             verdict->deepest_m)));
  return !printed ? reportFailure(printed.error()) : violated ? kMissionHasErrors : kFine;
}

Flown flyThem(const campaign::CampaignPlan& plan, const campaign::CampaignOptions& options,
              const std::string& identity, campaign::Ranks* ranks, Json* document) {
  campaign::CampaignResult known;
  known.verdicts.resize(plan.flights);
  for (const std::string& file : options.resume) {
    if (auto read = campaign::readCsv(file, plan, identity, known); !read) {
      return {reportFailure(read.error())};
    }
  }
  auto file = FlightsFile::begin(fileOf(options), campaign::campaignCsv(plan, known, identity));
  if (!file) {
    return {reportFailure(file.error())};
  }
  const Interruption interruption;
  ProgressLine line;
  const auto begin = std::chrono::steady_clock::now();
  const campaign::FlightRange range = campaign::rangeOf(plan);
  TimeLeft left;
  const campaign::CampaignListener listener = {
      [&](const campaign::CampaignFlight& flight, const simulator::Verdict& verdict) {
        return file->add(campaign::csvRow(plan, flight, verdict));
      },
      [&](uint64_t over) { line.show(progressText(over, range.end - range.begin, left)); },
      [] { return Interruption::signal() != 0; }};
  const campaign::CampaignResult result = campaign::flyAll(plan, std::move(known), listener, ranks);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  line.clear();
  return {tellResult(plan, options, result, identity, took.count(), document), true, result.running,
          result.left_ranks};
}

}  // namespace glider::driver
