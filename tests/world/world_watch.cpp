// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/world/world_watch.h"

#include "hooks/protocol/values.h"
#include "tests/slocum.h"

#include <algorithm>
#include <cmath>

namespace glider::tests {

using hooks::HookAnswer;
using hooks::HookState;

WorldWatch::WorldWatch(const platforms::Platform& platform, const Conditions& conditions)
    : platform_(platform),
      conditions_(conditions),
      world_(platform),
      wrong_(platform.sensors.size()) {
  for (const auto& fault : conditions.scenario.faults.sensors) {
    wrong_.at(platform.find(fault.name)->id) = true;
  }
  // A fix is reported through the vehicle's position.
  wrong_.at(GLIDER_M_GPS_LAT) = wrong_.at(GLIDER_M_LAT);
  wrong_.at(GLIDER_M_GPS_LON) = wrong_.at(GLIDER_M_LON);
}

bool WorldWatch::refuses(const simulator::CycleView& view) const {
  const double answer = view.array.get(GLIDER_X_HOOK_ANSWER);
  return view.hook == HookState::Active && answer > static_cast<double>(HookAnswer::BadCheck);
}

bool WorldWatch::cycle(const simulator::CycleView& view) {
  depths_.emplace_back(view.time_s, view.true_depth_m);
  if (depths_.size() > 16) {
    depths_.pop_front();
  }
  const bool active = view.hook == HookState::Active && !view.aborted;
  refused_ = refused_ || refuses(view);
  over_ = over_ || refused_ || (was_active_ && !active);
  was_active_ = active;
  if (!conditions_.whole && active && !begun_) {
    begun_ = true;
    begun_s_ = view.time_s;
    world_.begin(view.time_s, view.true_depth_m, conditions_.from_surface);
  }
  if (!begun_ || over_) {
    return !over_;
  }
  world_.moved(view.time_s, view.true_depth_m);
  if (view.array.get(GLIDER_M_DEPTH_STATE) == 0) {
    world_.floats(view.time_s, view.true_depth_m);
  }
  reports(view);
  if (!conditions_.whole) {
    obeyed(view);
  }
  watched_s_ = view.time_s - begun_s_;
  return !world_.broken();
}

/// The command that hookbeh carries out.
void WorldWatch::obeyed(const simulator::CycleView& view) {
  const auto& array = view.array;
  if (array.get(GLIDER_X_HOOK_ANSWER) == static_cast<double>(HookAnswer::Accepted) &&
      array.get(GLIDER_X_HOOK_SEQUENCE) == array.get(GLIDER_SCI_HOOK_SEQUENCE)) {
    command(static_cast<uint32_t>(array.get(GLIDER_SCI_HOOK_VERTICAL)),
            array.get(GLIDER_SCI_HOOK_DEPTH), view.true_depth_m, view.time_s);
  }
}

void WorldWatch::command(uint32_t vertical, double target_m, double depth_m, double time_s) {
  switch (static_cast<GliderVertical>(vertical)) {
    case kGliderDescend:
    case kGliderHover:
      world_.commandDown(target_m, depth_m);
      break;
    case kGliderAscend:
      world_.commandUp(target_m, depth_m, time_s);
      break;
    case kGliderSurface:
      world_.commandUp(0, depth_m, time_s);
      break;
    case kGliderActuators:  // V8
      world_.commandDown(platform_.envelope.greatest_depth_m, depth_m);
      break;
    case kGliderNoVertical:
      break;
  }
}

void WorldWatch::reports(const simulator::CycleView& view) {
  for (const platforms::PlatformSensor& sensor : platform_.sensors) {
    const double raw = view.array.get(sensor.id);
    if (!wrong_[sensor.id] && !std::isnan(raw)) {
      world_.reports(view.time_s, sensor, raw);
    }
  }
}

double WorldWatch::depthAt(double time_s) const {
  const auto found = std::ranges::find(depths_, time_s, &std::pair<double, double>::first);
  return found == depths_.end() ? depths_.back().second : found->second;
}

void WorldWatch::polled(const GliderContext& context, double frame_s) {
  const bool is_new = !mission_time_ || context.mission_time > *mission_time_;
  if (over_ || depths_.empty() || !is_new) {
    return;
  }
  if (!conditions_.whole) {
    mission_time_ = context.mission_time;
    if (conditions_.program_runs && begun_) {
      world_.ticks(context.mission_time);
    }
    return;
  }
  if (!mission_time_) {
    begun_ = true;
    begun_s_ = first_frame_s_ = frame_s;
    world_.begin(frame_s, depthAt(frame_s), conditions_.from_surface);
  }
  mission_time_ = context.mission_time;
  newTick(context, frame_s);
  over_ = over_ || context.finished != 0;
}

void WorldWatch::newTick(const GliderContext& context, double frame_s) {
  const double depth_m = depthAt(frame_s);
  world_.ticks(first_frame_s_ + context.mission_time);
  command(context.vertical, context.depth, depth_m, frame_s);
  for (uint32_t i = 0; i < context.mission->sensor_count; ++i) {
    const double reading = context.readings[i].value;
    if (context.mission->sensors[i].id == GLIDER_M_DEPTH && !std::isnan(reading)) {
      world_.sees(frame_s, reading, depth_m);
    }
  }
}

}  // namespace glider::tests
