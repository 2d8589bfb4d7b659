// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/recon/codec.h"
#include "tests/unit/hooks/recon_described.h"

#include <string>
#include <string_view>

/// The fields of the messages of hooks/recon by the names of the second codec.
namespace glider::recon_named {

using namespace hooks::recon;
using recon_described::Values;

template <typename V>
void each(V& v, HeadingGoal& m) {
  v("heading_deg", m.heading_deg);
}
template <typename V>
void each(V& v, SpeedGoal& m) {
  v("value", m.value);
  v("unit", m.unit);
}
template <typename V>
void each(V& v, DepthGoal& m) {
  v("depth_m", m.depth_m);
}
template <typename V>
void each(V& v, TriangleGoal& m) {
  v("depth_m", m.depth_m);
  v("altitude_m", m.altitude_m);
  v("rate", m.rate);
  v("greatest_depth_m", m.greatest_depth_m);
}
template <typename V>
void each(V& v, Override& m) {
  v("on", m.on);
}
template <typename V>
void each(V& /*v*/, KeepAlive& /*m*/) {}
template <typename V>
void each(V& /*v*/, TimeQuery& /*m*/) {}
template <typename V>
void each(V& /*v*/, Shutdown& /*m*/) {}
template <typename V>
void each(V& v, ModemText& m) {
  v("text", m.text);
}
template <typename V>
void each(V& v, SimulationText& m) {
  v("text", m.text);
}
template <typename V>
void each(V& v, TimeSet& m) {
  v("unix_s", m.unix_s);
}
template <typename V>
void each(V& v, ModemData& m) {
  v("source", m.source);
  v("destination", m.destination);
  v("text", m.text);
}
template <typename V>
void each(V& v, Ctd& m) {
  v("temperature_degC", m.temperature_degC);
  v("conductivity", m.conductivity);
  v("salinity", m.salinity);
  v("depth_m", m.depth_m);
  v("sound_speed_m_s", m.sound_speed_m_s);
}
template <typename V>
void each(V& v, State& m) {
  v("time_s", m.time_s);
  v("latitude_deg", m.latitude_deg);
  v("longitude_deg", m.longitude_deg);
  v("depth_m", m.depth_m);
  v("depth_goal_m", m.depth_goal_m);
  v("altitude_m", m.altitude_m);
  v("pitch_deg", m.pitch_deg);
  v("roll_deg", m.roll_deg);
  v("rpm", m.rpm);
  v("rpm_goal", m.rpm_goal);
  v("speed_m_s", m.speed_m_s);
  v("heading_deg", m.heading_deg);
  v("heading_rate_deg_s", m.heading_rate_deg_s);
  v("heading_goal_deg", m.heading_goal_deg);
  v("mode", m.mode);
  v("leg", m.leg);
}

/// Reads the fields of a message.
struct Reader {
  Values values;
  void operator()(const char* name, SpeedUnit unit) {
    values[name].text = unit == SpeedUnit::Rpm ? "rpm" : "meters/sec";
  }
  void operator()(const char* name, const Text& text) {
    values[name].text.assign(text.bytes, text.size);
  }
  template <typename Number>
  void operator()(const char* name, Number number) {
    values[name].number = static_cast<double>(number);
  }
};

/// Sets the fields of a message; texts stay in `values`.
struct Setter {
  const Values& values;
  void operator()(const char* name, SpeedUnit& unit) {
    unit = values.at(name).text == "rpm" ? SpeedUnit::Rpm : SpeedUnit::MetresPerSecond;
  }
  void operator()(const char* name, Text& text) { text = textOf(values.at(name).text.c_str()); }
  template <typename Number>
  void operator()(const char* name, Number& number) {
    number = static_cast<Number>(values.at(name).number);
  }
};

/// Calls f with an empty message of this name; false if there is none.
template <typename F>
bool withMessage(std::string_view name, F f) {
#define RECON_MESSAGE(type) \
  if (name == #type) {      \
    f(type());              \
    return true;            \
  }
#include "hooks/recon/messages.def"
#undef RECON_MESSAGE
  return false;
}

}  // namespace glider::recon_named
