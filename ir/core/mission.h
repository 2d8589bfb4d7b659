// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/transition.h"
#include "support/source_range.h"
#include "support/units/units.h"

#include <array>
#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// The typed mission IR: the frontend lowers to it, the verifier proves properties of it, the
/// interpreter `ir/eval` runs it and codegen compiles it. Everything is an index into a vector of
/// Mission. ir/README.md defines what a tick means.
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
using VariableId = Id<struct VariableTag>;
using TemporalId = Id<struct TemporalTag>;
using BlockId = Id<struct BlockTag>;
using TableId = Id<struct TableTag>;
using FunctionId = Id<struct FunctionTag>;
using UseId = Id<struct UseTag>;

enum class Op : uint8_t {
#define OP(name, ...) name,
#include "ir/core/ops.def"
};

enum class TypeKind : uint8_t { Bool, Quantity, Latitude, Longitude };

/// The type of an expression or parameter. Latitudes and longitudes are numbers in degrees, north
/// and east positive.
struct Type {
  TypeKind kind = TypeKind::Quantity;
  support::Dimension dimension;  ///< of a Quantity
  bool operator==(const Type&) const = default;
};

constexpr size_t kMostOperands = 8;

/// One node; its operands precede it in Mission::exprs, so the vector is in evaluation order.
struct Expr {
  Op op = Op::Constant;
  Type type;
  std::array<ExprId, kMostOperands> operands;
  double number = 0;    ///< Constant: the value in SI units (finite), or degrees
  SensorId sensor;      ///< Sensor, Age
  VariableId variable;  ///< Variable
  TemporalId temporal;  ///< Temporal
  TableId table;        ///< Element
  UseId use;            ///< Call
  support::SourceRange range;
};

/// How the vehicle encodes a sensor's value.
enum class Encoding : uint8_t {
  Linear,
  DegreesMinutes,  ///< ddmm.mmmm, becomes degrees
  Magnetic  ///< linear; a heading from magnetic north, which frames already contain from true north
};

/// Sensors numbered from here on are not the vehicle's: what its modem receives of others.
constexpr uint16_t kFirstHeardSensor = 0xFE00;
/// From here on they are the SBC's own, which it polls.
constexpr uint16_t kFirstOwnSensor = 0xFF00;

/// A vehicle's sensor that this mission subscribes, one of the SBC's own, or what is received of
/// others.
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
  /// The C function that is called for a reading once a tick (GliderPoll of
  /// runtime/abi/glider_abi.h); empty for a sensor of the vehicle, and for what is received.
  std::string symbol = {};

  /// Whether it is what the vehicle's modem receives of others; such a sensor has no symbol.
  [[nodiscard]] bool isHeard() const { return id >= kFirstHeardSensor && id < kFirstOwnSensor; }
  /// Whether the vehicle measures it: it is neither the SBC's own nor received of others.
  [[nodiscard]] bool isOfVehicle() const { return symbol.empty() && !isHeard(); }
};

enum class BehaviourKind : uint8_t { Profile, Route };

struct Parameter {
  std::string name;
  Type type;
};

/// A C function that expressions call.
struct Function {
  std::string name;
  std::string symbol;
  std::vector<Parameter> parameters;  ///< at most kMostOperands; truth values as numbers: 0, 1, NaN
  Type result;
  double lowest = -std::numeric_limits<double>::infinity();  ///< a result outside is unknown
  double highest = std::numeric_limits<double>::infinity();
};

/// A place in the mission's text that calls a function: called at most once a tick, even if several
/// expressions represent it.
struct FunctionUse {
  FunctionId function;
  support::SourceRange range;
};

/// A flightprofile or flightroute: of a C function (ABI: runtime/abi/behaviour.h), or written in
/// the language. The body of the latter is in each Activity, made for that use.
struct Behaviour {
  std::string name;    ///< "yo"
  std::string symbol;  ///< c_symbols.h; empty: written in the language
  BehaviourKind kind = BehaviourKind::Profile;
  std::vector<Parameter> parameters;  ///< of a C function
  std::vector<SensorId> reads;        ///< of a C function
};

