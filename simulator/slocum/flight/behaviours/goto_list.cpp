// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/behaviours/goto_list.h"

#include <algorithm>
#include <utility>

namespace glider::simulator {
namespace {

constexpr int kAfterLastReached = -1, kNearest = -2;  // initial_wpt
constexpr int kOnce = -2;                             // num_legs_to_run
constexpr int kStays = 6;                             // end_action

}  // namespace

GotoList::GotoList(const BehaviourSource& source)
    : StartedBehaviour(source),
      stop_(source.code("list_stop_when"),
            {.secs = {0, source.variables}, .distance_m = source.argument("list_when_wpt_dist")},
            source.code_15, true),
      initial_(source.code("initial_wpt")),
      legs_to_run_(source.code("num_legs_to_run")),
      stays_(source.code("end_action") == kStays) {
  for (const slocum::Waypoint& waypoint : source.block.waypoints) {
    places_.push_back({WaypointUnits::LatLon,
                       {waypoint.longitude_ddmm, source.variables},
                       {waypoint.latitude_ddmm, source.variables}});
  }
  const auto stated = static_cast<size_t>(std::max(0, source.code("num_waypoints")));
  for (size_t i = places_.size(); i < stated && source.block.waypoints.empty(); ++i) {
    const std::string number = std::to_string(i);
    places_.push_back({static_cast<WaypointUnits>(source.code("wpt_units_" + number)),
                       source.argument("wpt_x_" + number), source.argument("wpt_y_" + number)});
  }
}

WaypointPosition GotoList::at(const Situation& s, size_t number) const {
  const Place& place = places_[number];
  return s.geography->position(place.units, place.x(), place.y());
}

size_t GotoList::first(const Situation& s) const {
  if (initial_ == kAfterLastReached) {
    return static_cast<size_t>(last_reached_ + 1) % places_.size();
  }
  if (initial_ != kNearest) {
    return std::min(static_cast<size_t>(std::max(0, initial_)), places_.size() - 1);
  }
  size_t nearest = 0;
  const WaypointPosition here{s.latitude_ddmm, s.longitude_ddmm};
  for (size_t i = 1; i < places_.size(); ++i) {
    if (Geography::distance(here, at(s, i)) < Geography::distance(here, at(s, nearest))) {
      nearest = i;
    }
  }
  return nearest;
}

int GotoList::legs(size_t first) const {
  return legs_to_run_ == kOnce ? static_cast<int>(places_.size() - first) : legs_to_run_;
}

void GotoList::begin(const Situation& s) {
  StartedBehaviour::begin(s);
  stop_.restart(s.time_s);
  current_ = first(s);
  wanted_ = legs(current_);
  reached_ = 0;
  over_ = false;
  fresh_ = true;
}

Behaviour::Outcome GotoList::fly(const Situation& s, Commands& commands) {
  if (!std::exchange(fresh_, false) && !over_ && stop_.met(s, commands)) {
    commands.hit_waypoint = true;
    last_reached_ = static_cast<int>(current_);
    news_.push_back({EventId::WaypointReached, {label(), static_cast<double>(current_)}});
    if (wanted_ >= 0 && ++reached_ >= wanted_) {
      if (!stays_) {
        return Outcome::Done;
      }
      over_ = true;
    } else {
      current_ = (current_ + 1) % places_.size();
      stop_.restart(s.time_s);
      fresh_ = true;
    }
  }
  const WaypointPosition to = at(s, current_);
  commands.steer({HeadingCommand::Mode::Waypoint, 0, to.latitude_ddmm, to.longitude_ddmm});
  return Outcome::Continue;
}

void GotoList::tell(double time_s, Journal& journal) {
  journal.add(time_s, news_);
}

}  // namespace glider::simulator
