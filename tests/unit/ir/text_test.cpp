// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/ops.h"
#include "ir/core/validate.h"
#include "ir/text/print.h"
#include "tests/random_missions/random_mission.h"
#include "tests/unit/ir/missions.h"

#include <bit>
#include <limits>
#include <regex>
#include <tuple>

namespace glider::ir {
namespace {

uint64_t bits(double value) {
  return std::bit_cast<uint64_t>(value);
}

template <typename T>
void expectSame(const std::vector<T>& a, const std::vector<T>& b);

void expectSame(const Case& a, const Case& b) {
  EXPECT_EQ(std::tie(a.guard, a.action, a.transition, a.target, a.arguments),
            std::tie(b.guard, b.action, b.transition, b.target, b.arguments));
}

void expectSame(const Activity& a, const Activity& b) {
  EXPECT_EQ(std::tie(a.behaviour, a.arguments, a.entry, a.done),
            std::tie(b.behaviour, b.arguments, b.entry, b.done));
  expectSame(a.cases, b.cases);
}

void expectSame(const LogItem& a, const LogItem& b) {
  EXPECT_EQ(std::tie(a.name, a.value), std::tie(b.name, b.value));
  EXPECT_EQ(bits(a.period_s), bits(b.period_s));
}

void expectSame(const State& a, const State& b) {
  EXPECT_EQ(std::tie(a.name, a.parameters, a.entry), std::tie(b.name, b.parameters, b.entry));
  expectSame(a.profile, b.profile);
  expectSame(a.route, b.route);
  expectSame(a.log, b.log);
  expectSame(a.cases, b.cases);
}

void expectSame(const Variable& a, const Variable& b) {
  EXPECT_EQ(std::tie(a.name, a.type, a.kind, a.owner, a.initial, a.unit),
            std::tie(b.name, b.type, b.kind, b.owner, b.initial, b.unit));
  EXPECT_EQ(bits(a.lowest), bits(b.lowest));
  EXPECT_EQ(bits(a.highest), bits(b.highest));
}

void expectSame(const Temporal& a, const Temporal& b) {
  EXPECT_EQ(std::tie(a.kind, a.list, a.state, a.operand, a.duration, a.along),
            std::tie(b.kind, b.list, b.state, b.operand, b.duration, b.along));
  EXPECT_EQ(bits(a.length), bits(b.length));
  EXPECT_EQ(a.leg, b.leg);
  EXPECT_EQ(bits(a.dive), bits(b.dive));
  EXPECT_EQ(bits(a.climb), bits(b.climb));
}

void expectSame(const Statement& a, const Statement& b) {
  EXPECT_EQ(
      std::tie(a.kind, a.variable, a.value, a.then, a.otherwise, a.text, a.values, a.command),
      std::tie(b.kind, b.variable, b.value, b.then, b.otherwise, b.text, b.values, b.command));
}

void expectSame(const Block& a, const Block& b) {
  expectSame(a.statements, b.statements);
}

void expectSame(const Sensor& a, const Sensor& b) {
  EXPECT_EQ(std::tie(a.name, a.vehicle_name, a.id, a.type, a.encoding),
            std::tie(b.name, b.vehicle_name, b.id, b.type, b.encoding));
  for (auto number : {&Sensor::to_si, &Sensor::lowest, &Sensor::highest, &Sensor::stale_after_s}) {
    EXPECT_EQ(bits(a.*number), bits(b.*number));
  }
}

void expectSame(const Behaviour& a, const Behaviour& b) {
  EXPECT_EQ(std::tie(a.name, a.symbol, a.kind, a.reads),
            std::tie(b.name, b.symbol, b.kind, b.reads));
  ASSERT_EQ(a.parameters.size(), b.parameters.size());
  for (size_t i = 0; i < a.parameters.size(); ++i) {
    EXPECT_EQ(a.parameters[i].name, b.parameters[i].name);
    EXPECT_EQ(a.parameters[i].type, b.parameters[i].type);
  }
}

void expectSame(const Expr& a, const Expr& b) {
  EXPECT_EQ(std::tie(a.op, a.type, a.operands, a.sensor, a.variable, a.temporal),
            std::tie(b.op, b.type, b.operands, b.sensor, b.variable, b.temporal));
  EXPECT_EQ(bits(a.number), bits(b.number));
}

void expectSame(const Share& a, const Share& b) {
  EXPECT_EQ(std::tie(a.name, a.sensor, a.variable, a.peer, a.values),
            std::tie(b.name, b.sensor, b.variable, b.peer, b.values));
  for (auto number : {&Share::lowest, &Share::step, &Share::period_s}) {
    EXPECT_EQ(bits(a.*number), bits(b.*number));
  }
}

template <typename T>
void expectSame(const std::vector<T>& a, const std::vector<T>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    expectSame(a[i], b[i]);
  }
}

/// Everything but source ranges.
void expectSame(const Mission& a, const Mission& b) {
  EXPECT_EQ(std::tie(a.name, a.platform, a.conditions, a.compass, a.utc),
            std::tie(b.name, b.platform, b.conditions, b.compass, b.utc));
  expectSame(a.shares, b.shares);
  expectSame(a.variables, b.variables);
  expectSame(a.temporals, b.temporals);
  expectSame(a.blocks, b.blocks);
  expectSame(a.always, b.always);
  expectSame(a.sensors, b.sensors);
  expectSame(a.behaviours, b.behaviours);
  expectSame(a.exprs, b.exprs);
  expectSame(a.states, b.states);
}

TEST(IrText, RandomMissionsComeBack) {
  for (uint64_t seed = 0; seed < 300; ++seed) {
    const Mission mission = random_missions::flownMission(seed);
    const std::string text = print(mission);
    const Mission again = missionOf(text);
    expectSame(mission, again);
    EXPECT_EQ(text, print(again));
    ASSERT_FALSE(HasFailure()) << text;
  }
}

TEST(IrText, ReadsLikeTheMission) {
  const std::string text = R"(glider_ir 1
mission m platform slocum

sensor depth: length vehicle m_depth id 1 encoding linear to_si 1 lowest -1 highest 100 stale_after 20
behaviour profile yo symbol gliderProfileYo (top: length, bottom: length) reads (depth)
behaviour route drift symbol gliderRouteDrift () reads ()

state s1
  route drift ()
  profile yo (5:length, (add (sensor depth) 2.5:length))
  log depth every 8 (sensor depth)
  case (and (ge missiontime 500:time) (lt missiontime 1500:time)) call s2
  let %11 = (le (sensor depth) 0.1:length)
  case (not %11) stay

state s2
  route drift ()
  profile yo (5:length, 20:length)
  case %11 return
)";
  const std::string printed = print(missionOf(text));
  EXPECT_EQ(std::regex_replace(printed, std::regex("%[0-9]+"), "%11"), text);
}

