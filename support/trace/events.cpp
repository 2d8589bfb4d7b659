// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/trace/events.h"

#include "support/check.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>

namespace glider::support {
namespace {

struct Row {
  const char* kind;
  std::string_view words;
};

constexpr auto kEvents = std::to_array<Row>({
#define EVENT(name, kind, words) {kind, words},
#include "support/trace/events.def"
#undef EVENT
});

size_t placesOf(std::string_view words) {
  size_t places = 0;
  for (const char c : words) {
    places += c == '{';
  }
  return places;
}

std::string wordsOf(const Row& row, const std::vector<EventValue>& values) {
  CHECK(values.size() == placesOf(row.words), "an event has other values than its words");
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  for (const EventValue& value : values) {
    std::visit([&](const auto& one) { store.push_back(one); }, value);
  }
  return fmt::vformat(fmt::string_view(row.words.data(), row.words.size()), store);
}

}  // namespace

TraceEvent makeEvent(double time_s, EventId id, std::vector<EventValue> values, std::string why) {
  const Row& row = kEvents.at(static_cast<size_t>(id));
  TraceEvent event;
  event.time_s = time_s;
  event.kind = row.kind;
  event.what = wordsOf(row, values);
  event.why = std::move(why);
  event.id = id;
  event.values = std::move(values);
  return event;
}

}  // namespace glider::support
