// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <limits>
#include <string>
#include <vector>

namespace glider::simulator {

/// The events of a flight, in the order in which they become known.
class Journal {
 public:
  void add(double time_s, std::string kind, std::string what, std::string why = "") {
    events_.push_back({time_s, std::numeric_limits<double>::quiet_NaN(), std::move(kind),
                       std::move(what), std::move(why)});
  }
  std::vector<support::TraceEvent>& events() { return events_; }

 private:
  std::vector<support::TraceEvent> events_;
};

}  // namespace glider::simulator