/// A mission that only a machine would make: names with anything in them, expressions in no command
/// that a text could have, used often or never, chains longer than a reader nests.
Mission strange() {
  Mission m = missionOf(kHeader + stateText("a", "case true exit"));
  m.name = "";
  m.platform = "\"quotes\\\n\xff\x01 and blanks";
  m.states[0].name = "state";
  m.sensors[0].name = "case";
  m.sensors[0].lowest = -std::numeric_limits<double>::infinity();
  m.sensors[0].highest = std::numeric_limits<double>::denorm_min();
  m.sensors[0].type.dimension = {{-12, 12, 0, 3, 0, 1}};
  m.exprs.clear();
  for (double number : {-0.0, 0x1p-1074, 0.1, std::numeric_limits<double>::max()}) {
    Expr e;
    e.number = number;
    e.type = {TypeKind::Quantity, support::dimension::length};
    m.exprs.push_back(e);
  }
  Expr less;
  less.op = Op::Less;
  less.operands = {ExprId{2}, ExprId{0}};
  less.type = {TypeKind::Bool, {}};
  m.exprs.push_back(less);
  for (uint32_t i = 0; i < 1000; ++i) {
    Expr e;
    e.op = Op::Not;
    e.operands = {ExprId{4 + i}};
    e.type = {TypeKind::Bool, {}};
    m.exprs.push_back(e);
  }
  m.states[0].cases[0].guard = {1004};
  m.states[0].cases.push_back({{500}, {}, Transition::Goto, {0}, {}, {}});
  Expr sensor;
  sensor.op = Op::Sensor;
  sensor.type = m.sensors[0].type;
  sensor.sensor = {0};
  m.exprs.push_back(sensor);
  Expr clock;
  clock.op = Op::StateTime;
  clock.type = {TypeKind::Quantity, support::dimension::time};
  m.exprs.push_back(clock);
  m.states[0].log = {{"two words", {1005}, 0.1}, {"", {1006}, 1e-7}};
  return m;
}

