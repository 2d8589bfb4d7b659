// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/outage_watch.h"

namespace glider::flights {

void OutageWatch::look(size_t start, double mission_time, double vehicle_time, uint32_t state) {
  if (start > latest_start_) {
    latest_start_ = start;
    restarted_ = start > 1;
    shown_ = mission_time;
  }
  if (restarted_ && mission_time > latest_) {
    found_.push_back({latest_, mission_time, vehicle_time, state});
    restarted_ = false;
  }
  restarted_ = restarted_ && mission_time <= shown_;  // otherwise its mission began again
  if (!restarted_) {
    latest_ = mission_time;
  }
}

}  // namespace glider::flights
