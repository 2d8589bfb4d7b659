// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/control.h"

#include "ir/prove/context/duration_text.h"
#include "vehicles/slocum/mission_files/behaviour_catalogue.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace glider::slocum::rules {
namespace {

using slocum::BehaviourBlock;
using Kind = Disturbance::Kind;

bool steers(const BehaviourBlock& block) {
  return isOneOf(block.name == "nop_cmds" ? block.value("nop_heading") : 0, {1}) ||
         block.name == "set_heading" || block.name == "goto_wpt" || block.name == "goto_list";
}

/// end_action of a behaviour `surface`.
enum class SurfaceEnd : uint8_t { Quit, WaitThenResume, Resume, DriftAway, WaitOnce, WaitThenQuit };

/// What commands nothing in the first cycles, in which the SBC has no control yet.
struct Idle {
  bool heading = true, vertical = true;
  [[nodiscard]] std::string text() const {
    return heading && vertical ? "heading, pitch and pump"
           : heading           ? "the heading"
                               : "pitch and pump";
  }
};

class ControlSearch {
 public:
  ControlSearch(const slocum::MissionFile& vehicle, const std::vector<Layer>& layers,
                const MissionTimes& times, double fastest_m_s)
      : vehicle_(vehicle), layers_(layers), times_(times), fastest_m_s_(fastest_m_s) {
    const auto hookbeh = std::ranges::find(layers, Role::Hookbeh, &Layer::role);
    hookbeh_ = hookbeh == layers.end() ? 0 : hookbeh->number;
  }

  std::vector<Disturbance> run() {
    missing();
    for (const Layer& layer : layers_) {
      const BehaviourBlock& block = blockOf(layer);
      if (block.lacks_file) {
        continue;
      }
      if (block.name == "surface") {
        surface(layer, block);
      } else if (layer.number < hookbeh_) {
        above(layer, block);
      }
    }
    return std::move(found_);
  }

 private:
  [[nodiscard]] const BehaviourBlock& blockOf(const Layer& layer) const {
    return vehicle_.behaviours[layer.number - 1];
  }

  void add(Kind kind, const Layer& layer, std::string what, std::string change) {
    found_.push_back({kind, layer.range, layer.label() + " " + std::move(what), std::move(change)});
  }

  /// A hookbeh without its arguments is not flown.
  void missing() {
    for (const Layer& layer : layers_) {
      const BehaviourBlock& block = blockOf(layer);
      if (block.name == "hookbeh" && block.lacks_file) {
        add(Kind::Prevents, layer, "lacks the file of its arguments, and never starts",
            "write that file, or give it args_from_file -1");
      }
    }
  }

  // --- surface ---

  [[nodiscard]] static bool quits(const BehaviourBlock& block) {
    const auto end = static_cast<SurfaceEnd>(block.value("end_action"));
    return end == SurfaceEnd::Quit || end == SurfaceEnd::WaitThenQuit;
  }
  [[nodiscard]] static bool waitsForKeys(const BehaviourBlock& block) {
    const auto end = static_cast<SurfaceEnd>(block.value("end_action"));
    return end == SurfaceEnd::WaitThenResume || end == SurfaceEnd::WaitOnce ||
           end == SurfaceEnd::WaitThenQuit;
  }
  /// At the surface, s.
  [[nodiscard]] static double waits(const BehaviourBlock& block) {
    return std::max(0.0, block.value("gps_wait_time")) +
           (waitsForKeys(block) ? std::max(0.0, block.value("keystroke_wait_time")) : 0);
  }
  [[nodiscard]] static std::string has(const BehaviourBlock& block,
                                       std::initializer_list<const char*> arguments) {
    std::vector<std::string> all;
    for (const char* argument : arguments) {
      all.push_back(fmt::format("{} {:.7g}", argument, block.value(argument)));
    }
    return fmt::format("{}", fmt::join(all, ", "));
  }

  void surface(const Layer& layer, const BehaviourBlock& block) {
    const double code = block.value("start_when");
    if (isOneOf(code, {0, 1, 2, 3, 4})) {
      atTheBeginning(layer, block, code);
    } else if (isOneOf(code, {6, 9, 12})) {
      inTime(layer, block, code);
    } else if (!isOneOf(code, {5, 10})) {  // 10 waits for an idle pump: hookbeh commands it
      byAnEvent(layer, block, code);
    }
  }

