// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/facts_json.h"

#include <nlohmann/json.hpp>

#include <array>

namespace glider::report {
namespace {

using nlohmann::json;

const char* verdictName(support::Verdict verdict) {
  constexpr std::array<const char*, 4> kNames = {"held", "violated", "not checked", "not decided"};
  return kNames.at(static_cast<size_t>(verdict));
}

json promisesOf(const support::MissionFacts& facts) {
  json out = json::array();
  for (const support::FlownPromise& promise : facts.promises) {
    out.push_back({{"text", promise.text},
                   {"verdict", verdictName(promise.verdict)},
                   {"time", promise.vehicle_time_s ? json(*promise.vehicle_time_s) : json()},
                   {"words", promise.words}});
  }
  return out;
}

json loggedOf(const support::MissionFacts& facts) {
  json out = json::array();
  for (const support::LoggedValue& one : facts.logged) {
    out.push_back(
        {{"column", one.column}, {"text", one.text}, {"value", one.value}, {"half", one.half}});
  }
  return out;
}

json placesOf(const support::MissionFacts& facts) {
  json out = json::array();
  for (const support::NamedPlace& place : facts.places) {
    out.push_back(
        {{"name", place.name}, {"lat", place.latitude_deg}, {"lon", place.longitude_deg}});
  }
  return out;
}

json watchesOf(const support::MissionFacts& facts) {
  json out = json::array();
  for (const support::WatchCircle& circle : facts.watch_circles) {
    out.push_back(
        {{"lat", circle.latitude_deg}, {"lon", circle.longitude_deg}, {"radius", circle.radius_m}});
  }
  return out;
}

}  // namespace

std::string factsToJson(const support::Trace& trace) {
  const json out = {
      {"listed", trace.facts.listed},
      {"read", trace.facts.read},
      {"logged", loggedOf(trace.facts)},
      {"promises", promisesOf(trace.facts)},
      {"places", placesOf(trace.facts)},
      {"watches", watchesOf(trace.facts)},
      {"bottom",
       {{"x", trace.bottom.x_m}, {"y", trace.bottom.y_m}, {"depths", trace.bottom.depths_m}}}};
  return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string promisesToJson(const support::MissionFacts& facts) {
  return promisesOf(facts).dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace glider::report