TEST(IrText, StrangeMissionsComeBack) {
  const Mission mission = strange();
  ASSERT_TRUE(validate(mission).empty());
  expectSame(mission, missionOf(print(mission)));
}

/// Everything that the text form has beyond `ReadsLikeTheMission`.
const char* const kWhole = R"(glider_ir 1
mission m platform slocum

sensor depth: length vehicle m_depth id 1 encoding linear to_si 1 lowest -1 highest 100 stale_after 20
behaviour profile yo symbol "" () reads ()
behaviour route drift symbol gliderRouteDrift () reads ()
variable bottom: length parameter lowest 10 highest 30
variable bloom: number parameter lowest 0 highest 10 unit "ug/L"
variable low: number parameter unit uM
variable fast: bool mission
variable upper: length mission lowest 3 highest 24
variable "leg.to": latitude argument of leg lowest -90 highest 90
variable "leg.count": number state of leg
variable "leg.profile.done": bool profile of leg
initial bottom 25:length
initial bloom 2.5
initial low 180
initial fast false
initial upper (min 5:length (var bottom))
condition (ge (var bottom) (mul 2 5:length))

always
  temporal held always (lt (sensor depth) 4:length) for 30:time
  case (temporal 0) do
    set upper 3:length
  end exit
  temporal slope always (sensor depth) over 60
  case (lt (temporal 1) 0:speed) stay

state s1
  route drift ()
  profile yo begin
  end
  temporal became state s1 (ge (sensor depth) (var bottom))
  case (temporal 2) do
    set upper (clamp (sensor depth) 3:length 24:length)
    if (var fast)
      log "met at " ((var upper), (sin 1:angle))
      steer_to (39:latitude, -73:longitude)
    else
      if (known (sensor depth))
        surface ()
      end
    end
  end call leg (39.5:latitude)

state leg ("leg.to")
  initial "leg.count" 0
  initial "leg.profile.done" false
  route drift ()
  profile yo done "leg.profile.done" begin
    entry do
      descend ((var upper), 0.4:angle)
    end
    case (ge (sensor depth) 20:length) do
    end done
  end
  entry do
    set "leg.count" (add (var "leg.count") 1)
  end
  temporal mean route leg (sensor depth) over 10 along (sensor depth)
  case (gt (distance 1:latitude 2:longitude (var "leg.to") 3:longitude) (temporal 3)) return
  temporal at_lowest route leg (sensor depth) where (sensor depth) over last 1 2.5 along (sensor depth)
  case (gt (temporal 4) 2:length) return
  temporal number route leg (sensor depth) over this 1 1 along (sensor depth)
  case (gt (temporal 5) 2) return
  temporal steepest route leg (sensor depth) where (sensor depth) over this 1 2 along (sensor depth)
  case (gt (temporal 6) 2) return
  temporal at_steepest route leg (sensor depth) where (sensor depth) over this 1 2 along (sensor depth)
  case (gt (temporal 7) 2:length) return
)";

TEST(IrText, CompassesComeBack) {
  for (const std::string compass : {"compass", "compass variation var", "compass declination -0.21",
                                    "compass variation var declination 3"}) {
    const std::string text =
        "glider_ir 1\nmission m platform slocum\n"
        "\nsensor heading: angle vehicle m_heading id 1 encoding magnetic to_si 1 lowest 0 highest "
        "6 stale_after 20"
        "\nsensor var: angle vehicle m_gps_mag_var id 2 encoding linear to_si 1 lowest -3 highest "
        "3 "
        "stale_after 20\n" +
        compass +
        "\nbehaviour profile glide symbol g () reads ()\nbehaviour route drift symbol d () reads ()"
        "\n\nstate a\n  route drift ()\n  profile glide ()\n";
    const Mission mission = missionOf(text);
    ASSERT_TRUE(mission.compass.has_value());
    EXPECT_EQ(mission.sensors[0].encoding, Encoding::Magnetic);
    EXPECT_NE(print(mission).find("\n" + compass + "\n"), std::string::npos) << print(mission);
    expectSame(mission, missionOf(print(mission)));
  }
}