/// What is kept for longer than a tick. It holds a number (NaN: unknown) or a truth value, also
/// stored as a number: 0 false, 1 true, NaN unknown.
enum class VariableKind : uint8_t {
  Parameter,  ///< set when the mission is launched, then fixed; these come first in the vector
  Mission,    ///< starts with the mission
  Argument,   ///< a state's parameter, given by the transition that goes to or calls it
  State,      ///< starts when its state is entered by goto or call
  Profile,    ///< of a profile written in the language: as State
  Route,
  Monitor,   ///< of a requirement's monitor: starts with the mission; it is not compiled
  Momentary  ///< the same, but unknown at the end of each tick until the monitor sets it
};

/// Variables of these kinds come last in the vector.
constexpr bool isOfMonitor(VariableKind kind) {
  return kind == VariableKind::Monitor || kind == VariableKind::Momentary;
}

struct Variable {
  std::string name;  ///< unique: "upper", "leg.to", "search.profile.done"
  Type type;
  VariableKind kind = VariableKind::Mission;
  StateId owner;   ///< of the kinds Argument to Route
  ExprId initial;  ///< of all kinds but Argument and Momentary; a Parameter's is a Constant, True
                   ///< or False
  double lowest = -kEndless;  ///< its value, when known, lies between these (SI units, degrees)
  double highest = kEndless;
  support::SourceRange range;
  std::string unit{};  ///< of a Parameter that is a number of this unit, such as "uM"; else empty

  static constexpr double kEndless = std::numeric_limits<double>::infinity();
};

/// What is watched over time. It advances on every tick on which its list is current.
enum class TemporalKind : uint8_t {
  Became,  ///< true on the tick on which `operand` turns true
  Held,    ///< true while `operand` has been true for at least `duration`
  Mean,    ///< windows over the last `length` of time, or of what they are stretched along
  Lowest,
  Highest,
  Spread,      ///< highest less lowest
  Slope,       ///< of the line of least squares against time, or against what it is stretched along
  AtLowest,    ///< of a leg only: `operand` where `duration` was lowest
  AtHighest,   ///< of a leg only: `operand` where `duration` was highest
  Steepest,    ///< of a leg only: the steepest slope of `operand` against `duration`
  AtSteepest,  ///< of a leg only: `operand` where the slope of `duration` against it was steepest
  Number       ///< of legs that have begun
};

/// Which leg a window is over.
enum class Leg : uint8_t {
  None,  ///< a time or a stretch
  This,  ///< the dive or climb under way, or the last one that was
  Last   ///< the one before
};

struct Temporal {
  TemporalKind kind = TemporalKind::Became;
  ListKind list = ListKind::State;
  StateId state;   ///< of every list but Always
  ExprId operand;  ///< a truth value; of a window a number; temporals in it precede this one
  /// Of Held a time; of AtLowest and AtHighest the number that is compared; of Steepest and
  /// AtSteepest the other of the two numbers.
  ExprId duration;
  double length = 0;  ///< of a window: s, or the SI unit of `along`; positive; of a leg 0
  ExprId along;       ///< of a window over a stretch or leg: an expression that is a Sensor
  Leg leg = Leg::None;
  double dive = 0;  ///< of a window over a leg: the values of `along` that are legs; may be equal
  double climb = 0;
  support::SourceRange range;
};

/// What a statement makes the vehicle do: the functions of runtime/abi/behaviour.h.
enum class Command : uint8_t {
#define COMMAND(name, text, symbol, ...) name,
#include "ir/core/commands.def"
#undef COMMAND
};

enum class StatementKind : uint8_t { Set, If, Log, Command };

struct Statement {
  StatementKind kind = StatementKind::Set;
  VariableId variable;         ///< Set
  ExprId value;                ///< Set: what it becomes; If: the condition
  BlockId then;                ///< If; both precede the block that holds this statement
  BlockId otherwise;           ///< If; may be invalid: nothing
  std::string text;            ///< Log
  std::vector<ExprId> values;  ///< Log; Command: its arguments
  Command command = Command::Surface;
  support::SourceRange range;
};

struct Block {
  std::vector<Statement> statements;
};

struct Case {
  ExprId guard;
  BlockId action;  ///< `do`; invalid: nothing
  Transition transition = Transition::Stay;
  StateId target;                 ///< of Goto and Call
  std::vector<ExprId> arguments;  ///< for State::parameters of the target
  support::SourceRange range;
  /// It is not in the mission's text: it keeps a value that a word of the language needs, and
  /// stays. Pictures and lists of cases leave it out; such cases come last in their list.
  bool implied = false;
};

