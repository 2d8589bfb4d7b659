// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/brief/summary.h"

#include "analysis/brief/in_words.h"
#include "analysis/brief/written.h"
#include "ir/prove/context/duration_text.h"
#include "ir/worlds/naps.h"
#include "support/listed.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace glider::analysis {
namespace {

using ir::prove::durationOf;

/// As a sentence.
std::string sentence(std::string text) {
  if (!text.empty()) {
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    text += ".";
  }
  return text;
}

std::string verdicts(const report::CheckedMission& found) {
  const auto count = [&](const char* verdict) {
    return std::ranges::count(found.requirements, verdict, &report::JudgedRequirement::verdict);
  };
  if (found.requirements.empty()) {
    return "The mission states no requirements.";
  }
  std::vector<std::string> parts;
  for (const auto& [verdict, words] :
       {std::pair("refuted", "violated"), std::pair("undecided", "undecided"),
        std::pair("proved", "proved")}) {
    if (count(verdict) > 0) {
      parts.push_back(fmt::format("{} {}", count(verdict), words));
    }
  }
  const size_t all = found.requirements.size();
  return fmt::format("Of {} requirement{}: {}.", all, all == 1 ? "" : "s", support::listed(parts));
}

std::string warnings(const report::CheckedMission& found) {
  const auto count = std::ranges::count(found.diagnostics, support::Severity::Warning,
                                        &support::Diagnostic::severity);
  return count == 0 ? ""
                    : fmt::format("There {} {} warning{}, listed below.", count == 1 ? "is" : "are",
                                  count, count == 1 ? "" : "s");
}

std::string depth(const platforms::Platform& platform, double deepest_m) {
  if (!std::isfinite(deepest_m)) {
    return "No bound on the depth is known.";
  }
  return fmt::format(
      "The commands lead at most {:.4g} m deep, which includes an overshoot of up to "
      "{:.4g} m when the vehicle turns.",
      deepest_m, platform.envelope.inflection_overshoot_m);
}

std::string stack(const compiler::Checked& checked) {
  const size_t waiting = checked.facts.stack_depth;
  if (waiting == 0) {
    return "No state calls another.";
  }
  std::vector<std::string> path;
  for (const ir::StateId id : checked.facts.deepest_path) {
    path.push_back(inCode(checked.mission()[id].name));
  }
  return fmt::format("At most {} state{} wait{} on the call stack ({}).", waiting,
                     waiting == 1 ? "" : "s", waiting == 1 ? "s" : "", fmt::join(path, " calls "));
}

std::string wayHome(const compiler::Checked& checked, const vehicles::OwnMission& own,
                    double deepest_m) {
  const vehicles::WayHome home = own.wayHomeFrom(deepest_m, checked.worlds.written);
  const std::string source = home.source.substr(0, home.source.find("; see"));  // no options
  const std::string takes_over =
      fmt::format("If the payload computer (SBC) fails, the vehicle {} within {}", home.lets_go,
                  durationOf(home.lets_go_s));
  return std::isfinite(home.surface_s)
             ? fmt::format("{} and is at the surface within {}, from at most {:.4g} m ({}).",
                           takes_over, durationOf(home.surface_s), home.depth_m, source)
             : fmt::format("{} ({}); when it is at the surface is not known.", takes_over, source);
}

std::string powerCuts(const ir::Mission& mission) {
  const std::string after_restart =
      mission.new_after_restart
          ? " If the vehicle has restarted its own mission meanwhile, it keeps control too."
          : "";
  return fmt::format(
      "After a power cut of the payload computer, the mission continues if its program keeps "
      "checkpoints and runs again within {} of the newest, which is at most 20 s old{}; later, the "
      "vehicle keeps control.{}",
      durationOf(mission.resume_within_s),
      mission.nap_s ? fmt::format(", in a nap up to {} older", durationOf(*mission.nap_s)) : "",
      after_restart);
}

std::string naps(const ir::Mission& mission) {
  return mission.nap_s
             ? fmt::format(
                   "The payload computer sleeps for up to {} at a time, where nothing that is "
                   "foreseen can change what the mission does; what it decides at the end of a nap "
                   "comes up to {:.0f} s later, and its log then has all ticks.",
                   durationOf(*mission.nap_s), ir::kNapLag_s)
             : "";
}

std::string batteries(const ir::Mission& mission) {
  if (!mission.pack) {
    return "";
  }
  constexpr double kCoulombs = 3600;
  return fmt::format(
      "It counts on batteries of {:.6g} Ah at {:.6g} V{}: with new ones, the vehicle's count of "
      "the charge begins at 0.",
      mission.pack->capacity_C / kCoulombs, mission.pack->voltage_V,
      mission.pack->reserve > 0
          ? fmt::format(", {:.6g} % of them as a reserve", mission.pack->reserve * 100)
          : "");
}

}  // namespace

std::vector<std::string> summaryOf(const compiler::Checked& checked,
                                   const report::CheckedMission& found,
                                   const vehicles::OwnMission* own, double deepest_m) {
  std::vector<std::string> all = {verdicts(found), warnings(found)};
  for (const report::Remark& remark : found.remarks) {
    if (remark.subject == report::Remark::Subject::End) {
      all.push_back(sentence(remark.text));
    }
  }
  all.push_back(depth(checked.platform(), deepest_m));
  all.push_back(stack(checked));
  all.push_back(own == nullptr
                    ? "What the vehicle does if the payload computer (SBC) fails is not known."
                    : wayHome(checked, *own, deepest_m));
  all.push_back(powerCuts(checked.mission()));
  all.push_back(naps(checked.mission()));
  all.push_back(batteries(checked.mission()));
  std::erase(all, "");
  return all;
}

std::string assumptionsOf(const platforms::Platform& platform, const ir::Mission& mission) {
  const platforms::Envelope& envelope = platform.envelope;
  const platforms::EnvironmentModel& world = platform.world;
  const std::string usual = fmt::format(
      "All bounds and proofs hold for any readings in the sensors' ranges and for a vehicle that "
      "gets control at {:.4g} m or above, sinks and climbs at most at {:.4g} m/s, climbs at {:.4g} "
      "m/s or faster from {:.4g} s after the command, overshoots a target depth by at most {:.4g} "
      "m, and reads its depth with an error of at most {:.4g} m; which moves through the water at "
      "most at {:.4g} m/s, in a current of at most {:.4g} m/s, and drifts at the surface at most "
      "at {:.4g} m/s. A command takes effect within {:.4g} s. Ticks of the mission are at most "
      "{:.4g} s apart, except in a power cut of up "
      "to {}.",
      world.start_depth_m, envelope.vertical_rate_m_s, world.slowest_climb_m_s, world.turn_s,
      envelope.inflection_overshoot_m, world.depth_error_m, world.through_water_m_s,
      envelope.drift_m_s, world.surface_drift_m_s,
      world.line_lag_s + envelope.cycle_s + world.command_delay_s, world.tick_gap_s,
      durationOf(mission.resume_within_s));
  std::string own;
  const bool unwatched = !std::ranges::all_of(mission.assumptions, &ir::Assumption::isWatched);
  for (const ir::Assumption& assumption : mission.assumptions) {
    own += fmt::format("{}`{}`", own.empty() ? "" : ", ", assumption.words);
  }
  return own.empty()
             ? usual
             : fmt::format(
                   "{} The mission itself assumes {}. Each verdict names those on "
                   "which it rests, and holds for flights that keep to them. The first tick that "
                   "breaks one leaves a note in the mission log{}.",
                   usual, own,
                   unwatched ? "; nothing on board watches the start and the current" : "");
}

}  // namespace glider::analysis
