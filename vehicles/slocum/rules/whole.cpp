// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/whole.h"

#include "hooks/client/client.h"
#include "hooks/hookbeh/hull.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/context/proof_context.h"
#include "vehicles/slocum/rules/aborts.h"
#include "vehicles/slocum/rules/layers.h"
#include "vehicles/slocum/rules/settings.h"
#include "vehicles/slocum/rules/way_up.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>

namespace glider::slocum::rules {
namespace {

using slocum::BehaviourBlock;

const BehaviourBlock* blockOf(const slocum::MissionFile& vehicle, std::string_view name) {
  const auto found = std::ranges::find(vehicle.behaviours, name, &BehaviourBlock::name);
  return found == vehicle.behaviours.end() ? nullptr : &*found;
}

/// Puts together what happens when control has ended; each ending is a sum of parts.
class Endings {
 public:
  Endings(const slocum::MissionFile& vehicle, const platforms::Platform& platform, double deepest_m,
          bool naps)
      : vehicle_(vehicle),
        platform_(platform),
        naps_(naps),
        layers_(layersOf(vehicle, platform)),
        hookbeh_(std::ranges::find(layers_, Role::Hookbeh, &Layer::role)) {
    all_.deepest_m = deepest_m;
  }

  Whole all() && {
    const BehaviourBlock* hookbeh = blockOf(vehicle_, "hookbeh");
    if (hookbeh == nullptr || std::ranges::count(layers_, Role::Hookbeh, &Layer::role) > 1) {
      unproved("any loss of control", hookbeh_ == layers_.end() ? nullptr : &*hookbeh_,
               hookbeh == nullptr ? "the mission file has no `hookbeh`"
                                  : "the mission file has more than one `hookbeh`",
               "write one behaviour `hookbeh`");
      return std::move(all_);
    }
    if (const auto setting = doubtfulSetting(vehicle_, platform_)) {
      all_.endings.push_back(
          {"any loss of control", {}, "", setting->why, setting->change, setting->range});
      return std::move(all_);
    }
    findDeepest(*hookbeh);
    leftByTheSbc(*hookbeh);
    maskedFromAbove();
    addAborts(vehicle_, layers_, platform_, all_.deepest_m, all_.endings);
    return std::move(all_);
  }

 private:
  void unproved(std::string after, const Layer* of, std::string why, std::string change) {
    all_.endings.push_back({std::move(after),
                            {},
                            "",
                            std::move(why),
                            std::move(change),
                            of != nullptr ? of->range : support::SourceRange{}});
  }

  /// hookbeh climbs below its own max_depth, for any command of the mission. Control may begin
  /// below that.
  void findDeepest(const BehaviourBlock& hookbeh) {
    const double limit = std::min(hookbeh.value("max_depth"), platform_.envelope.greatest_depth_m);
    all_.deepest_m = std::min(all_.deepest_m, std::max(limit, platform_.world.start_depth_m) +
                                                  platform_.envelope.inflection_overshoot_m);
    for (const Layer& layer : layers_) {
      if (layer.role == Role::Flies && layer.deepest_m && *layer.deepest_m > 0) {
        all_.deepest_m =
            std::max(all_.deepest_m, *layer.deepest_m + platform_.envelope.inflection_overshoot_m);
      }
    }
  }

  /// The SBC's own end, and what hookbeh takes for one.
  void leftByTheSbc(const BehaviourBlock& hookbeh) {
    const double silence = hookbeh.value("silence_secs");
    if (!(silence > 0 && silence <= hooks::kMostSilenceSecs)) {
      unproved(
          "silence of the SBC", &*hookbeh_,
          fmt::format("{} has silence_secs {:g}", hookbeh_->label(), silence),
          fmt::format("give it a silence_secs above 0 and up to {:g} s", hooks::kMostSilenceSecs));
      return;
    }
    const double gap = platform_.world.tick_gap_s;
    const uint32_t unanswered = hooks::Client::kMostUnansweredTicks;
    const Part heard{fmt::format("{} ticks without an answer", unanswered), unanswered * gap};
    std::vector<Part> let_go = {{"silence_secs", silence}, {"2 cycles", 2 * gap}};
    if (const double nap = hookbeh.value("nap_secs"); naps_ && nap > 0) {
      let_go.push_back({"nap_secs", nap});  // so long the beats on its behalf count
    }
    if (platform_.world.line_lag_s > 0) {  // the last heartbeat is still on its way
      let_go.push_back({"line", platform_.world.line_lag_s});
    }
    const WayUp up = wayUp(layers_, vehicle_, platform_, all_.deepest_m);
    // A release that is lost is written again; if no answer comes, the SBC claims no control.
    add("`exit`", {heard}, let_go, up);
    add("instructions that get no answer", {heard}, let_go, up);
    add("silence of the SBC", {}, let_go, up);
  }

  void add(std::string after, std::vector<Part> parts, const std::vector<Part>& let_go,
           const WayUp& up) {
    parts.insert(parts.end(), let_go.begin(), let_go.end());
    parts.insert(parts.end(), up.parts.begin(), up.parts.end());
    all_.endings.push_back({std::move(after),
                            up.why_not.empty() ? std::move(parts) : std::vector<Part>{}, up.by,
                            up.why_not, up.change, up.range});
  }

  /// What stands above hookbeh replaces its commands, also while the SBC has control.
  void maskedFromAbove() {
    for (auto layer = layers_.begin(); layer != hookbeh_; ++layer) {
      const std::string after = "masking by " + layer->label();
      if (layer->role == Role::Surfaces) {
        all_.endings.push_back({after,
                                climbParts(platform_, all_.deepest_m),
                                fmt::format("{} ({})", layer->label(), layer->start_text),
                                "",
                                "",
                                {}});
      } else if (layer->role == Role::Flies && !(layer->deepest_m == 0.0)) {
        unproved(
            after, &*layer,
            fmt::format("{} ({}) stands above hookbeh and replaces its commands", layer->label(),
                        layer->argument.empty() ? "it dives" : layer->argument),
            "move it below hookbeh");
      }
    }
  }

  const slocum::MissionFile& vehicle_;
  const platforms::Platform& platform_;
  bool naps_;
  std::vector<Layer> layers_;
  std::vector<Layer>::iterator hookbeh_;
  Whole all_;
};

}  // namespace

double Ending::seconds() const {
  return std::accumulate(parts.begin(), parts.end(), 0.0,
                         [](double sum, const Part& part) { return sum + part.seconds; });
}

std::vector<Ending> Whole::alike() const {
  std::vector<Ending> all;
  for (const Ending& ending : endings) {
    const bool same = !all.empty() && all.back().by == ending.by &&
                      all.back().why_not == ending.why_not && all.back().parts == ending.parts;
    if (same) {
      all.back().after += ", " + ending.after;
    } else {
      all.push_back(ending);
    }
  }
  return all;
}

bool Whole::proved() const {
  return std::ranges::all_of(endings, &Ending::proved);
}

Whole wholeOf(const slocum::MissionFile& vehicle, const platforms::Platform& platform,
              double deepest_m, bool naps) {
  return Endings(vehicle, platform, deepest_m, naps).all();
}

Whole wholeOf(const ir::WidestWorld& world, const slocum::MissionFile& vehicle) {
  const ir::prove::ProofContext context(world);
  return wholeOf(vehicle, world.platform, std::ranges::max(ir::prove::deepestByState(context)),
                 world.mission.nap_s.has_value());
}

}  // namespace glider::slocum::rules
