// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/science/extctl_proglet.h"

#include "hooks/protocol/decimal.h"
#include "hooks/protocol/notices.h"
#include "simulator/seat/told.h"
#include "simulator/sensors/provided.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

namespace glider::simulator {
namespace {

using hooks::SeatEvent;

/// The line of the vendor's port, and of files in base64.
constexpr size_t kMostLine = 820;
/// An SBC that has written this is a backseat driver of glidercc: its state and a count.
constexpr std::string_view kState = "sci_generic_a", kTime = "sci_generic_c";

bool isSame(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

ExtctlProglet::ExtctlProglet(const platforms::Platform& platform, const slocum::ExtctlFile& file,
                             ExtctlVehicle vehicle, const Settings& settings)
    : vehicle_(std::move(vehicle)),
      mark_noise_(settings.seed, "extctl marks"),
      virtual_time_(settings.virtual_time) {
  const size_t first_reported = file.parameters.size() + file.written.size();
  for (const slocum::ExtctlSensor& sensor : file.sensors()) {
    rows_.push_back({.name = sensor.name,
                     .id = numberOf(platform, sensor.name),
                     .reported = rows_.size() >= first_reported});
  }
}

SeatEvent ExtctlProglet::nextEvent() {
  if (events_.empty()) {
    return {};
  }
  const SeatEvent event = events_.front();
  events_.pop_front();
  return event;
}

void ExtctlProglet::run(double now_s, const hooks::ScienceMemory& memory,
                        const GliderByteStream& sbc) {
  if (!std::exchange(begun_, true)) {
    say(virtual_time_ ? hooks::extctl::kVirtualTimeHello : "HI");
  }
  hear(now_s, sbc);
  watch(now_s);
  refresh(now_s, memory);
  report();
  flush(sbc);
}

/// The vendor's proglet does not watch the SBC: this is for the flight's story only.
void ExtctlProglet::watch(double now_s) {
  if (view_.known && now_s - heard_s_ > kSilence) {
    view_ = {};
  }
}

void ExtctlProglet::hear(double now_s, const GliderByteStream& sbc) {
  std::array<uint8_t, 256> bytes;
  constexpr int kMostReads = 16;
  for (int reads = 0; reads < kMostReads; ++reads) {
    const int32_t count = sbc.read(sbc.self, bytes.data(), static_cast<uint32_t>(bytes.size()));
    for (int32_t i = 0; i < count; ++i) {
      if (reader_.push(bytes.at(static_cast<size_t>(i)))) {
        obey(now_s);
      }
    }
    if (count <= 0) {
      return;
    }
  }
}

void ExtctlProglet::obey(double now_s) {
  std::string_view body(reader_.body(), reader_.size());
  const std::string_view name = takePart(body, ',');
  if (name == "SW") {
    heard_s_ = now_s;
    writePairs(body);
  } else if (name == "MD") {
    setModes(body);
  } else if (name == "TXT") {
    takeText(body);
  }
}

/// Pairs `index:value`; what is none is ignored, as is a sensor that the SBC may not write.
void ExtctlProglet::writePairs(std::string_view pairs) {
  while (!pairs.empty()) {
    std::string_view pair = takePart(pairs, ',');
    uint32_t index = 0;
    double value = 0;
    const bool good = readWhole(takePart(pair, ':'), index) && readReal(pair, value) &&
                      index < rows_.size() && !rows_[index].reported && std::isfinite(value);
    if (!good) {
      continue;
    }
    const Row& row = rows_[index];
    if (row.name.starts_with("sci_generic_")) {
      takeOwnWrite(row, value);
    } else {
      vehicle_.put(row.name, value);
    }
  }
}

/// A sensor of the science computer's own, for its log.
void ExtctlProglet::takeOwnWrite(const Row& row, double value) {
  if (row.name == kTime) {
    view_.mission_time_s = value;
  }
  if (row.name != kState) {
    return;
  }
  view_.known = true;
  view_.phase = value > 0 ? hooks::MissionPhase::Flying : hooks::MissionPhase::Waiting;
  view_.state = value > 0 ? static_cast<uint32_t>(value) - 1 : 0;
}

void ExtctlProglet::setModes(std::string_view numbers) {
  uint32_t mask = 0, value = 0;
  if (readWhole(takePart(numbers, ','), mask) && readWhole(numbers, value)) {
    modes_ = (modes_ & ~mask) | (value & mask);
    vehicle_.put("u_mission_mode", modes_);
  }
}

/// What the SBC says of its mission: its name, a transition, a note of it; or anything, to people.
void ExtctlProglet::takeText(std::string_view text) {
  events_.push_back(toldIn(text, view_.mission_time_s));
}

/// A sensor that no mission reads crosses between the computers as late as one that the SBC writes.
double ExtctlProglet::cross(double now_s, Row& row) {
  const double value = vehicle_.value(row.name);
  const bool waits = !isSame(row.newest, row.value);
  if (!waits && !isSame(value, row.value)) {
    row.due_s = now_s + kLeastDelay + (kMostDelay - kLeastDelay) * mark_noise_.uniform();
  }
  row.newest = value;
  return now_s >= row.due_s ? value : row.value;
}

void ExtctlProglet::refresh(double now_s, const hooks::ScienceMemory& memory) {
  for (Row& row : rows_) {
    if (!row.reported) {
      continue;
    }
    double value = row.value;
    if (row.id == hooks::kNoSensor) {
      value = cross(now_s, row);
    } else {
      bool fresh = false;
      value = memory.get(memory.self, row.id, &fresh);
    }
    row.told = row.told && isSame(value, row.value);
    row.value = value;
  }
}

/// In sentences as long as a line may be.
void ExtctlProglet::report() {
  std::string body;
  for (size_t index = 0; index < rows_.size(); ++index) {
    Row& row = rows_[index];
    if (!row.reported || row.told || std::isnan(row.value)) {
      continue;
    }
    const std::string pair = fmt::format(",{}:{:.12f}", index, row.value);
    if (body.size() + pair.size() > kMostLine) {
      say("SD" + std::exchange(body, {}));
    }
    body += pair;
    row.told = true;
  }
  if (!body.empty()) {
    say("SD" + body);
  }
}

void ExtctlProglet::say(const std::string& body) {
  uint8_t sum = 0;
  for (const char c : body) {
    sum ^= static_cast<uint8_t>(c);
  }
  // What the line has no room for is lost.
  constexpr size_t kMostQueued = 8192;
  if (out_.size() < kMostQueued) {
    out_ += fmt::format("${}*{:02x}\r\n", body, sum);
  }
}

void ExtctlProglet::flush(const GliderByteStream& sbc) {
  const int32_t taken = sbc.write(sbc.self, reinterpret_cast<const uint8_t*>(out_.data()),
                                  static_cast<uint32_t>(out_.size()));
  out_.erase(0, static_cast<size_t>(std::max(taken, 0)));
}

}  // namespace glider::simulator
