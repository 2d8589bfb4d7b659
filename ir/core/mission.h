// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/source_manager.h"
#include "support/units/units.h"

#include <array>
#include <compare>
#include <cstdint>
#include <string>
#include <vector>

/// The typed mission IR: what the frontend lowers to, the verifier proves things of, the
/// interpreter `ir/eval` runs and codegen compiles. Everything is an index into a vector of
/// Mission. ir/README.md states what a tick means.
namespace glider::ir {

template <typename Tag>
struct Id {
  uint32_t index = UINT32_MAX;
  [[nodiscard]] bool valid() const { return index != UINT32_MAX; }
  auto operator<=>(const Id&) const = default;
};
using ExprId = Id<struct ExprTag>;
using StateId = Id<struct StateTag>;
using SensorId = Id<struct SensorTag>;
using BehaviourId = Id<struct BehaviourTag>;

enum class Op : uint8_t {
#define OP(name, text, operands, result) name,
#include "ir/core/ops.def"
#undef OP
};

enum class TypeKind : uint8_t { Bool, Quantity, Latitude, Longitude };

/// The type of an expression or parameter. Latitudes and longitudes are numbers in degrees, north
/// and east positive.
struct Type {
  TypeKind kind = TypeKind::Quantity;
  support::Dimension dimension;  ///< of a Quantity
  bool operator==(const Type&) const = default;
};

/// One node; operands stand before it in Mission::exprs, so the vector is in evaluation order.
struct Expr {
  Op op = Op::Constant;
  Type type;
  std::array<ExprId, 3> operands;
  double number = 0;  ///< Constant: the value in SI units (finite), or degrees
  SensorId sensor;    ///< Sensor, Age
  support::SourceRange range;
};

/// How the vehicle writes a sensor's value down.
enum class Encoding : uint8_t {
  Linear,
  DegreesMinutes
};  ///< DegreesMinutes: ddmm.mmmm, becomes degrees

/// A vehicle's sensor that this mission subscribes.
struct Sensor {
  std::string name;          ///< as written in the mission: "depth"
  std::string vehicle_name;  ///< "m_depth"
  uint16_t id = 0;           ///< number in the platform file: the id on the wire
  Type type;
  Encoding encoding = Encoding::Linear;
  double to_si = 1;   ///< factor from the vehicle's unit
  double lowest = 0;  ///< plausible range in the vehicle's unit; a reading outside is unknown
  double highest = 0;
  double stale_after_s = 0;  ///< a reading older than this is unknown
};

enum class BehaviourKind : uint8_t { Profile, Route };

struct Parameter {
  std::string name;
  Type type;
};

/// A flightprofile or flightroute that a C function implements (ABI: runtime/abi/behaviour.h).
struct Behaviour {
  std::string name;    ///< "yo"
  std::string symbol;  ///< "gliderProfileYo"
  BehaviourKind kind = BehaviourKind::Profile;
  std::vector<Parameter> parameters;
  std::vector<SensorId> reads;
};

/// A use of a behaviour by a state; the arguments are evaluated anew on every tick.
struct Activity {
  BehaviourId behaviour;
  std::vector<ExprId> arguments;
  support::SourceRange range;
};

enum class Transition : uint8_t { Goto, Call, Return, Exit, Stay };

struct Case {
  ExprId guard;
  Transition transition = Transition::Stay;
  StateId target;  ///< of Goto and Call
  support::SourceRange range;
};

/// A value that the SBC logs while the state is current.
struct LogItem {
  std::string name;
  ExprId value;
  double period_s = 0;  ///< at most once in this time; 0: every tick
};

struct State {
  std::string name;
  Activity profile;
  Activity route;
  std::vector<LogItem> log;
  std::vector<Case> cases;
  support::SourceRange range;  ///< of its name
};

struct Mission {
  std::string name;
  std::string platform;
  std::vector<Sensor> sensors;
  std::vector<Behaviour> behaviours;
  std::vector<Expr> exprs;
  std::vector<State> states;  ///< the first is where the mission starts

  [[nodiscard]] const Expr& operator[](ExprId id) const { return exprs.at(id.index); }
  [[nodiscard]] const State& operator[](StateId id) const { return states.at(id.index); }
  [[nodiscard]] const Sensor& operator[](SensorId id) const { return sensors.at(id.index); }
  [[nodiscard]] const Behaviour& operator[](BehaviourId id) const {
    return behaviours.at(id.index);
  }
};

/// What the verifier found out and codegen needs: only for missions without errors.
struct MissionFacts {
  uint32_t stack_depth = 0;  ///< greatest number of frames on the call stack
  std::vector<StateId>
      deepest_path;  ///< the states of such a stack, outermost first, then the current
};

}  // namespace glider::ir
