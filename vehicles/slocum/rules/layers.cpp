// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/layers.h"

#include "vehicles/slocum/mission_files/behaviour_catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::slocum::rules {
namespace {

using slocum::BehaviourBlock;

constexpr int kNever = 5;  // start_when
/// A pump that is out, or in, by less than this share of its stroke may be too weak: hookbeh's own
/// rule (hooks/hookbeh/hull.h).
constexpr double kWeakestPump = 0.5;
/// A greater number of legs or of a code says no more.
constexpr double kMostCounted = 1e6;

/// Reads b_args; the first that keeps the behaviour from being understood is kept.
class Reader {
 public:
  Reader(const BehaviourBlock& block, const platforms::Platform& platform)
      : block_(block), platform_(platform) {}

  /// A number that no mission parameter replaces at run time.
  std::optional<double> number(const std::string& name) {
    const double value = block_.value(name);
    if (!std::isfinite(value) || slocum::missionParameter(value)) {
      fail(name, "a number that does not change in flight");
      return std::nullopt;
    }
    return value;
  }
  int code(const std::string& name) {
    return static_cast<int>(std::clamp(number(name).value_or(kNever), -kMostCounted, kMostCounted));
  }
  /// "start_when 12".
  [[nodiscard]] std::string text(const std::string& name) const {
    return fmt::format("{} {:g}", name, block_.value(name));
  }
  void fail(const std::string& name, const std::string& needed) {
    if (argument.empty()) {
      argument = text(name);
      change = fmt::format("give `{}` {}", name, needed);
    }
  }
  /// Pump and pitch behind `prefix` take the vehicle up, or down, as strongly as a steady climb
  /// needs.
  void checkDrive(const std::string& prefix, bool up) {
    const double sign = up ? 1 : -1;
    const double pump = sign * number(prefix + "bpump_value").value_or(0);
    if (code(prefix + "use_bpump") != 2) {  // 0, autoballast, need not use bpump_value
      fail(prefix + "use_bpump", "the code 2");
    }
    if (pump < kWeakestPump * platform_.envelope.pump_cc) {
      fail(prefix + "bpump_value", fmt::format("{} {:g} cc", up ? "at least" : "at most",
                                               sign * kWeakestPump * platform_.envelope.pump_cc));
    }
    const int use_pitch = code(prefix + "use_pitch");
    if (use_pitch != 2 && use_pitch != 3) {
      fail(prefix + "use_pitch", "the code 3");
    }
    const double pitch = sign * number(prefix + "pitch_value").value_or(0);
    const auto& hull = platform_.envelope;
    if (pitch < hull.shallowest_pitch_rad || pitch > hull.steepest_pitch_rad) {
      fail(prefix + "pitch_value",
           fmt::format("a value between {:g} and {:g} rad",
                       sign * (up ? hull.shallowest_pitch_rad : hull.steepest_pitch_rad),
                       sign * (up ? hull.steepest_pitch_rad : hull.shallowest_pitch_rad)));
    }
  }
  /// The time after which a leg behind `prefix` that gains no depth is over.
  double stalled(const std::string& prefix) {
    const std::string name = prefix + "stop_when_stalled_for";
    const double seconds = number(name).value_or(0);
    if (seconds < 0) {
      fail(name, "a time in seconds");
    }
    return seconds;
  }
  [[nodiscard]] bool understood() const { return argument.empty(); }

  std::string argument, change;

