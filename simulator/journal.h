// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <string>
#include <utility>
#include <vector>

namespace glider::simulator {

using support::EventId;
using support::EventValue;

/// An event whose time is still to be said.
struct News {
  EventId id = EventId::Unlisted;
  std::vector<EventValue> values = {};
  std::string why = {};
};

/// The events of a flight, in the order in which they become known.
class Journal {
 public:
  void add(double time_s, EventId id, std::vector<EventValue> values = {}, std::string why = "") {
    events_.push_back(support::makeEvent(time_s, id, std::move(values), std::move(why)));
  }
  /// Adds all of `news`, and clears it.
  void add(double time_s, std::vector<News>& news) {
    for (News& one : news) {
      add(time_s, one.id, std::move(one.values), std::move(one.why));
    }
    news.clear();
  }
  std::vector<support::TraceEvent>& events() { return events_; }

 private:
  std::vector<support::TraceEvent> events_;
};

}  // namespace glider::simulator
