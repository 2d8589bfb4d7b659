// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/extctl/port_writer.h"

#include "hooks/extctl/sentence.h"
#include "hooks/protocol/decimal.h"
#include "hooks/protocol/numbers.h"

namespace glider::runtime::extctl {
namespace {

using hooks::extctl::PortSensor;
using hooks::extctl::SentenceWriter;

/// All bits that the program may set.
constexpr uint32_t kAllModes = kGliderPortModeSurface | kGliderPortModeWaypoint;
/// Counts from 1 again after this many, which six decimals hold.
constexpr uint32_t kMostBeats = 1'000'000;

}  // namespace

PortWriter::PortWriter(const GliderPortMission& port, bool knows_start)
    : modes_(port.mission_modes != 0),
      greatest_depth_m_(port.greatest_depth_m),
      knows_start_(knows_start) {}

/// What may be in force at first. After a restart of the program that is any yo of this mission:
/// its climb is then made the shallowest that there is, before anything else is written. Its dive
/// counts as the shallowest until another is written, so that no climb is deeper.
void PortWriter::begin() {
  begun_ = true;
  Value& dive = at(PortSensor::DiveDepth);
  Value& climb = at(PortSensor::ClimbDepth);
  dives_.tell(hooks::extctl::kFirstDiveDepth, now_s_);
  if (!knows_start_) {
    climbs_.tell(greatest_depth_m_, now_s_);
    climb.due = kTimes;
  } else {
    dive.told = hooks::extctl::kFirstDiveDepth;
    at(PortSensor::WantsSurface).told = kSurfaceNow;
    mode_.told = static_cast<double>(kGliderPortModeSurface);
  }
  climb.told = hooks::extctl::kFirstClimbDepth;
  climbs_.tell(hooks::extctl::kFirstClimbDepth, now_s_);
}

/// A clock that was set back counts as over.
bool PortWriter::isOver(double since_s, double seconds) const {
  return now_s_ - since_s >= seconds || now_s_ < since_s;
}

void PortWriter::want(Value& value, double wanted) {
  if (value.wanted == value.told || value.wanted != value.wanted) {
    value.pending_s = now_s_;
  }
  value.wanted = hooks::asSixDecimals(wanted);
}

void PortWriter::tellNow(Value& value) {
  if (value.wanted != value.told) {
    value.told = value.wanted;
    value.due = kTimes;
  }
}

void PortWriter::InForce::tell(double depth_m, double now_s) {
  if (count_ == kMost) {
    for (uint32_t i = 1; i < kMost; ++i) {
      depths_m_[i - 1] = depths_m_[i];
      until_s_[i - 1] = until_s_[i];
    }
    --count_;
  }
  if (count_ != 0) {
    until_s_[count_ - 1] = now_s;
  }
  depths_m_[count_++] = depth_m;
}

void PortWriter::InForce::range(double now_s, double* shallowest, double* deepest) const {
  *shallowest = *deepest = depths_m_[count_ - 1];
  for (uint32_t i = 0; i + 1 < count_; ++i) {
    const double age_s = now_s - until_s_[i];
    if (age_s >= 0 && age_s < hooks::extctl::kSettleSecs) {
      *shallowest = hookAtMost(depths_m_[i], *shallowest);
      *deepest = hookAtLeast(depths_m_[i], *deepest);
    }
  }
}

void PortWriter::InForce::unsettle(double then_s, double now_s) {
  for (uint32_t i = 0; i + 1 < count_; ++i) {
    const double age_s = then_s - until_s_[i];
    until_s_[i] = age_s >= 0 && age_s < hooks::extctl::kSettleSecs ? now_s : until_s_[i];
  }
}

void PortWriter::tellDepths(const StockCommand& command) {
  Value& dive = at(PortSensor::DiveDepth);
  Value& climb = at(PortSensor::ClimbDepth);
  want(dive, command.dive_depth_m);
  want(climb, command.climb_depth_m);
  double shallowest = 0, deepest = 0;
  // The deeper end first: what it leaves room for is then decided with it.
  climbs_.range(now_s_, &shallowest, &deepest);
  if (dive.wanted != dive.told && dive.wanted > deepest) {
    if (dive.told != dive.told) {
      dives_.tell(greatest_depth_m_, now_s_);  // the one that this replaces
    }
    tellNow(dive);
    dives_.tell(dive.told, now_s_);
  }
  dives_.range(now_s_, &shallowest, &deepest);
  if (climb.wanted != climb.told && climb.wanted < shallowest) {
    tellNow(climb);
    climbs_.tell(climb.told, now_s_);
  }
}

/// Once no dive deeper than the newest can be in force. A target that changes all the time does not
/// keep the vehicle up for ever.
bool PortWriter::mayDive(const Value& value) {
  const Value& dive = at(PortSensor::DiveDepth);
  double shallowest = 0, deepest = 0;
  dives_.range(now_s_, &shallowest, &deepest);
  const bool settled = dive.told == dive.wanted && deepest <= dive.wanted;
  return isOver(value.pending_s, (settled ? 1 : 2) * hooks::extctl::kSettleSecs);
}

/// Up at once; down once the vehicle knows for which depths.
void PortWriter::tellWhetherToSurface(const StockCommand& command) {
  Value& wish = at(PortSensor::WantsSurface);
  want(wish, command.surface ? kSurfaceNow : 0);
  want(mode_, static_cast<double>(command.modes));
  const bool dives = !command.surface && wish.told != 0;  // or may: the start is unknown
  Value* values[] = {&wish, &mode_};
  for (Value* value : values) {
    if (command.surface ||
        (dives ? mayDive(*value) : isOver(value->pending_s, hooks::extctl::kSettleSecs))) {
      tellNow(*value);
    }
  }
}

void PortWriter::tell(const StockCommand& command, double now_s) {
  if (forgets_) {
    forgets_ = false;
    dives_.unsettle(now_s_, now_s);
    climbs_.unsettle(now_s_, now_s);
    for (Value& value : values_) {
      value.pending_s = now_s;
    }
    mode_.pending_s = now_s;
  }
  now_s_ = now_s;
  if (!begun_) {
    begin();
  }
  const struct {
    PortSensor sensor;
    double value;
  } kAtOnce[] = {
      {PortSensor::Heading, command.heading_rad},
      {PortSensor::WaypointLongitude, command.waypoint_longitude_ddmm},
      {PortSensor::WaypointLatitude, command.waypoint_latitude_ddmm},
      {PortSensor::DivePitch, command.dive_pitch_rad},
      {PortSensor::ClimbPitch, command.climb_pitch_rad},
  };
  for (const auto& [sensor, value] : kAtOnce) {
    want(at(sensor), value);
    tellNow(at(sensor));
  }
  tellDepths(command);
  tellWhetherToSurface(command);
}

void PortWriter::forget() {
  all_s_ = now_s_ - kAgainSecs;
  forgets_ = true;
}

void PortWriter::insist() {
  at(PortSensor::WantsSurface).due = kTimes;
  mode_.due = kTimes;
}

uint32_t PortWriter::write(const Mission& mission, bool steers, char* text, uint32_t capacity) {
  beat_ = beat_ % kMostBeats + 1;
  const struct {
    PortSensor sensor;
    double value;
  } kEachTime[] = {{PortSensor::State, static_cast<double>(mission.state)},
                   {PortSensor::Beat, static_cast<double>(beat_)},
                   {PortSensor::Time, mission.time_s}};
  for (const auto& [sensor, value] : kEachTime) {
    at(sensor).told = at(sensor).wanted = value;
    at(sensor).due = 1;
  }
  if (steers && isOver(all_s_, kAgainSecs)) {
    all_s_ = now_s_;
    mode_.due = mode_.due == 0 ? 1 : mode_.due;
    for (Value& value : values_) {
      value.due = value.due == 0 ? 1 : value.due;
    }
  }
  const uint32_t modes = steers ? writeModes(text, capacity) : 0;
  return modes + writeValues(steers ? 0 : static_cast<uint32_t>(PortSensor::State), text + modes,
                             capacity - modes);
}

uint32_t PortWriter::writeModes(char* text, uint32_t capacity) {
  if (!modes_ || mode_.due == 0 || mode_.told != mode_.told || mode_.wanted != mode_.wanted) {
    return 0;
  }
  --mode_.due;
  SentenceWriter sentence(text, capacity);
  sentence.put("MD,");
  sentence.put(kAllModes);
  sentence.put(',');
  sentence.put(static_cast<uint32_t>(mode_.told));
  return sentence.end();
}

uint32_t PortWriter::writeValues(uint32_t first, char* text, uint32_t capacity) {
  SentenceWriter sentence(text, capacity);
  sentence.put("SW");
  for (uint32_t i = first; i < hooks::extctl::kWrittenSensors; ++i) {
    Value& value = values_[i];
    // Nothing is written that no command has asked for: another mission file may be flying.
    if (value.due == 0 || value.told != value.told || value.wanted != value.wanted) {
      continue;
    }
    --value.due;
    sentence.put(',');
    sentence.put(i);
    sentence.put(':');
    sentence.put(value.told);
  }
  return sentence.end();
}

}  // namespace glider::runtime::extctl
