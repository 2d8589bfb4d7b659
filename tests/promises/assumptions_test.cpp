// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Assumptions: what breaks each kind, against its definition in C++ on random flights; what
// requirements say that rest on them.

#include "ir/core/validate.h"
#include "ir/eval/interpreter.h"
#include "ir/opt/prepare_for_flight.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/context/requirement_monitor.h"
#include "ir/text/print.h"
#include "ir/text/read.h"
#include "ir/worlds/under_assumptions.h"
#include "tests/promises/patrol.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

constexpr double kNotRead = std::numeric_limits<double>::quiet_NaN();
constexpr double kCycle = 4;

struct Seen {
  double time = 0;
  double altitude = 0;
  double pressure = 0;  // bar
};

std::vector<Seen> assumedFlight(std::mt19937& rng) {
  std::vector<Seen> flight;
  const auto below = [&](unsigned n) { return static_cast<unsigned>(rng() % n); };
  double time = 0;
  double altitude = below(40);
  const unsigned shy = 2 + below(8);
  for (unsigned i = 0, length = 2 + below(30); i < length; ++i) {
    altitude += below(6) == 0 ? below(60) - 30.0 : below(5) - 2.0;
    altitude = std::clamp(altitude, 0.0, 100.0);
    flight.push_back(
        {time, below(shy) == 0 ? kNotRead : altitude, below(6) == 0 ? kNotRead : 0.5 * below(8)});
    time += below(12) == 0 ? 10.0 * below(30) : kCycle * (1 + below(3));
  }
  return flight;
}

using Broken = std::function<bool(const std::vector<Seen>&, size_t)>;

/// When `broken` is first true.
std::optional<double> firstOf(const Broken& broken, const std::vector<Seen>& flight) {
  for (size_t i = 0; i < flight.size(); ++i) {
    if (broken(flight, i)) {
      return flight[i].time;
    }
  }
  return std::nullopt;
}

std::vector<ir::SensorUpdate> frameOf(const ir::Mission& mission, const Seen& seen) {
  std::vector<ir::SensorUpdate> frame;
  for (uint32_t s = 0; s < mission.sensors.size(); ++s) {
    const std::string& name = mission.sensors[s].name;
    frame.push_back({{s},
                     name == "altitude"   ? seen.altitude
                     : name == "pressure" ? seen.pressure
                                          : kNotRead});
  }
  return frame;
}

/// What the text form of `mission` is read as.
std::string readAgain(const ir::Mission& mission) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const auto again = ir::read(sources, sources.add("m.ir", ir::print(mission)), diagnostics);
  return again ? ir::print(*again) : support::render(diagnostics, sources, false);
}

/// When each requirement is violated.
std::vector<std::optional<double>> watched(const ir::Mission& mission,
                                           const std::vector<ir::Requirement>& requirements,
                                           const std::vector<Seen>& flight) {
  ir::Interpreter run(mission, 1);
  std::vector<ir::RequirementMonitor> monitors;
  for (const ir::Requirement& requirement : requirements) {
    monitors.emplace_back(mission, requirement, 1.0, std::nullopt);
  }
  for (size_t i = 0; i < flight.size(); ++i) {
    const auto frame = frameOf(mission, flight[i]);
    const ir::TickResult result = i == 0 ? run.start(frame, {}) : run.tick(flight[i].time, frame);
    for (ir::RequirementMonitor& monitor : monitors) {
      monitor.tick(run, flight[i].time, result, kNotRead);
    }
    if (result.finished) {
      break;
    }
  }
  std::vector<std::optional<double>> when;
  for (const ir::RequirementMonitor& monitor : monitors) {
    when.push_back(monitor.when());
  }
  return when;
}

struct Assumed {
  const char* text;
  Broken broken;
};

bool tooLong(const std::vector<Seen>& flight, size_t i, double limit) {
  const double gap = i == 0 ? 0 : flight[i].time - flight[i - 1].time;
  return gap > std::max(limit, slocum().world.tick_gap_s);
}