TEST(IrText, NapsComeBack) {
  const std::string text = kHeader + "state a route drift () profile glide () case true exit";
  EXPECT_FALSE(missionOf(text).nap_s);
  Mission mission = missionOf(text);
  mission.nap_s = 240.5;
  const std::string printed = print(mission);
  EXPECT_NE(printed.find("\nnap 240.5\n"), std::string::npos) << printed;
  EXPECT_EQ(missionOf(printed).nap_s, 240.5);
}

TEST(IrText, SharesComeBack) {
  const std::string text =
      kTalking + stateText("a", "case (gt (sensor \"peer.top\") 5:length) exit");
  const Mission mission = missionOf(text);
  ASSERT_EQ(mission.shares.size(), 3U);
  EXPECT_EQ(mission[mission.utc].vehicle_name, "m_present_time");
  EXPECT_TRUE(mission[mission.shares[0].peer].isHeard());
  EXPECT_TRUE(mission.shares[1].variable.valid());
  EXPECT_FALSE(mission.shares[2].peer.valid());
  const std::string printed = print(mission);
  EXPECT_NE(
      printed.find("\nutc present_time\n"
                   "share top of sensor depth received \"peer.top\" lowest 0 step 0.1 values 2001 "
                   "every 60\n"),
      std::string::npos)
      << printed;
  expectSame(mission, missionOf(printed));
}

TEST(IrText, NamedVehiclesComeBack) {
  const Mission mission =
      missionOf(kNamedTalking + stateText("a", "case (gt (sensor \"ada.top\") 5:length) exit"));
  EXPECT_EQ(mission.vehicles, (std::vector<std::string>{"ada", "bob", "carl"}));
  ASSERT_EQ(mission.shares[0].named.size(), 2U);
  EXPECT_EQ(mission.shares[0].named[1].address, 3U);
  EXPECT_EQ(mission[mission.shares[0].named[1].sensor].name, "carl.top");
  EXPECT_EQ(mission[mission.shares[0].peer].name, "peer.top");
  const std::string printed = print(mission);
  EXPECT_NE(printed.find("\nvehicle ada\nvehicle bob\nvehicle carl\nshare top of sensor depth "
                         "received \"peer.top\" received \"ada.top\" from 1 received "
                         "\"carl.top\" from 3 lowest 0 step"),
            std::string::npos)
      << printed;
  expectSame(mission, missionOf(printed));
}

TEST(IrText, WholeLanguageReadsLikeTheMission) {
  const Mission mission = missionOf(kWhole);
  EXPECT_EQ(print(mission), kWhole);
  EXPECT_EQ(mission.temporals.size(), 8u);
  EXPECT_EQ(mission.blocks.size(), 8u);
  EXPECT_EQ(mission.states[1].profile.cases[0].transition, Transition::Done);
}

TEST(IrText, BlocksOutOfOrderComeBack) {
  Mission mission = missionOf(kHeader + R"(variable x: length mission
initial x 0:length
state a route drift () profile glide () entry do set x 1:length end
  case true do if true set x 2:length else set x 3:length end end stay
  case false do set x 4:length end exit
)");
  std::swap(mission.states[0].entry, mission.states[0].cases[1].action);
  const std::string text = print(mission);
  EXPECT_NE(text.find("run"), std::string::npos);
  expectSame(mission, missionOf(text));
}

TEST(IrText, RangesPointIntoTheText) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const uint32_t file =
      sources.add("test", kHeader + stateText("a", "case (not (known (sensor depth))) goto a"));
  const auto m = read(sources, file, diagnostics);
  ASSERT_TRUE(m.has_value());
  EXPECT_EQ(sources.text(m->states[0].range), "a");
  EXPECT_EQ(sources.text(m->states[0].cases[0].range), "case (not (known (sensor depth))) goto a");
  EXPECT_EQ(sources.text(m->exprs[1].range), "(known (sensor depth))");
  EXPECT_EQ(sources.text(m->states[0].profile.range), "profile glide ()");
}

TEST(IrText, EveryOperationHasItsOwnSpelling) {
  for (size_t i = 0; i < opCount(); ++i) {
    const OpInfo& info = opInfo(static_cast<Op>(i));
    EXPECT_EQ(info.op, static_cast<Op>(i));
    EXPECT_EQ(findOp(info.text)->op, info.op);
  }
  EXPECT_EQ(findOp("nonsense"), nullptr);
}

}  // namespace
}  // namespace glider::ir