  /// Codes that are true before the SBC has control, if ever.
  void atTheBeginning(const Layer& layer, const BehaviourBlock& block, double code) {
    const Idle idle = idleBelow(layer.number);
    const bool starts = code == 0 || (code == 1 && (idle.heading || idle.vertical)) ||
                        (code == 3 && idle.heading) || (isOneOf(code, {2, 4}) && idle.vertical);
    if (!starts) {
      idleLater(layer, block);
      return;
    }
    const std::string why = code == 0 ? has(block, {"start_when"})
                                      : fmt::format("{}: nothing below it commands {}",
                                                    has(block, {"start_when"}), idle.text());
    if (quits(block)) {
      add(Kind::Prevents, layer,
          fmt::format("({}) starts as soon as the vehicle's mission begins, and {} it ends that "
                      "mission ({})",
                      why, afterWait(block), has(block, {"end_action"})),
          "give it end_action 2, which resumes the mission");
    } else if (code == 0 && layer.number < hookbeh_) {
      add(Kind::Prevents, layer, fmt::format("({}) stands above hookbeh and is always active", why),
          "give it another start_when, or move it below hookbeh");
    } else if (layer.number < hookbeh_ && waitsForKeys(block)) {
      // A wait for the GPS alone ends with the fix: the mission only begins a little later.
      add(Kind::Masks, layer,
          fmt::format("({}) starts as soon as the vehicle's mission begins, and keeps it at the "
                      "surface for up to {} ({}), although the SBC may have control",
                      why, ir::prove::durationOf(waits(block)),
                      has(block, {"end_action", "gps_wait_time", "keystroke_wait_time"})),
          "give it end_action 2, which waits for no key, or let the mission allow for it");
    }
  }
  /// What flies below may be over before hookbeh is ready.
  void idleLater(const Layer& layer, const BehaviourBlock& block) {
    double legs_s = 0;
    for (const Layer& other : layers_) {
      if (other.number > layer.number && other.role == Role::Flies) {
        legs_s += other.legs && other.deepest_m ? *other.legs * *other.deepest_m / fastest_m_s_
                                                : std::numeric_limits<double>::infinity();
      }
    }
    const bool sees = block.value("start_when") != 3;  // which waits for the heading
    if (quits(block) && sees && legs_s < times_.starts()) {
      add(Kind::Prevents, layer,
          fmt::format(
              "({}) starts when what flies below it is over, perhaps before hookbeh is ready "
              "({} after the vehicle's mission has begun), and at the surface it ends that "
              "mission ({})",
              has(block, {"start_when"}), ir::prove::durationOf(times_.starts()),
              has(block, {"end_action"})),
          "give it end_action 2, lower start_secs of hookbeh, or let more legs be flown");
    }
  }
  [[nodiscard]] static std::string afterWait(const BehaviourBlock& block) {
    return waits(block) > 0
               ? fmt::format("at the latest {} later", ir::prove::durationOf(waits(block)))
               : std::string("at once");
  }
  /// Codes that count seconds.
  void inTime(const Layer& layer, const BehaviourBlock& block, double code) {
    const double secs = block.value("when_secs");
    if (slocum::missionParameter(secs)) {
      byAnEvent(layer, block, code);
      return;
    }
    const double first = std::max(0.0, secs);
    if (!times_.fliesAt(first) || (layer.number > hookbeh_ && !quits(block))) {
      return;
    }
    // A mission without a proved end needs a surfacing that it does not command itself.
    constexpr double kBackupSecs = 6 * 3600;
    if (code == 12 && !quits(block) && times_.isOpen() && first >= kBackupSecs) {
      return;
    }
    const std::string time = ir::prove::durationOf(first);
    const std::string after =
        code == 9    ? "every " + time
        : code == 12 ? time + " after the vehicle's last contact, or after its mission has begun"
                     : time + " after the vehicle's mission has begun";
    const std::string state = times_.stateAt(first);
    ends(layer, block,
         fmt::format("({}) starts {}{}{}", has(block, {"start_when", "when_secs"}), after,
                     state.empty() ? ""
                     : code == 9   ? ", first "
                                   : ", ",
                     state));
  }

  void byAnEvent(const Layer& layer, const BehaviourBlock& block, double code) {
    if (layer.number > hookbeh_ && !quits(block)) {
      return;
    }
    const bool counts = isOneOf(code, {6, 9, 12});
    const char* argument = counts                           ? "when_secs"
                           : isOneOf(code, {7, 15, 17, 18}) ? "when_wpt_dist"
                           : code == 13                     ? "when_utc_timestamp"
                           : code == 16                     ? "when_num_inflections"
                                                            : nullptr;
    const std::string at =
        argument != nullptr ? has(block, {"start_when", argument}) : has(block, {"start_when"});
    ends(layer, block, fmt::format("({}) may start while the mission flies", at));
  }