 private:
  const BehaviourBlock& block_;
  const platforms::Platform& platform_;
};

/// What may be anywhere, for ever: no more can be said of it.
void cannotTell(Layer& layer, const Reader& reader) {
  layer.role = Role::Flies;
  layer.deepest_m.reset();
  layer.legs.reset();
  layer.argument = reader.argument;
  layer.change = reader.change;
}

/// As long as lower behaviours command the heading, code 3 waits. A behaviour that surfaces
/// commands it only if no other behaviour does.
bool headingIsIdleBelow(const slocum::MissionFile& mission, size_t number) {
  return std::none_of(mission.behaviours.begin() + static_cast<ptrdiff_t>(number),
                      mission.behaviours.end(), [](const BehaviourBlock& block) {
                        return block.name != "hookbeh" && block.name != "surface" &&
                               block.name != "abend" && slocum::drivesMotors(block.name);
                      });
}

void readStart(const slocum::MissionFile& mission, Reader& reader, Layer& layer) {
  const int code = reader.code("start_when");
  layer.start_text = reader.text("start_when");
  switch (code) {
    case 0:
      layer.start = Start::InTime;
      return;
    case 3:
      layer.start = headingIsIdleBelow(mission, layer.number) ? Start::Idle : Start::Uncertain;
      return;
    case 1:
    case 2:
    case 4:
      layer.start = Start::Idle;
      return;
    case 6:
    case 9:
    case 12:
      layer.start_text += ", " + reader.text("when_secs");
      if (const auto seconds = reader.number("when_secs")) {
        layer.start = Start::InTime;
        layer.starts_within_s = std::max(0.0, *seconds);
      }
      return;
    default:
      layer.start = Start::Uncertain;
  }
}

void readSurface(const slocum::MissionFile& mission, Reader& reader, Layer& layer) {
  layer.role = Role::Surfaces;
  reader.checkDrive("c_", true);
  if (!reader.understood()) {
    cannotTell(layer, reader);
    return;
  }
  readStart(mission, reader, layer);
}

/// Of a behaviour that ends after its legs: with another end_action it starts again.
void readEnd(Reader& reader, Layer& layer, int legs) {
  if (reader.code("end_action") == 0) {
    layer.legs = legs;
    return;
  }
  layer.legs.reset();
  layer.argument = reader.text("end_action");
  layer.change = "give it end_action 0, which ends it for good";
}

void readYo(Reader& reader, Layer& layer) {
  reader.checkDrive("d_", false);
  reader.checkDrive("c_", true);
  layer.stalled_s = std::max(reader.stalled("d_"), reader.stalled("c_"));
  const auto deepest = reader.number("d_target_depth");
  reader.number("c_target_depth");
  const auto legs = reader.number("num_half_cycles_to_do");
  if (!reader.understood()) {
    cannotTell(layer, reader);
    return;
  }
  layer.deepest_m = *deepest;
  if (*legs >= 0) {
    // The vehicle counts a leg when it is over: with 0 it still flies one.
    readEnd(reader, layer, static_cast<int>(std::ceil(std::clamp(*legs, 1.0, kMostCounted))));
    return;
  }
  layer.argument = reader.text("num_half_cycles_to_do");
  layer.change = "give it a number of half cycles (num_half_cycles_to_do)";
}

void readLeg(Reader& reader, Layer& layer, bool up) {
  reader.checkDrive("", up);
  layer.stalled_s = reader.stalled("");
  const auto target = reader.number("target_depth");
  if (!reader.understood()) {
    cannotTell(layer, reader);
    return;
  }
  layer.deepest_m = up ? 0 : *target;
  readEnd(reader, layer, 1);
}

/// It corrects its depth by the pump, without an end of its own in water that holds it.
void readDrift(Reader& reader, Layer& layer) {
  reader.checkDrive("d_", false);
  reader.checkDrive("c_", true);
  const auto target = reader.number("target_depth");
  const auto band = reader.number("target_deadband");
  if (!reader.understood()) {
    cannotTell(layer, reader);
    return;
  }
  layer.deepest_m = *target + std::max(0.0, *band);
  layer.argument = reader.text("target_depth");
  layer.change = "fly it before hookbeh is ready, or delete it";
}

/// The motors stay where they are: in, after a dive.
void readNop(Reader& reader, Layer& layer) {
  if (reader.code("nop_pitch") == 0 && reader.code("nop_bpump") == 0) {
    layer.role = Role::Quiet;
    return;
  }
  reader.fail(reader.code("nop_bpump") != 0 ? "nop_bpump" : "nop_pitch", "the value 0");
  cannotTell(layer, reader);
}

/// It climbs as a surface behaviour without b_args, but only for its time.
void readPrepare(Reader& reader, Layer& layer) {
  const auto seconds = reader.number("wait_time");
  if (!seconds) {
    cannotTell(layer, reader);
    return;
  }
  layer.deepest_m = 0;
  layer.legs = 0;
  layer.waits_s = std::max(0.0, *seconds);
}

bool hasStartCode(const BehaviourBlock& block) {
  const slocum::KnownBehaviour* known = slocum::findBehaviour(block.name);
  return known != nullptr && known->find("start_when") != nullptr;
}

/// Those that command only the heading, watch the vehicle, or read instruments.
bool isQuiet(const std::string& name) {
  return name == "abend" || name == "set_heading" || name == "goto_wpt" || name == "goto_list" ||
         name == "sample" || name == "sensors_in";
}

void readFlying(const BehaviourBlock& block, Reader& reader, Layer& layer) {
  layer.role = Role::Flies;
  if (block.name == "yo") {
    readYo(reader, layer);
  } else if (block.name == "dive_to" || block.name == "climb_to") {
    readLeg(reader, layer, block.name == "climb_to");
  } else if (block.name == "drift_at_depth") {
    readDrift(reader, layer);
  } else if (block.name == "nop_cmds") {
    readNop(reader, layer);
  } else if (block.name == "prepare_to_dive") {
    readPrepare(reader, layer);
  } else {
    layer.argument = "glidercc does not know what it commands";
    layer.change = fmt::format("delete `{}`, or see for yourself what it does", block.name);
  }
}

}  // namespace

bool isOneOf(double code, std::initializer_list<double> codes) {
  return std::ranges::find(codes, code) != codes.end();
}

std::string Layer::label() const {
  return fmt::format("behaviour {} `{}`", number, name);
}

std::vector<Layer> layersOf(const slocum::MissionFile& mission,
                            const platforms::Platform& platform) {
  std::vector<Layer> layers;
  for (const BehaviourBlock& block : mission.behaviours) {
    Layer& layer = layers.emplace_back();
    layer.number = layers.size();
    layer.name = block.name;
    layer.range = block.range;
    Reader reader(block, platform);
    const bool never = hasStartCode(block) && block.value("start_when") == kNever;
    if (block.lacks_file || never || isQuiet(block.name)) {
      continue;
    }
    if (block.name == "hookbeh") {
      layer.role = Role::Hookbeh;
    } else if (block.name == "surface") {
      readSurface(mission, reader, layer);
    } else {
      readFlying(block, reader, layer);
    }
  }
  return layers;
}

}  // namespace glider::slocum::rules
