// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookprog/hookprog.h"
#include "hooks/protocol/sensors.h"
#include "tests/slocum.h"

#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace glider::hooks {

using SensorUpdate = SensorValue;

/// A stand-in for the vehicle's own line between the data memories of its two computers, and for
/// the memory of the science computer. Without settings it is fast and loses nothing.
class VehicleLine {
 public:
  explicit VehicleLine(uint32_t seed = 1) : random_(seed) {}

  /// What science sets is as late as `least` to `most` seconds, each value by itself.
  void setLag(double least, double most) {
    least_s_ = least;
    most_s_ = most;
  }
  /// Of the values so great a share is lost.
  void setLoss(double share) { loss_ = share; }
  /// After so great a share of what science sets an earlier value comes again, however old.
  void setReplays(double share) { replays_ = share; }
  /// What science sets in these sensors does not arrive.
  void drop(std::set<uint16_t> sensors) { dropped_ = std::move(sensors); }
  void passTime(double seconds) { now_s_ += seconds; }

  /// The flight controller's report of a cycle, and what has come to it.
  void fromFlight(const std::vector<SensorUpdate>& report) {
    for (const SensorUpdate& update : report) {
      send(to_science_, update);
    }
  }
  std::vector<SensorUpdate> atFlight() { return arrived(to_flight_); }

  /// The memory as a proglet sees it; `own` has the sensors of the science computer's instruments.
  using Own = std::function<double(uint16_t, bool*)>;
  ScienceMemory memory(Own own) {
    own_ = std::move(own);
    for (const SensorUpdate& update : arrived(to_science_)) {
      values_[update.id] = update.value;
      fresh_.insert(update.id);
    }
    return {this, get, set};
  }
  ScienceMemory memory() {
    return memory([](uint16_t, bool* fresh) {
      *fresh = false;
      return std::nan("");
    });
  }
  /// What proglets have set, in order; forgets it.
  std::vector<SensorUpdate> takeSet() { return std::exchange(set_, {}); }

 private:
  struct Passing {
    double due_s;
    SensorUpdate update;
  };
  struct Way {
    std::deque<Passing> passing;
    std::vector<SensorUpdate> earlier;
  };

  void send(Way& way, const SensorUpdate& update) {
    if (chance_(random_) < loss_) {
      return;
    }
    pass(way, update);
    if (replays_ > 0 && &way == &to_flight_) {
      way.earlier.push_back(update);
      if (chance_(random_) < replays_) {
        pass(way, way.earlier[random_() % way.earlier.size()]);
      }
    }
  }
  void pass(Way& way, const SensorUpdate& update) {
    const bool is_late = &way == &to_flight_;
    double due_s = now_s_ + (is_late ? least_s_ + (most_s_ - least_s_) * chance_(random_) : 0);
    for (const Passing& before : way.passing) {
      due_s = before.update.id == update.id ? std::max(due_s, before.due_s) : due_s;
    }
    way.passing.push_back({due_s, update});
  }
  std::vector<SensorUpdate> arrived(Way& way) {
    std::vector<SensorUpdate> there;
    std::deque<Passing> rest;
    for (const Passing& one : way.passing) {
      if (one.due_s <= now_s_) {
        there.push_back(one.update);
      } else {
        rest.push_back(one);
      }
    }
    way.passing = std::move(rest);
    return there;
  }
  static double get(void* self, uint16_t id, bool* fresh) {
    auto& line = *static_cast<VehicleLine*>(self);
    if (isScienceSensor(id)) {
      return line.own_(id, fresh);
    }
    *fresh = line.fresh_.erase(id) != 0;
    const auto found = line.values_.find(id);
    return found == line.values_.end() ? std::nan("") : found->second;
  }
  static void set(void* self, uint16_t id, double value) {
    auto& line = *static_cast<VehicleLine*>(self);
    line.set_.push_back({id, value});
    if (!line.dropped_.contains(id)) {
      line.send(line.to_flight_, {id, value});
    }
  }

  double now_s_ = 0, least_s_ = 0, most_s_ = 0, loss_ = 0, replays_ = 0;
  std::set<uint16_t> dropped_;
  Way to_flight_, to_science_;
  Own own_;
  std::map<uint16_t, double> values_;
  std::set<uint16_t> fresh_;
  std::vector<SensorUpdate> set_;
  std::mt19937 random_;
  std::uniform_real_distribution<double> chance_{0, 1};
};

}  // namespace glider::hooks
