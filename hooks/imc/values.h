// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// What the numbers in the fields of messages mean. The fields stay plain numbers: a newer vehicle
/// may send values that are not listed here.
namespace glider::hooks::imc {

/// As destination: all. As FollowReference.control_src: any. DUNE starts no plan that is sent to
/// it.
inline constexpr uint16_t kAllSystems = 0xFFFF;
/// As destination: the vehicle whose DUNE receives it, without knowing its id.
inline constexpr uint16_t kThisDune = 0xFFF0;
inline constexpr uint8_t kAnyEntity = 255;
inline constexpr uint8_t kSystemEntity = 0;

// Each enumeration is within a struct, so that its names need a prefix and its values are numbers.

struct SystemType {
  enum : uint8_t { ControlStation = 0, UnderwaterVehicle = 2 };
};

struct LogEntryType {
  enum : uint8_t { Information = 0 };
};

struct GpsValidity {
  enum : uint16_t { Position = 4 };
};
struct GpsType {
  enum : uint8_t { Simulation = 4 };
};

struct ZUnits {
  enum : uint8_t { None, Depth, Altitude, Height };
};
struct SpeedUnits {
  enum : uint8_t { MetresPerSecond, Rpm, Percent };
};

/// Bits of Reference.flags.
struct ReferenceFlag {
  enum : uint8_t {
    Location = 1,  ///< with Location and without Z the vehicle surfaces
    Speed = 2,
    Z = 4,
    Radius = 8,
    StartPoint = 16,
    Direct = 32,
    Done = 128  ///< the plan is completed
  };
};

struct FollowState {
  enum : uint8_t { Wait = 1, Goto, Loiter, Hover, Elevator, Timeout };
};

/// Bits of FollowRefState.proximity.
struct Proximity {
  enum : uint8_t { Far = 1, NearInXy = 2, NearInZ = 4, UnreachableXy = 8, UnreachableZ = 16 };
};

struct OperationMode {
  enum : uint8_t { Service, Calibration, Error, Maneuver, External, Boot };
};

struct Medium {
  enum : uint8_t { OnGround, InAir, WaterSurface, UnderWater, Unknown };
};

struct PlanControlType {
  enum : uint8_t { Request, Success, Failure, InProgress };
};
struct PlanOperation {
  enum : uint8_t { Start, Stop, Load, Get };
};

/// Bits of PlanControl.flags.
struct PlanFlag {
  enum : uint16_t { Calibrate = 1, IgnoreErrors = 2 };
};

struct PlanState {
  enum : uint8_t { Blocked, Ready, Initializing, Executing };
};
struct PlanOutcome {
  enum : uint8_t { None, Success, Failure };
};

}  // namespace glider::hooks::imc
