// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/log_json.h"

namespace glider::driver {
namespace {

using runtime::LogRecord;

const char* recordName(const logs::LogEntry& entry) {
  switch (entry.kind) {
    case LogRecord::Start:
      return "start";
    case LogRecord::Begin:
      return "begin";
    case LogRecord::Values:
      return "values";
    case LogRecord::Transition:
      return "transition";
    case LogRecord::Note:
      return entry.unknown_set ? "unknown set" : "log";
    case LogRecord::Event:
      return "event";
    case LogRecord::Name:
      break;
  }
  return "name";
}

}  // namespace

Json entryOf(const logs::LogEntry& entry) {
  Json one = {{"time_s", numberOrNull(entry.time)}, {"record", recordName(entry)}};
  if (!entry.name.empty()) {
    one["name"] = entry.name;
  }
  if (entry.kind == LogRecord::Transition) {
    one["case"] = entry.number;
    one["from"] = entry.detail;
    one["to"] = entry.to.empty() ? Json() : Json(entry.to);
  } else if (!entry.detail.empty()) {
    one["detail"] = entry.detail;
  }
  if (entry.kind == LogRecord::Event) {
    one["value"] = numberOrNull(entry.value);
  }
  for (size_t i = 0; i < entry.values.size(); ++i) {
    const auto& [name, value] = entry.values[i];
    Json told = Json::object();
    if (!name.empty()) {
      told["name"] = name;
    }
    told["value"] = numberOrNull(value);
    if (i < entry.units.size()) {
      told["unit"] = entry.units[i];
    }
    one["values"].push_back(std::move(told));
  }
  return one;
}

Json damageOf(const logs::LogDamage& damage) {
  return {{"bad", damage.bad}, {"missing", damage.missing}, {"unreadable", damage.unreadable}};
}

}  // namespace glider::driver
