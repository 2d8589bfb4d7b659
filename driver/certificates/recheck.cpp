// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/certificates/recheck.h"

#include "analysis/certificates/recheck.h"
#include "driver/compile_for_flight.h"
#include "driver/exit_code.h"
#include "driver/terminal.h"
#include "support/counted.h"
#include "support/files.h"
#include "support/one_line.h"
#include "vehicles/vehicle.h"

#include <fmt/format.h>

#include <string>
#include <system_error>

namespace glider::driver {
namespace {

using support::Result;

/// The line of one requirement, and whether its certificate is accepted.
struct Line {
  std::string text;
  bool accepted = false;
};

Result<Line> rechecked(const compiler::Optimised& mission, uint32_t number,
                       const std::filesystem::path& folder) {
  const ir::Requirement& requirement = mission.checked->mission().requirements[number];
  const std::string words = support::onOneLine(mission.checked->sources().text(requirement.range));
  const auto path = compiler::certificatePath(folder, number);
  std::error_code error;
  if (!std::filesystem::exists(path, error) && !error) {
    return Line{fmt::format("no certificate: {}\n", words), false};
  }
  const auto text = support::readFile(path);
  if (!text) {
    return std::unexpected(text.error());
  }
  const auto certificate = compiler::certificateFromJson(*text, path.string(), *mission.checked);
  if (!certificate) {
    return std::unexpected(certificate.error());
  }
  const auto found = analysis::recheck(*certificate, mission, number);
  if (!found) {
    return std::unexpected(found.error());
  }
  if (!found->accepted) {
    return Line{fmt::format("refused: {}\n  {}\n", words, found->reason), false};
  }
  const std::string shown =
      certificate->run
          ? fmt::format("a run of {}, replayed on the compiled mission",
                        support::counted(found->obligations, "tick"))
          : fmt::format("{}, {} met",
                        support::counted(certificate->invariants.size(), "configuration"),
                        support::counted(found->obligations, "obligation"));
  ir::prove::RequirementVerdict rests;
  rests.assumptions = found->assumptions;
  const std::string premises = ir::prove::premisesOf(rests, mission.checked->mission());
  return Line{
      fmt::format("accepted: {}\n  by {}: {}\n{}", words, ir::prove::word(certificate->method),
                  shown, premises.empty() ? "" : fmt::format("  {}\n", premises)),
      true};
}

/// The mission on a vehicle that flies its own mission of the file.
Result<compiler::Optimised> obeyedAsIn(const std::string& own_mission,
                                       const compiler::Optimised& mission) {
  support::SourceManager sources;
  const auto own = vehicles::vehicleOfFile(own_mission).read_own_mission(own_mission, sources, {});
  if (!own) {
    return std::unexpected(own.error());
  }
  return compiler::optimise(
      compiler::onVehicle(*mission.checked, [&](platforms::Platform& vehicle) {
        (*own)->widen(vehicle, mission.checked->mission().resume_within_s);
      }));
}

}  // namespace

int recheckCertificates(const std::string& path, const std::filesystem::path& folder,
                        const std::string& own_mission) {
  int status = kFine;
  const auto written = compileForFlight(path, status);
  if (status != kFine) {
    return status;
  }
  const auto mission = own_mission.empty() ? Result<compiler::Optimised>(*written)
                                           : obeyedAsIn(own_mission, *written);
  if (!mission) {
    return reportFailure(mission.error());
  }
  const size_t all = mission->checked->mission().requirements.size();
  size_t accepted = 0;
  for (uint32_t i = 0; i < all; ++i) {
    const auto line = rechecked(*mission, i, folder);
    if (!line) {
      return reportFailure(line.error());
    }
    accepted += line->accepted ? 1U : 0U;
    if (const auto printed = printOut(line->text); !printed) {
      return reportFailure(printed.error());
    }
  }
  tell(fmt::format("{}: {} of {} accepted, checked with {}\n", path, accepted,
                   support::counted(all, "certificate"), analysis::kSolver));
  return accepted == all ? kFine : kMissionHasErrors;
}

}  // namespace glider::driver