/// A place at which a number line is cut: values past it are greater than `at` or, for an inclusive
/// cut, not smaller.
struct Cut {
  double at = 0;
  bool inclusive = false;
  auto operator<=>(const Cut&) const = default;
};

/// A number that guards compare with constants. The cuts divide the number line into intervals,
/// numbered from 0 below the first cut; unknown has the last number.
struct GuardColumn {
  Op source = Op::MissionTime;  ///< Sensor or a clock
  SensorId sensor;              ///< of a Sensor
  std::vector<Cut> cuts;        ///< in order: at one place the inclusive one first
  [[nodiscard]] uint32_t unknown() const { return static_cast<uint32_t>(cuts.size()) + 1; }
};

/// The guard of case `number` is not true unless each column's number lies in its range of
/// intervals. If they all do, it is true if `exact`; otherwise the guard itself must be evaluated.
struct GuardRow {
  struct Range {
    uint32_t first = 0;
    uint32_t last = 0;
    bool operator==(const Range&) const = default;
  };
  uint32_t number = 0;
  std::vector<Range> within;  ///< one for each column
  bool exact = true;
};

/// Another form of the guards of a list of cases, made by ir/opt/tabulate_guards: the first row
/// that holds says which case fires, and numbers that stay in their intervals need not be checked
/// again. The interpreter ignores it.
struct GuardTable {
  std::vector<GuardColumn> columns;
  std::vector<GuardRow> rows;  ///< in the order of their cases
  [[nodiscard]] bool empty() const { return columns.empty(); }
};

/// A use of a behaviour by a state.
struct Activity {
  BehaviourId behaviour;
  std::vector<ExprId> arguments;  ///< of a C function: evaluated each time it is called
  BlockId entry;                  ///< of one in the language; invalid: nothing
  std::vector<Case> cases;        ///< of one in the language; Stay or Done
  VariableId done;  ///< of one in the language that has a Done: the truth value that it sets
  support::SourceRange range;
};

/// A value that the SBC logs while the state is current.
struct LogItem {
  std::string name;
  ExprId value;         ///< a Sensor or a clock
  double period_s = 0;  ///< at most once in this time; 0: every tick
};

/// How often an instrument of the vehicle reads while a state is current.
struct Sampling {
  std::string instrument;  ///< "optode"
  std::string words;       ///< as written: "every 30 s when climbing", "off"; empty: always
  uint32_t place = 0;      ///< in the platform file, and in the word of hooks/protocol/sampling.h
  ExprId code;             ///< a plain number: its code there
  ExprId period;           ///< the time between readings, where the code is not a constant and may
                           ///< be that of one; else invalid
};

struct State {
  std::string name;
  Activity profile;
  Activity route;
  std::vector<VariableId> parameters;  ///< kind Argument
  std::vector<LogItem> log;
  /// By place. What is not there reads as the vehicle's own mission says.
  std::vector<Sampling> sampling;
  BlockId entry;  ///< invalid: nothing
  std::vector<Case> cases;
  GuardTable table;              ///< of the cases; may be empty
  support::SourceRange range;    ///< of its name
  support::SourceRange head;     ///< of what is written before its events
  support::SourceRange formals;  ///< of its parameters, without the parentheses
};

/// Values that an expression chooses from by their number.
struct Table {
  Type type;
  std::vector<double> values;  ///< one at least; SI units or degrees, finite
  bool operator==(const Table&) const = default;
};

/// What every flight of a mission must satisfy: the question for the prover. It is not compiled.
enum class RequirementKind : uint8_t {
  Always,        ///< `condition` is never false
  ExitWithin,    ///< the mission has ended by mission time `seconds`
  StackAtMost,   ///< never more than `depth` states wait on the call stack
  Reach,         ///< some trace enters `state`
  NeverAfter,    ///< no trace enters `state` once it has entered `after`
  SurfacesEvery  ///< the vehicle is never under water for longer than `seconds`
};

/// Degrees, north and east positive.
struct Position {
  double latitude = 0;
  double longitude = 0;
  bool operator==(const Position&) const = default;
};

/// An area that the vehicle must stay in, or out of: a polygon whose edges are straight in latitude
/// and longitude, or the disc of the places closer to a point than a radius.
struct Geofence {
  bool keep_in = true;
  std::vector<Position> corners;  ///< three at least; of a disc one, its centre
  double radius_m = 0;            ///< of a disc, as `distance` measures; of a polygon 0
  [[nodiscard]] bool isDisc() const { return radius_m > 0; }
  bool operator==(const Geofence&) const = default;
};

