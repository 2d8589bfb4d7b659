// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/nap_watch.h"

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

}  // namespace glider::flights