  void ends(const Layer& layer, const BehaviourBlock& block, const std::string& when) {
    if (quits(block)) {
      add(Kind::Prevents, layer,
          fmt::format("{}, and at the surface it ends the vehicle's mission ({}); {}", when,
                      has(block, {"end_action"}), times_.endText()),
          "start it after the mission ends, or give it end_action 2");
    } else {
      add(Kind::Masks, layer,
          fmt::format("{}, and brings the vehicle to the surface; {}", when, times_.endText()),
          "if this is intended, for example to call home, change nothing; otherwise start it after "
          "the mission ends, or move it below hookbeh");
    }
  }

  // --- others above hookbeh ---

  void above(const Layer& layer, const BehaviourBlock& block) {
    const double code = block.name == "nop_cmds" ? 0 : block.name == "hookbeh" ? 5 : startOf(block);
    if (steers(block) && code != 5) {
      heading(layer, block, code);
    } else if (layer.role == Role::Flies && layer.deepest_m == 0.0 && code != 5) {
      add(Kind::Masks, layer,
          fmt::format("stands above hookbeh and replaces its commands while it is active{}",
                      startText(block)),
          "move it below hookbeh");
    }
  }
  void heading(const Layer& layer, const BehaviourBlock& block, double code) {
    const Idle idle = idleBelow(layer.number);
    const bool waits_for_idle = isOneOf(code, {1, 2, 3, 4});
    const bool starts = !waits_for_idle || (code == 1 && (idle.heading || idle.vertical)) ||
                        (code == 3 && idle.heading) || (isOneOf(code, {2, 4}) && idle.vertical);
    if (starts) {
      add(Kind::Masks, layer,
          fmt::format("stands above hookbeh and replaces its heading once it is active{}",
                      startText(block)),
          "move it below hookbeh");
    }
  }
  [[nodiscard]] static double startOf(const BehaviourBlock& block) {
    const slocum::KnownBehaviour* known = slocum::findBehaviour(block.name);
    return known != nullptr && known->find("start_when") != nullptr ? block.value("start_when") : 0;
  }
  [[nodiscard]] static std::string startText(const BehaviourBlock& block) {
    const slocum::KnownBehaviour* known = slocum::findBehaviour(block.name);
    return known != nullptr && known->find("start_when") != nullptr
               ? " (" + has(block, {"start_when"}) + ")"
               : "";
  }

  /// What is without a command in the first cycle, of all behaviours below `number` but hookbeh.
  [[nodiscard]] Idle idleBelow(size_t number) const {
    Idle idle;
    for (size_t i = vehicle_.behaviours.size(); i > number; --i) {
      const BehaviourBlock& block = vehicle_.behaviours[i - 1];
      const double code = startOf(block);
      const bool starts = code == 0 || (code == 1 && (idle.heading || idle.vertical)) ||
                          (code == 3 && idle.heading) || (isOneOf(code, {2, 4}) && idle.vertical);
      if (block.lacks_file || !starts || block.name == "hookbeh") {
        continue;
      }
      const bool whole = block.name == "surface" || block.name == "prepare_to_dive";
      const bool flies = block.name == "yo" || block.name == "dive_to" ||
                         block.name == "climb_to" || block.name == "drift_at_depth" ||
                         (block.name == "nop_cmds" && block.value("nop_pitch") != 0 &&
                          block.value("nop_bpump") != 0);
      idle.heading = idle.heading && !whole && !steers(block);
      idle.vertical = idle.vertical && !whole && !flies;
    }
    return idle;
  }

  const slocum::MissionFile& vehicle_;
  const std::vector<Layer>& layers_;
  const MissionTimes& times_;
  double fastest_m_s_;  ///< that it sinks and climbs
  size_t hookbeh_;      ///< its number; 0: there is none
  std::vector<Disturbance> found_;
};

}  // namespace

std::vector<Disturbance> disturbances(const slocum::MissionFile& vehicle,
                                      const std::vector<Layer>& layers, const MissionTimes& times,
                                      const platforms::Platform& platform) {
  return ControlSearch(vehicle, layers, times, platform.envelope.vertical_rate_m_s).run();
}

}  // namespace glider::slocum::rules