/// What a tick did, as a monitor sees it.
enum class ObservationKind : uint8_t {
  Entered,  ///< the tick entered `state` by goto or call, or as the first state of the mission
  Inside,   ///< `state` is current, or waits on the call stack
  Ended     ///< the tick ended the mission
};

struct Observation {
  VariableId variable;  ///< Momentary, a truth value: set at the end of each tick
  ObservationKind kind = ObservationKind::Ended;
  StateId state;  ///< of Entered and Inside
};

/// A way of violating a requirement.
struct Violation {
  ExprId condition;
  std::string words;  ///< "`b` was not visited within 2 h"
  /// A clock: when it became due what is then missing; invalid: not at a time of its own.
  VariableId since = {};
  std::string cause = {};  ///< what was so at that time: "`depth > 5 m` was true"
};

/// Watches a flight for a requirement that one condition cannot express; only those of assumptions
/// are compiled. At the end of the start and of each tick the observations are set, then `step`
/// runs, then the requirement's condition is checked (ir/README.md, Monitors). It reads the true
/// depth.
struct Monitor {
  std::vector<Observation> observations;
  BlockId step;  ///< Set and If, of variables of the kinds Monitor and Momentary; invalid: none
  std::vector<Violation> violations;  ///< the requirement's condition is that none is true
  double horizon_s = 0;               ///< the longest time in it, s; 0: none
  bool every_tick = false;            ///< it compares a tick with the one before
};

struct Requirement {
  RequirementKind kind = RequirementKind::Always;
  ExprId condition;  ///< of Always: reads no temporal and nothing that belongs to a state
  /// For Always: if not empty, the condition only requires that all of them are kept.
  std::vector<Geofence> geofences;
  Monitor monitor;     ///< of Always
  double seconds = 0;  ///< positive
  uint32_t depth = 0;
  StateId state;
  StateId after;
  support::SourceRange range;
};

enum class AssumptionKind : uint8_t {
  StartDepth,   ///< control is given at `limit` m or above
  StartInside,  ///< control is given in `area`
  Outage,       ///< the SBC is never without power for longer than `limit` s during the mission
  Current,      ///< the water moves no faster than `limit` m/s
  Range,        ///< every known reading of `sensor` is in `lowest` to `highest`
  Always        ///< what `watch` says
};

/// What the pilot takes for granted about the sea, the vehicle and the SBC. No decision of the
/// mission depends on it: proofs may rest on it, and flights are watched for what breaks it.
struct Assumption {
  AssumptionKind kind = AssumptionKind::Always;
  double limit = 0;   ///< not negative
  Geofence area;      ///< of StartInside: to keep in
  SensorId sensor;    ///< of Range
  double lowest = 0;  ///< of Range: SI units or degrees
  double highest = 0;
  /// Of Range, Outage and Always: what breaks it, as a requirement of the kind Always.
  Requirement watch;
  std::string words;  ///< as written: "known altitude every 1 min"
  support::SourceRange range;

  [[nodiscard]] bool isWatched() const {
    return kind >= AssumptionKind::Outage && kind != AssumptionKind::Current;
  }
};

/// A frame of the vehicle holds at most as many readings.
inline constexpr size_t kMostReadings = 64;
/// A mission has at most as many shares.
inline constexpr size_t kMostShares = 32;
/// A mission names at most as many vehicles: a modem has no more addresses.
inline constexpr size_t kMostNamedVehicles = 15;

/// What was last received of a share from one vehicle.
struct FromVehicle {
  uint32_t address = 0;  ///< of its modem: its place in Mission::vehicles, from 1 on
  SensorId sensor;
};

/// A value that the vehicle tells the others of a fleet by its acoustic modem, as one of `values`
/// numbers `lowest` + i `step`; an unknown one, and one outside of them, is sent as unknown. All
/// shares of one period are sent in one message.
struct Share {
  std::string name;
  SensorId sensor;      ///< what is sent: a reading or, if this is not valid,
  VariableId variable;  ///< a variable of the mission, or a parameter
  SensorId peer;        ///< what was last received of it from any other; invalid: not read
  double lowest = 0;    ///< SI units or degrees
  double step = 0;      ///< positive
  uint32_t values = 0;  ///< 1 at least, below UINT32_MAX; of a truth value 2
  double period_s = 0;  ///< at most once in this time; positive
  support::SourceRange range;
  std::vector<FromVehicle> named = {};  ///< by address: those that the mission reads
};