/// By looking back over the whole flight: a monitor goes forward and keeps what it needs.
std::vector<Assumed> assumptions() {
  return {
      {"no outage", [](const auto& f, size_t i) { return tooLong(f, i, 0); }},
      {"outage <= 100 s", [](const auto& f, size_t i) { return tooLong(f, i, 100); }},
      {"altitude in 2 m .. 50 m",
       [](const auto& f, size_t i) { return f[i].altitude < 2 || f[i].altitude > 50; }},
      {"altitude >= 1 m || pressure > 1 bar",
       [](const auto& f, size_t i) { return f[i].altitude < 1 && f[i].pressure <= 1; }},
      {"altitude changes <= 0.5 m/s",
       [](const auto& f, size_t i) {
         for (size_t k = i; k-- > 0;) {
           if (f[k].altitude == f[k].altitude) {
             return std::fabs(f[i].altitude - f[k].altitude) > 0.5 * (f[i].time - f[k].time);
           }
         }
         return false;
       }},
      {"known altitude every 30 s",
       [](const auto& f, size_t i) {
         for (size_t k = i;; --k) {
           if (f[k].altitude == f[k].altitude || k == 0 || tooLong(f, k, 30)) {
             return f[i].time - f[k].time > 30;
           }
         }
       }},
  };
}

class Assumptions : public testing::TestWithParam<size_t> {};

TEST_P(Assumptions, AreBrokenAsTheirDefinitionSays) {
  const Assumed assumed = assumptions()[GetParam()];
  const ir::Mission mission = compiled(patrol(fmt::format("assume {}", assumed.text)));
  ASSERT_EQ(mission.assumptions.size(), 1U);
  EXPECT_EQ(mission.assumptions[0].words, assumed.text);
  std::mt19937 rng(11);
  size_t broken = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto flight = assumedFlight(rng);
    const auto when = watched(mission, {mission.assumptions[0].watch}, flight).front();
    EXPECT_EQ(when, firstOf(assumed.broken, flight)) << assumed.text << ", flight " << i;
    broken += when ? 1U : 0U;
  }
  EXPECT_GT(broken, 100U);
  EXPECT_LT(broken, 1950U);
}

/// A requirement that rests on an assumption is violated where it is violated, unless the
/// assumption is broken by then.
TEST_P(Assumptions, ExcuseWhatComesAfterTheyAreBroken) {
  const char* kRequired[] = {"always pressure <= 2.5 bar", "exit within 2 min",
                             "whenever pressure > 2 bar then altitude > 10 m within 20 s",
                             "never up after pressure > 3 bar"};
  for (const char* required : kRequired) {
    const ir::Mission mission = compiled(
        patrol(fmt::format("assume {}\nrequire {}", assumptions()[GetParam()].text, required)));
    const bool always = mission.assumptions[0].kind == ir::AssumptionKind::Always;
    const ir::Mission under = ir::underAssumptions(mission);
    EXPECT_TRUE(ir::validate(under).empty());
    std::mt19937 rng(7);
    size_t excused = 0;
    for (int i = 0; i < 500; ++i) {
      const auto flight = assumedFlight(rng);
      const auto plain =
          watched(mission, {mission.requirements[0], mission.assumptions[0].watch}, flight);
      const auto weak = watched(under, {under.requirements[0]}, flight).front();
      const bool excuses = always && plain[0] && plain[1] && *plain[1] <= *plain[0];
      if (mission.assumptions[0].kind != ir::AssumptionKind::Range) {
        EXPECT_EQ(weak, excuses ? std::nullopt : plain[0]) << required << ", flight " << i;
      }
      excused += excuses ? 1U : 0U;
    }
    EXPECT_TRUE(!always || excused >= 3) << required << ": " << excused;
  }
}

struct OnBoard {
  std::vector<double> notes;     // when each was left
  std::vector<uint32_t> states;  // after each tick
};

/// `flown` on readings, which it names as `mission` does.
OnBoard fly(const ir::Mission& flown, const std::vector<Seen>& flight) {
  ir::Interpreter run(flown, 1);
  OnBoard seen;
  for (size_t i = 0; i < flight.size(); ++i) {
    const auto frame = frameOf(flown, flight[i]);
    const ir::TickResult result = i == 0 ? run.start(frame, {}) : run.tick(flight[i].time, frame);
    for (const ir::Note& note : result.notes) {
      EXPECT_TRUE(note.text.starts_with("assumption broken: ")) << note.text;
      seen.notes.push_back(flight[i].time);
    }
    seen.states.push_back(result.state.index);
    if (result.finished) {
      break;
    }
  }
  return seen;
}

