// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/box.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

/// A mission as it was written: plain values, compared regardless of places and comments. `print`
/// (print.h) writes a mission as text; parsing that text gives an equal mission.
namespace glider::ast {

struct Expr;

struct Name {
  std::string text;
  Where where;
  bool operator==(const Name&) const = default;
};

/// `5`, `.5 degC/m`, `39.2 N`, `39 10.5 N`. The letter of a position is in `unit`, including the
/// ambiguous `W` or `S`.
struct Literal {
  std::string digits;  ///< as written: minutes of a position are read from it exactly; "39 10.5"
  std::string unit;    ///< "" for a bare number; without spaces
  Where unit_where;
  bool operator==(const Literal&) const = default;
};

/// `39.2 N 73.9 W`
struct Position {
  Literal latitude;
  Literal longitude;
  Where latitude_where;
  Where longitude_where;
  bool operator==(const Position&) const = default;
};

/// `3 h 30 min`
struct Duration {
  std::vector<Literal> parts;
  bool operator==(const Duration&) const = default;
};

/// `2026-11-25T12:00Z`
struct Instant {
  std::string text;
  bool operator==(const Instant&) const = default;
};

struct Truth {
  bool value = false;
  bool operator==(const Truth&) const = default;
};

/// `depth`
struct NameUse {
  std::string name;
  bool operator==(const NameUse&) const = default;
};

/// An argument; `10 m of depth` names a stretch, `top = 5 m` what it is for.
struct Argument {
  Box<Expr> value;
  std::optional<Name> of;
  std::optional<Name> parameter = {};
  bool operator==(const Argument&) const = default;
};

/// The function of `peers within 2 km`: no name is spelled so.
inline constexpr std::string_view kPeersWithin = "peers within";

/// `clamp(depth, 3 m, 24 m)`, and `peers within 2 km`, of the function kPeersWithin.
struct Invocation {
  Name function;
  std::vector<Argument> arguments;
  bool operator==(const Invocation&) const = default;
};

/// `[39.2 N 73.9 W, 39.3 N 73.9 W]`
struct List {
  std::vector<Expr> items;
  bool operator==(const List&) const;
};

/// `track[2]`
struct Index {
  Name list;
  Box<Expr> position;
  bool operator==(const Index&) const = default;
};

enum class UnaryOp : uint8_t { Negate, Not };
enum class BinaryOp : uint8_t {
  Multiply,
  Divide,
  Add,
  Subtract,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  Equal,
  NotEqual,
  And,
  Or
};

struct Unary {
  UnaryOp op;
  Box<Expr> operand;
  bool operator==(const Unary&) const = default;
};

struct Binary {
  BinaryOp op;
  Box<Expr> left;
  Box<Expr> right;
  Where op_where;
  bool operator==(const Binary&) const = default;
};

struct Expr {
  std::variant<Literal, Position, Duration, Instant, Truth, NameUse, Invocation, List, Index, Unary,
               Binary>
      node;
  Where where;
  bool operator==(const Expr&) const = default;
};

inline bool List::operator==(const List& other) const {
  return items == other.items;
}

/// `length`, `temperature/length`: without spaces.
struct TypeName {
  std::string text;
  Where where;
  bool operator==(const TypeName&) const = default;
};

/// `lowest .. highest`
struct Range {
  Expr lowest;
  Expr highest;
  bool operator==(const Range&) const = default;
};

struct Formal {
  Name name;
  TypeName type;
  std::optional<Expr> usual = {};   ///< the argument if none is given
  std::optional<Range> range = {};  ///< in which arguments lie
  bool operator==(const Formal&) const = default;
};

using Formals = std::optional<std::vector<Formal>>;  ///< empty: no parentheses

inline std::span<const Formal> listOf(const Formals& formals) {
  return formals ? std::span<const Formal>(*formals) : std::span<const Formal>();
}

/// A profile, route or state by name, with its arguments: `yo(5 m, 10 m, 26 deg, 26 deg)`,
/// `noheading`.
struct Use {
  Name name;
  bool parenthesised = false;  ///< `f()` is not `f`
  std::vector<Argument> arguments;
  Where where;
  bool operator==(const Use&) const = default;
};

struct Statement;

struct Set {
  Name variable;
  Expr value;
  std::optional<Expr> index = {};  ///< of an array: which element
  bool operator==(const Set&) const = default;
};
struct If {
  Expr condition;
  std::vector<Statement> then;
  std::optional<std::vector<Statement>> otherwise;
  bool operator==(const If&) const;
};
/// `for i in 0 .. 7 do … end`
struct For {
  Name index;
  Expr first;
  Expr last;
  std::vector<Statement> body;
  bool operator==(const For&) const;
};
struct Log {
  std::string text;  ///< with its quotes, as written
  std::vector<Expr> values;
  bool operator==(const Log&) const = default;
};
struct Command {
  Invocation call;
  bool operator==(const Command&) const = default;
};

struct Statement {
  std::variant<Set, If, For, Log, Command> node;
  Where where;
  bool operator==(const Statement&) const = default;
};

inline bool If::operator==(const If& other) const {
  return condition == other.condition && then == other.then && otherwise == other.otherwise;
}

inline bool For::operator==(const For& other) const {
  return index == other.index && first == other.first && last == other.last && body == other.body;
}

/// `do … end`
struct Block {
  std::vector<Statement> statements;
  Where where;
  bool operator==(const Block&) const = default;
};

enum class Transition : uint8_t { Goto, Call, Return, Exit, Stay, Done };

struct Case {
  Expr guard;
  std::optional<Block> action;
  Transition transition = Transition::Stay;
  std::optional<Use> target;  ///< of goto and call
  Where transition_where;     ///< the keyword
  Where where;
  bool operator==(const Case&) const = default;
};

struct Const {
  Name name;
  std::optional<TypeName> type;
  Expr value;
  Where where;
  bool operator==(const Const&) const = default;
};
struct Param {
  Name name;
  TypeName type;
  Expr value;
  std::optional<Range> range;
  std::optional<Expr> condition;
  Where where;
  std::optional<Expr> size = {};  ///< of an array
  bool operator==(const Param&) const = default;
};
struct Var {
  Name name;
  TypeName type;
  Expr value;
  std::optional<Range> range;
  Where where;
  std::optional<Expr> size = {};  ///< of an array
  bool operator==(const Var&) const = default;
};

struct SensorItem {
  Name name;
  std::optional<Expr> every;  ///< applies to the items before, back to the previous `every`
  bool operator==(const SensorItem&) const = default;
};

// What is between `begin` and `end` of a state or behaviour, in the order written, including
// repetitions.
struct RouteMember {
  Use use;
  bool operator==(const RouteMember&) const = default;
};
struct ProfileMember {
  Use use;
  bool operator==(const ProfileMember&) const = default;
};
struct SensorsMember {
  std::vector<SensorItem> items;
  bool operator==(const SensorsMember&) const = default;
};
/// How often an instrument of the vehicle reads.
struct SampleItem {
  Name instrument;
  bool off = false;
  std::optional<Expr> every;  ///< none: as often as it can; not with `off`
  std::optional<Expr> when;   ///< only then
  Where how = {};             ///< what stands behind the instrument
  bool operator==(const SampleItem&) const = default;
};
struct SampleMember {
  std::vector<SampleItem> items;
  bool operator==(const SampleMember&) const = default;
};
struct EntryMember {
  Block block;
  bool operator==(const EntryMember&) const = default;
};
struct EventsMember {
  std::vector<Case> cases;
  bool operator==(const EventsMember&) const = default;
};

struct Member {
  std::variant<RouteMember, ProfileMember, SensorsMember, SampleMember, Var, EntryMember,
               EventsMember>
      node;
  Where where;
  Where keyword;  ///< its first word
  bool operator==(const Member&) const = default;
};

struct State {
  Name name;
  Formals formals;
  std::vector<Member> members;
  Where where;
  bool operator==(const State&) const = default;
};

enum class BehaviourKind : uint8_t { Profile, Route };

/// A flightprofile or flightroute written in the language.
struct Behaviour {
  BehaviourKind kind = BehaviourKind::Profile;
  Name name;
  Formals formals;
  std::vector<Member> members;
  Where where;
  bool operator==(const Behaviour&) const = default;
};

/// A flightprofile or flightroute in C or C++.
struct ExternBehaviour {
  BehaviourKind kind = BehaviourKind::Profile;
  Name name;
  Formals formals;
  std::vector<Name> reads;
  Where where;
  bool operator==(const ExternBehaviour&) const = default;
};
struct ExternFunction {
  Name name;
  std::vector<Formal> formals;
  TypeName result;
  std::optional<Range> range;
  Where where;
  bool operator==(const ExternFunction&) const = default;
};
struct ExternSensor {
  Name name;
  TypeName type;
  std::optional<Range> range;
  std::optional<Expr> stale_after;
  Where where;
  bool operator==(const ExternSensor&) const = default;
};

struct Always {
  std::vector<Case> cases;
  Where where;
  bool operator==(const Always&) const = default;
};

struct AlwaysPromise {
  Expr condition;
  bool operator==(const AlwaysPromise&) const = default;
};
struct ExitPromise {
  Expr within;
  bool operator==(const ExitPromise&) const = default;
};
struct StackPromise {
  Expr depth;
  bool operator==(const StackPromise&) const = default;
};
struct ReachPromise {
  Name state;
  bool operator==(const ReachPromise&) const = default;
};
/// In what order places are visited.
enum class Manner : uint8_t { AnyOrder, Sequence, Order, StrictOrder, Fairly };
/// Each place is a state, a `place` or a condition.
struct VisitPromise {
  std::vector<Expr> places;
  Manner manner = Manner::AnyOrder;
  Expr within;
  bool operator==(const VisitPromise&) const = default;
};
struct PatrolPromise {
  std::vector<Expr> places;
  Manner manner = Manner::AnyOrder;
  Expr every;
  bool operator==(const PatrolPromise&) const = default;
};
enum class CountBound : uint8_t { AtMost, AtLeast, Exactly };
struct CountPromise {
  Expr place;
  CountBound bound = CountBound::AtMost;
  Expr times;
  std::optional<Expr> within;  ///< not of AtMost
  bool operator==(const CountPromise&) const = default;
};
enum class NeverWhen : uint8_t { Ever, Before, After };
struct NeverPromise {
  Expr place;
  NeverWhen when = NeverWhen::Ever;
  std::optional<Expr> event;  ///< of Before and After
  bool operator==(const NeverPromise&) const = default;
};
enum class Trigger : uint8_t {
  Whenever,         ///< on each tick on which it is true
  When,             ///< on the tick on which it becomes true
  WheneverAndOnly,  ///< and only then
};
enum class Timing : uint8_t { AtOnce, Within, For, NextTick };
struct ReactionPromise {
  Trigger trigger = Trigger::Whenever;
  Expr cause;
  Expr response;
  Timing timing = Timing::AtOnce;
  std::optional<Expr> time;  ///< of Within and For
  bool operator==(const ReactionPromise&) const = default;
};
struct HoldPromise {
  Expr place;
  Expr until;
  Expr within;
  bool operator==(const HoldPromise&) const = default;
};
enum class ScopeKind : uint8_t { In, Outside, Before, After, FromTo };
/// When a promise is watched.
struct PromiseScope {
  ScopeKind kind = ScopeKind::In;
  Expr place;
  std::optional<Expr> to;  ///< of FromTo
  bool operator==(const PromiseScope&) const = default;
};
struct SurfacesPromise {
  Expr every;
  bool operator==(const SurfacesPromise&) const = default;
};
struct Requirement {
  std::variant<AlwaysPromise, ExitPromise, StackPromise, ReachPromise, SurfacesPromise,
               VisitPromise, PatrolPromise, CountPromise, NeverPromise, ReactionPromise,
               HoldPromise>
      node;
  Where where;
  std::optional<PromiseScope> scope = {};  ///< from VisitPromise on
  bool or_exit = false;                    ///< what is owed when the mission ends counts as met
  bool operator==(const Requirement&) const = default;
};

/// Where, or how deep, the vehicle is when control is given.
struct StartPremise {
  Expr condition;
  bool operator==(const StartPremise&) const = default;
};
struct OutagePremise {
  std::optional<Expr> limit;  ///< none: there is no outage
  bool operator==(const OutagePremise&) const = default;
};
struct CurrentPremise {
  Expr limit;
  bool operator==(const CurrentPremise&) const = default;
};
struct KnownPremise {
  std::optional<Name> sensor;  ///< none: a fix
  Expr every;
  bool operator==(const KnownPremise&) const = default;
};
struct ChangesPremise {
  Name sensor;
  Expr limit;
  bool operator==(const ChangesPremise&) const = default;
};
struct RangePremise {
  Name sensor;
  Range range;
  bool operator==(const RangePremise&) const = default;
};
struct ConditionPremise {
  Expr condition;
  std::optional<Expr> inside;  ///< only there
  bool operator==(const ConditionPremise&) const = default;
};
struct Assumption {
  std::variant<StartPremise, OutagePremise, CurrentPremise, KnownPremise, ChangesPremise,
               RangePremise, ConditionPremise>
      node;
  Where where;
  bool operator==(const Assumption&) const = default;
};

/// A name for a condition, for requirements.
struct PlaceDeclaration {
  Name name;
  Expr condition;
  Where where;
  bool operator==(const PlaceDeclaration&) const = default;
};

/// The longest outage of the SBC after which the mission continues.
struct Resumption {
  Expr within;
  bool never_after_restart = false;
  Where where;
  bool operator==(const Resumption&) const = default;
};

/// `nap at most 4 min`: how long the SBC may sleep between two ticks.
struct Nap {
  Expr longest;
  Where where;
  bool operator==(const Nap&) const = default;
};

/// The angle of magnetic north from true north, east positive.
struct Declination {
  Expr angle;
  Where where;
  bool operator==(const Declination&) const = default;
};

/// `share top: length in 0 m .. 200 m precision 1 m every 10 min`: what other vehicles receive.
struct Share {
  Name name;
  std::optional<Var> variable;  ///< that it declares; empty: a sensor, or declared elsewhere
  std::optional<Range> range;   ///< of one that declares nothing
  std::optional<Expr> precision;
  Expr every;
  std::optional<Expr> stale_after;  ///< of what is received of it
  Where where;
  bool operator==(const Share&) const = default;
};

/// `vehicles ada, bob`: the names of a fleet, in the order of the addresses of their modems.
struct Vehicles {
  std::vector<Name> names;
  Where where;
  bool operator==(const Vehicles&) const = default;
};

/// `pack 168 Ah at 14.4 V reserve 20 %`: the batteries.
struct Pack {
  Expr capacity;  ///< a charge or an energy
  Expr voltage;
  std::optional<Expr> reserve;  ///< the share that is not meant to be used
  Where where;
  bool operator==(const Pack&) const = default;
};

/// `choose bottom : length = 120 m in 60 m .. 180 m by 10 m`: a constant whose value `glidercc
/// plan` chooses and writes.
struct Choice {
  Const constant;       ///< its value is the lower end of the range if none is written
  bool chosen = false;  ///< a value is written
  Range range;
  std::optional<Expr> step;
  std::optional<Expr> condition;
  Where where;
  Where written = {};  ///< of its value in the text; empty, and after its type: there is none
  bool operator==(const Choice&) const = default;
};

enum class Aim : uint8_t { Least, Greatest, Endurance };

/// `greatest hours`, `endurance`: a part of the line `prefer`.
struct Objective {
  Aim aim = Aim::Endurance;
  std::optional<Expr> value;  ///< of all but endurance
  Where where;
  bool operator==(const Objective&) const = default;
};

/// `prefer greatest hours then endurance`
struct Preference {
  std::vector<Objective> objectives;  ///< the most important first
  Where where;
  bool operator==(const Preference&) const = default;
};

struct MissionLine {
  Name name;
  Where where;
  bool operator==(const MissionLine&) const = default;
};
struct PlatformLine {
  Name name;
  Where where;
  bool operator==(const PlatformLine&) const = default;
};
struct Import {
  std::string path;             ///< with its quotes, as written
  std::optional<Name> as = {};  ///< the path that it declares, for a file of waypoints
  Where where = {};
  bool operator==(const Import&) const = default;
};

using Item = std::variant<MissionLine, PlatformLine, Import, Const, Param, Var, Always, State,
                          Behaviour, ExternFunction, ExternBehaviour, ExternSensor,
                          PlaceDeclaration, Requirement, Assumption, Resumption, Nap, Declination,
                          Share, Vehicles, Pack, Choice, Preference>;

/// A mission file or a library file.
struct File {
  uint32_t file = support::SourceRange::kNoFile;
  std::vector<Item> items;
  bool operator==(const File& other) const { return items == other.items; }
};

}  // namespace glider::ast
