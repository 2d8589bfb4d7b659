// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/imc/readings.h"

#include "hooks/imc/values.h"
#include "runtime/imc/position.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime::imc {
namespace {

using namespace hooks::imc;

constexpr double kBarPerHectopascal = 1e-3;
constexpr double kQuarterTurn = kTwoPi / 4;

/// In [0, 2 pi), if it is in [-pi, pi]; what is no number stays none.
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

void Readings::takeState(const EstimatedState& state) {
  if (isOnEarth(state.lat, state.lon) && isFinite(state.x) && isFinite(state.y)) {
    const Place place = displaced({state.lat * kDegreesPerRadian, state.lon * kDegreesPerRadian},
                                  static_cast<double>(state.x), static_cast<double>(state.y));
    latitude_ = place.latitude;
    longitude_ = place.longitude;
    set(Reading::Latitude, ddmmOf(latitude_));
    set(Reading::Longitude, ddmmOf(longitude_));
  }
  set(Reading::Depth, static_cast<double>(state.depth));
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
    set(Reading::FixLongitude, ddmmOf(fix.lon * kDegreesPerRadian));
  }
}

void Readings::take(const Packet& packet) {
  set(Reading::Clock, packet.header.time_s);
  const auto number = [&](auto message, Reading reading, double factor) {
    if (decode(packet, message)) {
      set(reading, static_cast<double>(message.value) * factor);
    }
  };
  switch (packet.id) {
    case EstimatedState::kId: {
      EstimatedState state;
      if (decode(packet, state)) {
        takeState(state);
      }
      break;
    }
    case GpsFix::kId: {
      GpsFix fix;
      if (decode(packet, fix)) {
        takeFix(fix);
      }
      break;
    }
    case VehicleMedium::kId: {
      VehicleMedium medium;
      if (decode(packet, medium)) {
        set(Reading::Medium, medium.medium);
      }
      break;
    }
    case EstimatedStreamVelocity::kId: {
      EstimatedStreamVelocity water;
      if (decode(packet, water)) {
        set(Reading::CurrentNorth, water.x);
        set(Reading::CurrentEast, water.y);
      }
      break;
    }
    case Temperature::kId:
      return number(Temperature(), Reading::Temperature, 1);
    case Salinity::kId:
      return number(Salinity(), Reading::Salinity, 1);
    case Conductivity::kId:
      return number(Conductivity(), Reading::Conductivity, 1);
    case Pressure::kId:
      return number(Pressure(), Reading::Pressure, kBarPerHectopascal);
    case FuelLevel::kId:
      return number(FuelLevel(), Reading::FuelLevel, 1);
    case Voltage::kId:
      return number(Voltage(), Reading::Voltage, 1);
    case Rpm::kId:
      return number(Rpm(), Reading::Rpm, 1);
    case Chlorophyll::kId:
      return number(Chlorophyll(), Reading::Chlorophyll, 1);
    case Turbidity::kId:
      return number(Turbidity(), Reading::Turbidity, 1);
    case DissolvedOxygen::kId:
      return number(DissolvedOxygen(), Reading::Oxygen, 1);
    default:
      break;
  }
}

}  // namespace glider::runtime::imc
