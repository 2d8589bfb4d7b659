// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/imc/readings.h"

#include "hooks/imc/values.h"
#include "runtime/front_seat/position.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime::imc {
namespace {

using namespace hooks::imc;

constexpr double kBarPerHectopascal = 1e-3;
/// A depth of -1 means that it is not known; one just above the surface is a reading.
constexpr float kInvalid_m = -0.9F;
constexpr double kQuarterTurn = kTwoPi / 4;

/// Between -180 and 180.
double longitudeOf(double degrees) {
  return degrees > 180 ? degrees - 360 : degrees < -180 ? degrees + 360 : degrees;
}

/// In [0, 2 pi); unknown stays so.
double turnOf(double angle) {
  const double positive = angle < 0 ? angle + kTwoPi : angle;
  return positive == kTwoPi ? 0.0 : positive;
}

bool isOnEarth(double latitude_rad, double longitude_rad) {
  return magnitude(latitude_rad) <= kQuarterTurn && magnitude(longitude_rad) <= kTwoPi;
}

}  // namespace

Readings::Readings() {
  for (double& value : values_) {
    value = __builtin_nan("");
  }
}

void Readings::set(Reading reading, double value) {
  if (isFinite(value)) {
    values_[index(reading)] = value;
    fresh_[index(reading)] = true;
  }
}

bool Readings::takeReport(Reading reading, double* value) {
  const bool fresh = fresh_[index(reading)];
  fresh_[index(reading)] = false;
  *value = values_[index(reading)];
  return fresh;
}

void Readings::forget(Reading reading) {
  values_[index(reading)] = __builtin_nan("");
  fresh_[index(reading)] = false;
}

void Readings::takeState(const EstimatedState& state) {
  if (isOnEarth(state.lat, state.lon) && isFinite(state.x) && isFinite(state.y)) {
    const Place place = displaced({state.lat * kDegreesPerRadian, state.lon * kDegreesPerRadian},
                                  static_cast<double>(state.x), static_cast<double>(state.y));
    latitude_ = place.latitude;
    longitude_ = longitudeOf(place.longitude);
    set(Reading::Latitude, ddmmOf(latitude_));
    set(Reading::Longitude, ddmmOf(longitude_));
  }
  if (isFinite(static_cast<double>(state.depth)) && state.depth <= kInvalid_m) {
    values_[index(Reading::Depth)] = __builtin_nan("");
  } else {
    set(Reading::Depth, static_cast<double>(state.depth));
  }
  set(Reading::DepthRate, static_cast<double>(state.vz));
  if (state.alt >= 0) {  // -1: unknown
    set(Reading::Altitude, static_cast<double>(state.alt));
  }
  set(Reading::Roll, static_cast<double>(state.phi));
  set(Reading::Pitch, static_cast<double>(state.theta));
  set(Reading::Heading, turnOf(static_cast<double>(state.psi)));
  set(Reading::Speed, static_cast<double>(state.u));
}

void Readings::takeFix(const GpsFix& fix) {
  if ((fix.validity & GpsValidity::Position) != 0 && isOnEarth(fix.lat, fix.lon)) {
    set(Reading::FixLatitude, ddmmOf(fix.lat * kDegreesPerRadian));
    set(Reading::FixLongitude, ddmmOf(longitudeOf(fix.lon * kDegreesPerRadian)));
  }
}

/// A message with one number.
void Readings::takeNumber(const Packet& packet) {
  const auto number = [&](auto message, Reading reading, double factor = 1) {
    if (decode(packet, message)) {
      set(reading, static_cast<double>(message.value) * factor);
    }
  };
  switch (packet.id) {
    case Temperature::kId:
      return number(Temperature(), Reading::Temperature);
    case Salinity::kId:
      return number(Salinity(), Reading::Salinity);
    case Conductivity::kId:
      return number(Conductivity(), Reading::Conductivity);
    case Pressure::kId:
      return number(Pressure(), Reading::Pressure, kBarPerHectopascal);
    case FuelLevel::kId:
      return number(FuelLevel(), Reading::FuelLevel);
    case Voltage::kId:
      return number(Voltage(), Reading::Voltage);
    case Rpm::kId:
      return number(Rpm(), Reading::Rpm);
    case Chlorophyll::kId:
      return number(Chlorophyll(), Reading::Chlorophyll);
    case Turbidity::kId:
      return number(Turbidity(), Reading::Turbidity);
    case DissolvedOxygen::kId:
      return number(DissolvedOxygen(), Reading::Oxygen);
    default:
      break;
  }
}

void Readings::take(const Packet& packet) {
  set(Reading::Clock, packet.header.time_s);
  if (EstimatedState state; packet.id == EstimatedState::kId && decode(packet, state)) {
    takeState(state);
  } else if (GpsFix fix; packet.id == GpsFix::kId && decode(packet, fix)) {
    takeFix(fix);
  } else if (VehicleMedium in; packet.id == VehicleMedium::kId && decode(packet, in)) {
    set(Reading::Medium, in.medium);
  } else if (EstimatedStreamVelocity water;
             packet.id == EstimatedStreamVelocity::kId && decode(packet, water)) {
    set(Reading::CurrentNorth, water.x);
    set(Reading::CurrentEast, water.y);
  } else {
    takeNumber(packet);
  }
}

}  // namespace glider::runtime::imc