/// One note, on the tick that breaks it; between monitors of requirements, which do not fly.
TEST_P(Assumptions, AreNotedOnBoardOnceAndChangeNothing) {
  const Assumed assumed = assumptions()[GetParam()];
  constexpr const char* kRequired =
      "require visit up within 2 h\nrequire whenever pressure > 2 bar then altitude > 10 m within "
      "20 s\n";
  ir::Mission flown = compiled(patrol(fmt::format("{}assume {}\n", kRequired, assumed.text)));
  ir::Mission plain = compiled(patrol(kRequired));
  ir::prepareForFlight(flown);
  ir::prepareForFlight(plain);
  ASSERT_TRUE(ir::validate(flown).empty()) << ir::print(flown);
  EXPECT_TRUE(
      std::ranges::none_of(flown.variables, [](const auto& v) { return ir::isOfMonitor(v.kind); }));
  EXPECT_EQ(readAgain(flown), ir::print(flown));
  std::mt19937 rng(11);
  size_t broken = 0;
  for (int i = 0; i < 500; ++i) {
    const auto flight = assumedFlight(rng);
    const OnBoard seen = fly(flown, flight);
    EXPECT_EQ(seen.states, fly(plain, flight).states);
    const auto when = firstOf(assumed.broken, flight);
    const bool in_flight = when && *when <= flight.at(seen.states.size() - 1).time;
    EXPECT_EQ(seen.notes, in_flight ? std::vector{*when} : std::vector<double>()) << "flight " << i;
    broken += in_flight ? 1U : 0U;
  }
  EXPECT_GT(broken, 25U);
  EXPECT_LT(broken, 490U);
}

TEST_P(Assumptions, HaveATextForm) {
  const ir::Mission mission = compiled(patrol(fmt::format(
      "require always pressure <= 2 bar\nassume {}\nassume current <= 0.3 m/s\n"
      "assume start depth <= 1 m\nassume start inside(39 N 74 W, 39 N 73 W, 40 N 73.5 W)",
      assumptions()[GetParam()].text)));
  EXPECT_EQ(mission.assumptions.size(), 4U);
  EXPECT_EQ(readAgain(mission), ir::print(mission));
}

INSTANTIATE_TEST_SUITE_P(All, Assumptions, testing::Range(size_t{0}, assumptions().size()));

/// A tick has room for 16 notes.
TEST(AssumptionNotes, LeaveRoomForTheMissionsOwn) {
  std::string text = "mission m\n";
  constexpr size_t kAssumed = 20;
  for (size_t i = 0; i < kAssumed; ++i) {
    text += fmt::format("assume altitude > {} m\n", 60 + i);
  }
  text += R"(
state look
begin
  flightprofile yo(5 m, 25 m, 26 deg, 26 deg)
  sensors       missiontime, altitude
  events
    case missiontime >= 1 h      exit
    case became(altitude < 50 m) do log "near" end stay
end
)";
  ir::Mission flown = compiled(text);
  ir::prepareForFlight(flown);
  ir::Interpreter run(flown, 1);
  std::vector<std::string> notes;
  for (size_t i = 0; i < 2 + kAssumed; ++i) {
    const double altitude = i == 1 ? 40 : 100;  // broken on one tick only
    const auto frame = frameOf(flown, {kCycle * static_cast<double>(i), altitude, 1});
    const ir::TickResult result =
        i == 0 ? run.start(frame, {}) : run.tick(4.0 * static_cast<double>(i), frame);
    for (const ir::Note& note : result.notes) {
      notes.push_back(fmt::format("{}: {}", i, note.text));
    }
  }
  std::vector<std::string> expected = {"1: assumption broken: altitude > 60 m", "1: near"};
  for (size_t i = 1; i < kAssumed; ++i) {
    expected.push_back(fmt::format("{}: assumption broken: altitude > {} m", 1 + i, 60 + i));
  }
  EXPECT_EQ(notes, expected);
}

}  // namespace
}  // namespace glider::tests
