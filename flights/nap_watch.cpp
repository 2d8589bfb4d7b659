// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/nap_watch.h"

#include "ir/worlds/naps.h"

#include <algorithm>
#include <bit>

namespace glider::flights {

NapWatch::Order NapWatch::orderOf(const GliderContext& context) {
  const auto bits = [](double value) { return std::bit_cast<uint64_t>(value); };
  return {context.vertical,       context.lateral,        context.state,
          context.stack_depth,    bits(context.depth),    bits(context.pitch),
          bits(context.magnetic), bits(context.latitude), bits(context.longitude)};
}

void NapWatch::look(const GliderContext& context, double now_s) {
  if (order_ && context.mission_time == mission_time_) {
    return;
  }
  mission_time_ = context.mission_time;
  const double behind_s = now_s - mission_time_;
  at_once_s_ = std::min(behind_s, at_once_s_.value_or(behind_s));
  const Order order = orderOf(context);
  const bool changed = order_ && order != *order_;
  order_ = order;
  const double late_s = behind_s - *at_once_s_;
  if (changed && late_s > (latest_ ? latest_->late_s : -1)) {
    latest_ = LateTick{now_s, late_s};
  }
}

std::optional<LateTick> tooLate(const NapWatch& watch, const compiler::Optimised& mission,
                                std::span<const simulator::SensorFault> faults) {
  const std::vector<ir::Sensor>& sensors = mission.mission.sensors;
  const auto isOfReading = [&](const simulator::SensorFault& fault) {
    const auto read = std::ranges::find(sensors, fault.name, &ir::Sensor::vehicle_name);
    return read != sensors.end() && read->type.dimension != support::dimension::time;
  };
  const double most_s = ir::kNapLag_s + mission.platform().envelope.cycle_s;
  const bool late = mission.mission.nap_s && watch.latest() && watch.latest()->late_s > most_s;
  return late && std::ranges::all_of(faults, isOfReading) ? watch.latest() : std::nullopt;
}

}  // namespace glider::flights
