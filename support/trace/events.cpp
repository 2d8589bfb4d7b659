// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/trace/events.h"

#include "support/check.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace glider::support {
namespace {

struct Row {
  EventKind kind;
  std::string_view words;
};

constexpr auto kEvents = std::to_array<Row>({
#define EVENT(name, kind, words) {EventKind::kind, words},
#include "support/trace/events.def"
#undef EVENT
});

constexpr auto kKinds = std::to_array<const char*>({
#define EVENT_KIND(name, word) word,
#include "support/trace/event_kinds.def"
#undef EVENT_KIND
});

const Row& rowOf(EventId id) {
  return kEvents.at(static_cast<size_t>(id));
}

size_t placesOf(EventId id) {
  constexpr size_t kUnlisted = 2;  // its kind, its text
  return id == EventId::Unlisted ? kUnlisted
                                 : static_cast<size_t>(std::ranges::count(rowOf(id).words, '{'));
}

const std::string& textIn(const TraceEvent& event, size_t number) {
  return std::get<std::string>(event.values.at(number));
}

}  // namespace

TraceEvent makeEvent(double time_s, EventId id, std::vector<EventValue> values, std::string why) {
  CHECK(values.size() == placesOf(id), "an event has other values than its words");
  TraceEvent event;
  event.time_s = time_s;
  event.id = id;
  event.values = std::move(values);
  event.why = std::move(why);
  return event;
}

TraceEvent unlistedEvent(double time_s, double mission_time_s, std::string kind, std::string text,
                         std::string why) {
  return {
      time_s, mission_time_s, EventId::Unlisted, {std::move(kind), std::move(text)}, std::move(why),
      ""};
}

std::string textOf(const TraceEvent& event) {
  if (event.id == EventId::Unlisted) {
    return textIn(event, 1);
  }
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  for (const EventValue& value : event.values) {
    std::visit([&](const auto& one) { store.push_back(one); }, value);
  }
  const std::string_view words = rowOf(event.id).words;
  return fmt::vformat(fmt::string_view(words.data(), words.size()), store);
}

std::string shownTextOf(const TraceEvent& event) {
  return event.shown.empty() ? textOf(event) : event.shown;
}

std::string kindOf(const TraceEvent& event) {
  return event.id == EventId::Unlisted ? textIn(event, 0)
                                       : kKinds.at(static_cast<size_t>(rowOf(event.id).kind));
}

bool isOfKind(const TraceEvent& event, EventKind kind) {
  return event.id == EventId::Unlisted ? textIn(event, 0) == kKinds.at(static_cast<size_t>(kind))
                                       : rowOf(event.id).kind == kind;
}

}  // namespace glider::support
