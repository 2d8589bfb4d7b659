// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/science/science_program.h"

#include "hooks/protocol/bytes.h"
#include "support/diagnostics/ids/ports.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>
#include <optional>

namespace glider::simulator {
namespace {

constexpr int kVersion = 1;

std::vector<uint8_t> bytesOf(std::string_view hex) {
  std::vector<uint8_t> bytes;
  for (unsigned byte = 0; hex.size() >= 2; hex.remove_prefix(2)) {
    if (std::sscanf(std::string(hex.substr(0, 2)).c_str(), "%2x", &byte) != 1) {
      break;
    }
    bytes.push_back(static_cast<uint8_t>(byte));
  }
  return bytes;
}

/// An event as a line of it tells; none: it is not one.
std::optional<hooks::SeatEvent> eventOf(const std::string& line) {
  hooks::SeatEvent event;
  unsigned kind = 0;
  uint64_t time = 0;
  int text = 0;
  if (std::sscanf(line.c_str(),
                  "event %u %" SCNx64 " %" SCNu32 " %" SCNu32 " %" SCNu32 " %" SCNu32 " %" SCNu32
                  " %n",
                  &kind, &time, &event.a, &event.b, &event.c, &event.d, &event.e, &text) != 7 ||
      text == 0) {
    return std::nullopt;
  }
  event.kind = static_cast<hooks::SeatEvent::Kind>(kind);
  event.mission_time_s = hookDoubleOf(time);
  const std::vector<uint8_t> said =
      bytesOf(std::string_view(line).substr(static_cast<size_t>(text)));
  std::copy_n(said.begin(), std::min(said.size(), sizeof event.text - 1), event.text);
  return event;
}

std::optional<hooks::SbcView> viewOf(const std::string& line) {
  hooks::SbcView view;
  int known = 0;
  uint64_t time = 0;
  unsigned depth = 0, phase = 0;
  if (std::sscanf(line.c_str(), "view %d %" SCNx64 " %" SCNu32 " %u %u", &known, &time, &view.state,
                  &depth, &phase) != 5) {
    return std::nullopt;
  }
  view.known = known != 0;
  view.mission_time_s = hookDoubleOf(time);
  view.stack_depth = static_cast<uint8_t>(depth);
  view.phase = static_cast<hooks::MissionPhase>(phase);
  return view;
}

/// Starts it and greets it. Null, with the reason in `why`, if it does not answer as it should.
std::unique_ptr<ProgramLines> greeted(const std::vector<std::string>& command, uint32_t hash,
                                      bool virtual_time, std::string& why) {
  std::unique_ptr<ProgramLines> lines = ProgramLines::start(command, why);
  if (lines == nullptr) {
    return lines;
  }
  std::string answer;
  if (!lines->send(fmt::format("hello {} {:08x} {}\n", kVersion, hash, virtual_time ? 1 : 0)) ||
      !lines->receive(answer)) {
    why = lines->trouble();
    return nullptr;
  }
  if (answer != fmt::format("hello {} {:08x}", kVersion, hash)) {
    why = answer.starts_with("error ") ? answer.substr(6)
                                       : "it answers otherwise than a program of the kit";
    return nullptr;
  }
  return lines;
}

}  // namespace

ScienceProgram::ScienceProgram(Setup setup) : setup_(std::move(setup)) {
  std::string why;
  lines_ = greeted(setup_.command, setup_.dictionary.hash, setup_.virtual_time, why);
  if (lines_ == nullptr) {
    setup_.ended(why);
  }
}

support::Result<void> ScienceProgram::tryOut(const std::vector<std::string>& command,
                                             const GliderDictionary& dictionary) {
  std::string why;
  if (greeted(command, dictionary.hash, true, why) == nullptr) {
    return support::fail(support::diagnostics::scienceProgramFails,
                         fmt::format("{}", fmt::join(command, " ")), why);
  }
  return {};
}

void ScienceProgram::fail(const std::string& why) {
  lines_.reset();
  view_ = {};
  setup_.ended(why);
}

/// All that is new, also of its own sensors: other proglets set them.
void ScienceProgram::tellSensors(const hooks::ScienceMemory& memory) {
  for (uint32_t id = 0; id < setup_.dictionary.count; ++id) {
    bool fresh = false;
    const double value = memory.get(memory.self, static_cast<uint16_t>(id), &fresh);
    if (fresh) {
      cycle_ += fmt::format("sensor {} {:016x}\n", id, hookBitsOfDouble(value));
    }
  }
}

void ScienceProgram::tellBytes(const GliderByteStream& sbc) {
  std::array<uint8_t, 4096> bytes{};
  const int32_t got = sbc.read(sbc.self, bytes.data(), static_cast<uint32_t>(bytes.size()));
  if (got > 0) {
    cycle_ += fmt::format("bytes {:02x}\n", fmt::join(bytes.begin(), bytes.begin() + got, ""));
  } else if (got < 0) {
    cycle_ += "closed\n";
  }
}

void ScienceProgram::sendLeft(const GliderByteStream& sbc) {
  const int32_t taken =
      to_sbc_.empty() ? 0
                      : sbc.write(sbc.self, to_sbc_.data(), static_cast<uint32_t>(to_sbc_.size()));
  to_sbc_.erase(to_sbc_.begin(), to_sbc_.begin() + std::max(taken, 0));
}

bool ScienceProgram::obey(const std::string& line, const hooks::ScienceMemory& memory) {
  unsigned id = 0;
  uint64_t bits = 0;
  if (std::sscanf(line.c_str(), "set %u %" SCNx64, &id, &bits) == 2 &&
      id < setup_.dictionary.count) {
    memory.set(memory.self, static_cast<uint16_t>(id), hookDoubleOf(bits));
  } else if (line.starts_with("bytes ")) {
    const std::vector<uint8_t> bytes = bytesOf(std::string_view(line).substr(6));
    to_sbc_.insert(to_sbc_.end(), bytes.begin(), bytes.end());
  } else if (const auto event = eventOf(line)) {
    events_.push_back(*event);
  } else if (const auto view = viewOf(line)) {
    view_ = *view;
  } else {
    return false;
  }
  return true;
}

void ScienceProgram::run(double now_s, const hooks::ScienceMemory& memory,
                         const GliderByteStream& sbc) {
  if (lines_ == nullptr) {
    return;
  }
  cycle_.clear();
  tellSensors(memory);
  tellBytes(sbc);
  cycle_ += fmt::format("run {:016x}\n", hookBitsOfDouble(now_s));
  std::string line;
  bool there = lines_->send(cycle_);
  while (there && (there = lines_->receive(line)) && line != "done") {
    if (!obey(line, memory)) {
      fail(line.starts_with("error ") ? line.substr(6)
                                      : "it answers otherwise than a program of the kit");
      return;
    }
  }
  if (!there) {
    fail(lines_->trouble());
    return;
  }
  sendLeft(sbc);
}

hooks::SeatEvent ScienceProgram::nextEvent() {
  hooks::SeatEvent event;
  if (!events_.empty()) {
    event = events_.front();
    events_.pop_front();
  }
  return event;
}

}  // namespace glider::simulator
