// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/way_home.h"

#include "hooks/hookbeh/args.h"
#include "hooks/protocol/nap_times.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/abstract/surfacing.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/context/proof_context.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::slocum::rules {
namespace {

using vehicles::WayHome;

using ir::prove::durationOf;

/// If more states than this differ, only their number is reported: a longer list would not be read.
constexpr size_t kMostStates = 6;

/// The cycles are the longest possible: in the logs of real vehicles, one in 900 is three times as
/// long as `cycle_s`. The last heartbeat is still on the line when the SBC fails.
double letsGoWithin(const platforms::Platform& platform, const Silence& silence) {
  return silence.seconds + 2 * platform.world.tick_gap_s + platform.world.line_lag_s;
}

std::string silentLine(const WayHome& home, const platforms::Platform& platform,
                       const Silence& silence) {
  const std::string lets_go =
      fmt::format("if the SBC stops responding, hookbeh revokes control within {:.0f} s ({})",
                  letsGoWithin(platform, silence), silence.source);
  return std::isfinite(home.depth_m)
             ? fmt::format(
                   "{}; from at most {:.4g} m deep, the vehicle is at the surface within {}",
                   lets_go, home.depth_m, durationOf(home.surface_s))
             : lets_go + "; no bound on the vehicle's depth is known";
}

}  // namespace

Silence usualSilence() {
  return {hooks::HookbehArgs{}.silence_secs,
          fmt::format("assuming silence_secs {:.4g}; see --mi", hooks::HookbehArgs{}.silence_secs)};
}

double napSecsFor(double nap_s) {
  return std::ceil(nap_s + int{kHookAroundNapSecs});
}

Silence usualSilence(const ir::Mission& mission) {
  if (!mission.nap_s) {
    return usualSilence();
  }
  const double silence = hooks::HookbehArgs{}.silence_secs;
  const double nap = napSecsFor(*mission.nap_s);
  return {silence + nap,
          fmt::format("assuming silence_secs {:.4g} and nap_secs {:.4g}; see --mi", silence, nap)};
}

WayHome wayHomeFrom(double depth_m, const platforms::Platform& platform, const Silence& silence) {
  const double lets_go_s = letsGoWithin(platform, silence);
  return {lets_go_s, depth_m,
          lets_go_s + platform.world.turn_s + depth_m / platform.world.slowest_climb_m_s,
          silence.source};
}

std::vector<std::string> wayHomeLines(const ir::WidestWorld& world, const Silence& silence) {
  const auto& [mission, platform] = world;
  const ir::prove::ProofContext context(world);
  const auto depths = ir::prove::deepestByState(context);
  const auto climbs = ir::prove::climbTimes(context);
  const double deepest = std::ranges::max(depths);
  std::vector<std::string> lines = {
      silentLine(wayHomeFrom(deepest, platform, silence), platform, silence)};
  const auto shallower =
      std::ranges::count_if(depths, [&](double depth) { return depth < deepest; });
  if (static_cast<size_t>(shallower) > kMostStates) {
    lines.push_back(fmt::format("  sooner in {} of {} states", shallower, depths.size()));
    return lines;
  }
  for (uint32_t i = 0; i < depths.size(); ++i) {
    if (depths[i] < deepest) {
      const WayHome home = wayHomeFrom(depths[i], platform, silence);
      lines.push_back(fmt::format(
          "  in `{}`: from at most {:.4g} m{}, within {}", mission.states[i].name, home.depth_m,
          std::isfinite(climbs[i]) ? " as its climb begins" : "", durationOf(home.surface_s)));
    }
  }
  return lines;
}

}  // namespace glider::slocum::rules
