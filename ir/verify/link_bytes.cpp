// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/link_bytes.h"

#include <algorithm>
#include <set>
#include <string_view>

// tests/unit/ir/link_bytes_test.cpp compares these with what hooks/protocol writes.
namespace glider::ir {
namespace {

constexpr uint64_t kFrame = 6;  // type, sequence, CRC
constexpr uint64_t kMostList = 250, kTickHead = 24, kListHead = 1, kNumber = 2, kSubscription = 7;
constexpr uint64_t kDone = 18, kTransition = 22, kNote = 70;
constexpr uint64_t kMostNotices = 8, kMostNotes = 8;
constexpr double kFastBaud = 115200, kBitsAByte = 10;

/// The bytes of a frame with a payload of this size, with COBS's bytes and the final zero.
uint64_t onTheLine(uint64_t payload) {
  constexpr uint64_t kGroup = 254;
  return payload + kFrame + (payload + kFrame) / kGroup + 2;
}

/// Frames of lists of readings, filled in order: a reading is never divided.
class Frames {
 public:
  explicit Frames(uint64_t head) : head_(head), used_(head) {}
  void add(uint64_t width) {
    if (used_ + kNumber + width > kMostList) {
      done_ += onTheLine(used_);
      used_ = head_;
    }
    used_ += kNumber + width;
  }
  [[nodiscard]] uint64_t bytes() const { return done_ + onTheLine(used_); }

 private:
  uint64_t head_;
  uint64_t used_;
  uint64_t done_ = 0;
};

/// The depth, to which the program subscribes also where the mission does not read it, to begin
/// near the surface; null if it does.
const platforms::PlatformSensor* unreadDepth(const Mission& mission,
                                             const platforms::Platform& platform) {
  const platforms::PlatformSensor* depth = platform.find("m_depth");
  const bool read = depth != nullptr && std::ranges::any_of(mission.sensors, [&](const auto& s) {
                      return s.id == depth->id;
                    });
  return read ? nullptr : depth;
}

/// One frame: two bits and a value for each sensor.
uint64_t tick(const Mission& mission, const platforms::Platform& platform) {
  std::set<uint16_t> met;
  uint64_t values = 0;
  for (const Sensor& sensor : mission.sensors) {
    if (sensor.id < platform.sensors.size() && met.insert(sensor.id).second) {
      values += platform.sensors[sensor.id].bytes;
    }
  }
  if (const auto* depth = unreadDepth(mission, platform)) {
    met.insert(depth->id);
    values += depth->bytes;
  }
  return onTheLine(kTickHead + 2 * ((met.size() + 7) / 8) + values);
}

bool leavesNotes(const Mission& mission) {
  return std::ranges::any_of(mission.assumptions, &Assumption::isWatched) ||
         std::ranges::any_of(mission.blocks, [](const Block& block) {
           return std::ranges::any_of(block.statements, [](const Statement& statement) {
             return statement.kind == StatementKind::Log || statement.kind == StatementKind::Set;
           });
         });
}

bool startsWithHook(const platforms::PlatformSensor& sensor) {
  return sensor.name.starts_with("sci_hook_") && sensor.name != "sci_hook_heartbeat";
}

/// One frame with all sensors of an instruction.
uint64_t instruction(const platforms::Platform& platform) {
  Frames frames(kListHead);
  for (const platforms::PlatformSensor& sensor : platform.sensors) {
    if (startsWithHook(sensor)) {
      frames.add(sensor.bytes);
    }
  }
  return frames.bytes();
}

/// Subscription, transitions, an instruction, notes, Done.
uint64_t answer(const Mission& mission, const platforms::Platform& platform) {
  const size_t sensors =
      mission.sensors.size() + (unreadDepth(mission, platform) != nullptr ? 1U : 0U);
  const uint64_t subscribe = onTheLine(kListHead + kSubscription * sensors);
  const uint64_t notes = leavesNotes(mission) ? kMostNotes * onTheLine(kNote) : 0;
  return subscribe + kMostNotices * onTheLine(kTransition) + instruction(platform) + notes +
         onTheLine(kDone);
}

}  // namespace

LinkBytes linkBytes(const Mission& mission, const platforms::Platform& platform) {
  LinkBytes bytes;
  bytes.to_sbc = tick(mission, platform);
  bytes.from_sbc = answer(mission, platform);
  const double cycle = platform.envelope.cycle_s;
  bytes.fast_line = static_cast<uint64_t>(cycle * kFastBaud / kBitsAByte);
  return bytes;
}

}  // namespace glider::ir