/// Used if a mission does not define it: longer than any reboot, and short enough that what the
/// vehicle does meanwhile does not matter.
inline constexpr double kResumeWithin_s = 300;

/// How a mission that reads or commands true headings works with a vehicle whose headings are
/// magnetic: the variation that the vehicle has reported is used, otherwise the declination.
struct Compass {
  SensorId
      variation;  ///< by how much magnetic headings exceed true ones; invalid: the vehicle has none
  std::optional<double> declination;  ///< rad, east positive, from the mission's text
  bool operator==(const Compass&) const = default;
};

/// The batteries that the mission counts on: the line `pack`.
struct Pack {
  double capacity_C = 0;  ///< positive
  double voltage_V = 0;   ///< positive: what a charge is multiplied by to give an energy
  double reserve = 0;     ///< the share of the capacity that is not meant to be used: 0 <= r < 1
  bool operator==(const Pack&) const = default;
};

struct Mission {
  std::string name;
  std::string platform;
  std::vector<Sensor> sensors;
  std::vector<Behaviour> behaviours;
  std::vector<Expr> exprs;
  std::vector<Table> tables;
  std::vector<Function> functions;
  std::vector<FunctionUse> uses;
  std::vector<Variable> variables;
  std::vector<Temporal> temporals;
  std::vector<Block> blocks;
  std::vector<ExprId> conditions;  ///< what the parameters must satisfy together (`where`)
  std::vector<Case> always;        ///< no Return, no Done
  GuardTable always_table;         ///< of `always`; may be empty
  std::vector<State> states;       ///< the first is where the mission starts
  /// Runs at the start and in each tick, before the cases are tried: Set, If and Log, of variables
  /// of the kind Mission, which nothing else reads. It reads no temporal. Invalid: nothing.
  BlockId every_tick;
  std::vector<Requirement> requirements;
  std::vector<Assumption> assumptions;
  /// The longest outage of the SBC after which the mission continues, s; kResumeWithin_s unless the
  /// mission defines another.
  double resume_within_s = kResumeWithin_s;
  /// The mission does not continue, but is over, if the vehicle has restarted its own mission
  /// during the outage.
  bool new_after_restart = false;
  /// The longest time for which the SBC may sleep between two ticks, s: the line `nap at most`;
  /// empty: it never sleeps. It decides nothing in the meaning of the mission.
  std::optional<double> nap_s;
  std::optional<Compass> compass;  ///< empty: the mission does not use headings
  std::optional<Pack> pack;        ///< empty: the mission says nothing of it
  std::vector<Share> shares;       ///< those of a period one after the other, shortest period first
  SensorId utc;  ///< the vehicle's clock, of a mission with shares: it is in `sensors`
  std::vector<std::string> vehicles;  ///< names of the fleet, by the address of the modem, from 1

  [[nodiscard]] const Expr& operator[](ExprId id) const { return exprs.at(id.index); }
  [[nodiscard]] const State& operator[](StateId id) const { return states.at(id.index); }
  [[nodiscard]] const Sensor& operator[](SensorId id) const { return sensors.at(id.index); }
  [[nodiscard]] const Behaviour& operator[](BehaviourId id) const {
    return behaviours.at(id.index);
  }
  [[nodiscard]] const Variable& operator[](VariableId id) const { return variables.at(id.index); }
  [[nodiscard]] const Temporal& operator[](TemporalId id) const { return temporals.at(id.index); }
  [[nodiscard]] const Table& operator[](TableId id) const { return tables.at(id.index); }
  [[nodiscard]] const Function& operator[](FunctionId id) const { return functions.at(id.index); }
  [[nodiscard]] const Function& operator[](UseId id) const {
    return functions.at(uses.at(id.index).function.index);
  }
  [[nodiscard]] const Block& operator[](BlockId id) const { return blocks.at(id.index); }
};

/// What the verifier has found; only for missions without errors.
struct MissionFacts {
  uint32_t stack_depth = 0;  ///< greatest number of frames on the call stack
  std::vector<StateId>
      deepest_path;  ///< the states of such a stack, outermost first, then the current
};

}  // namespace glider::ir
