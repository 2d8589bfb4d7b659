// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The monitors of promises against the formulas of the catalogue, on random flights that end: a
// promise is violated on the way, or at the end, if and only if its formula is false of the flight.

#include "ir/eval/interpreter.h"
#include "ir/prove/context/requirement_monitor.h"
#include "ir/text/print.h"
#include "ir/text/read.h"
#include "tests/promises/formulas.h"
#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>

namespace glider::tests {
namespace {

using ltl::Flight;
using ltl::Formula;

constexpr size_t kStates = 4;  ///< a, b, c, and d, which no promise names
constexpr size_t kFlights = 400;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// `temp` says which state is entered: 10 to 13 degC; 14 degC ends the mission. Otherwise the
/// current one stays. `altitude` and `pressure` are the conditions p and q: more than 1 is true.
std::string missionWith(const std::string& requirement) {
  std::string text = "mission m\nplace p = altitude > 1 m\nplace q = pressure > 1 bar\nrequire " +
                     requirement + "\n";
  for (size_t i = 0; i < kStates; ++i) {
    text += fmt::format(
        "state {}\nbegin\n  flightprofile surfaced\n  sensors temp\n  events\n"
        "    case temp > 13.5 degC exit\n",
        static_cast<char>('a' + (i + 3) % kStates));
    for (int to = 0; to < static_cast<int>(kStates); ++to) {
      text += fmt::format("    case temp > {} degC && temp < {} degC goto {}\n", 9.5 + 1.0 * to,
                          10.5 + 1.0 * to, static_cast<char>('a' + to));
    }
    text += "end\n";
  }
  return text;
}

/// What the vehicle reports on a tick.
struct Chosen {
  double time = 0;
  int state = -1;  ///< to enter; kStates: the end
  int cause = 0;
  int response = 0;
};

std::vector<Chosen> randomFlight(std::mt19937& rng) {
  std::vector<Chosen> ticks;
  const auto below = [&](unsigned n) { return static_cast<int>(rng() % n); };
  const int length = below(20) == 0 ? 120 : 1 + below(14);
  const unsigned stays = 1 + static_cast<unsigned>(rng() % 3);
  double time = 0;
  for (int i = 0; i <= length; ++i) {
    Chosen one;
    one.time = time;
    time += 4.0 * (1 + below(4));
    one.state = below(1 + stays) == 0 ? below(kStates) : -1;
    one.cause = below(3) == 0 ? 1 : below(5) == 0 ? -1 : 0;
    one.response = below(3) == 0 ? 0 : below(5) == 0 ? -1 : 1;
    ticks.push_back(one);
  }
  ticks.front().state = -1;
  ticks.back().state = kStates;
  return ticks;
}

double readingOf(int truth) {
  return truth < 0 ? kUnknown : truth == 0 ? 0.5 : 2;
}

class Flown {
 public:
  explicit Flown(const ir::Mission& mission) : m_(mission) {}

  /// Whether the monitor sees a violation; `flight` is what the promise is about.
  bool violated(const std::vector<Chosen>& ticks, Flight& flight) const {
    ir::Interpreter run(m_, 1);
    ir::RequirementMonitor monitor(m_, m_.requirements.at(0), 1.0, std::nullopt);
    for (size_t i = 0; i < ticks.size(); ++i) {
      const auto frame = frameOf(ticks[i]);
      const ir::TickResult result = i == 0 ? run.start(frame, {}) : run.tick(ticks[i].time, frame);
      monitor.tick(run, ticks[i].time, result, kUnknown);
      flight.push_back(tickOf(ticks[i], result, i == 0));
    }
    const bool watched = m_.requirements.at(0).monitor.step.valid();
    EXPECT_EQ(monitor.words().empty(), !watched || !monitor.when()) << monitor.words();
    return monitor.when().has_value();
  }

 private:
  [[nodiscard]] std::vector<ir::SensorUpdate> frameOf(const Chosen& tick) const {
    std::vector<ir::SensorUpdate> frame;
    for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
      const std::string& name = m_.sensors[i].name;
      const double value = name == "temp"       ? (tick.state < 0 ? 0.0 : 10.0 + tick.state)
                           : name == "altitude" ? readingOf(tick.cause)
                                                : readingOf(tick.response);
      frame.push_back({{i}, value});
    }
    return frame;
  }

  [[nodiscard]] ltl::Tick tickOf(const Chosen& chosen, const ir::TickResult& result,
                                 bool start) const {
    ltl::Tick tick{chosen.time, std::vector<bool>(kStates), std::vector<bool>(kStates),
                   chosen.cause, chosen.response};
    const auto now = static_cast<size_t>(m_[result.state].name[0] - 'a');
    tick.inside[now] = true;
    tick.entered[now] = start || (chosen.state >= 0 && chosen.state < static_cast<int>(kStates));
    return tick;
  }

  const ir::Mission& m_;
};

struct Promise {
  std::string text;
  Formula formula;
  friend void PrintTo(const Promise& promise, std::ostream* out) { *out << promise.text; }
};

Formula visit(size_t state) {
  return ltl::atom([state](const ltl::Tick& t) { return t.entered[state]; });
}
Formula in(size_t state) {
  return ltl::atom([state](const ltl::Tick& t) { return t.inside[state]; });
}
Formula early(double seconds) {
  return ltl::atom([seconds](const ltl::Tick& t) { return t.time <= seconds; });
}
Formula p(int value = 1) {
  return ltl::atom([value](const ltl::Tick& t) { return t.cause == value; });
}
Formula q(int value = 1) {
  return ltl::atom([value](const ltl::Tick& t) { return t.response == value; });
}

/// F(l1 & F(l2 & F l3)), all within the time.
Formula sequence(const std::vector<size_t>& places, double seconds) {
  Formula chain;
  for (size_t i = places.size(); i-- > 0;) {
    const Formula here = ltl::both(visit(places[i]), early(seconds));
    chain = ltl::eventually(chain ? ltl::both(here, chain) : here);
  }
  return chain;
}

/// !l(i+1) U li, which the sequence makes happen.
Formula ordered(const std::vector<size_t>& places) {
  std::vector<Formula> parts;
  for (size_t i = 0; i + 1 < places.size(); ++i) {
    parts.push_back(ltl::until(ltl::no(visit(places[i + 1])), visit(places[i])));
  }
  return ltl::all(parts);
}

/// !li U (li & X(!li U l(i+1))).
Formula strict(const std::vector<size_t>& places) {
  std::vector<Formula> parts;
  for (size_t i = 0; i + 1 < places.size(); ++i) {
    const Formula here = visit(places[i]);
    parts.push_back(
        ltl::until(ltl::no(here),
                   ltl::both(here, ltl::next(ltl::until(ltl::no(here), visit(places[i + 1]))))));
  }
  return ltl::all(parts);
}

/// G(li -> X(!li W l(i + step))), round the list.
Formula waits(const std::vector<size_t>& places, size_t step) {
  std::vector<Formula> parts;
  for (size_t i = 0; i < places.size(); ++i) {
    const Formula here = visit(places[i]);
    const Formula other = visit(places[(i + step) % places.size()]);
    parts.push_back(
        ltl::globally(ltl::implies(here, ltl::weakNext(ltl::weakUntil(ltl::no(here), other)))));
  }
  return ltl::all(parts);
}

/// !l(i+1) W li: before the first round.
Formula notBefore(const std::vector<size_t>& places) {
  std::vector<Formula> parts;
  for (size_t i = 0; i + 1 < places.size(); ++i) {
    parts.push_back(ltl::weakUntil(ltl::no(visit(places[i + 1])), visit(places[i])));
  }
  return ltl::all(parts);
}

Formula visitAll(const std::vector<size_t>& places, double seconds) {
  std::vector<Formula> parts;
  for (const size_t place : places) {
    parts.push_back(ltl::eventually(ltl::both(visit(place), early(seconds))));
  }
  return ltl::all(parts);
}

/// No tick is more than `seconds` after the last visit before it, or after the start.
Formula patrolled(const std::vector<size_t>& places, double seconds) {
  return [=](const Flight& f, size_t) {
    for (const size_t place : places) {
      double last = 0;
      for (const ltl::Tick& tick : f) {
        if (tick.time - last > seconds) {
          return false;
        }
        last = tick.entered[place] ? tick.time : last;
      }
    }
    return true;
  };
}

/// The same of whole rounds: the earliest end of each is found by trying all ticks.
Formula roundsOf(const std::vector<size_t>& places, double seconds) {
  return [=](const Flight& f, size_t) {
    double last = 0;
    size_t from = 0;
    for (size_t end = 0; end < f.size(); ++end) {
      if (f[end].time - last > seconds) {
        return false;
      }
      const Flight round(f.begin() + static_cast<std::ptrdiff_t>(from),
                         f.begin() + static_cast<std::ptrdiff_t>(end) + 1);
      if (sequence(places, std::numeric_limits<double>::infinity())(round, 0)) {
        last = f[end].time;
        from = end + 1;
      }
    }
    return true;
  };
}

Formula counted(size_t place, size_t least, size_t most, double seconds) {
  return [=](const Flight& f, size_t) {
    size_t all = 0;
    size_t soon = 0;
    for (const ltl::Tick& tick : f) {
      all += tick.entered[place] ? 1U : 0U;
      soon += tick.entered[place] && tick.time <= seconds ? 1U : 0U;
    }
    return all <= most && soon >= least;
  };
}

/// The same of the condition p: a visit begins where it becomes true.
Formula countedEdges(size_t most) {
  return [=](const Flight& f, size_t) {
    size_t all = 0;
    for (size_t i = 0; i < f.size(); ++i) {
      all += f[i].cause == 1 && (i == 0 || f[i - 1].cause != 1) ? 1U : 0U;
    }
    return all <= most;
  };
}

/// p on a tick, and not on the tick before.
Formula becomes(Formula a) {
  return
      [a = std::move(a)](const Flight& f, size_t i) { return a(f, i) && (i == 0 || !a(f, i - 1)); };
}

std::vector<Promise> promises() {
  constexpr double kT = 60;
  constexpr size_t kMany = 1000;
  const std::vector<size_t> abc{0, 1, 2};
  const std::vector<size_t> ab{0, 1};
  using ltl::all;
  using ltl::globally;
  using ltl::implies;
  using ltl::no;
  return {
      {"visit a, b, c within 60 s", visitAll(abc, kT)},
      {"visit a then b then c within 60 s", sequence(abc, kT)},
      {"visit a, b, c in order within 60 s", all({sequence(abc, kT), ordered(abc)})},
      {"visit a, b in strict order within 60 s", all({sequence(ab, kT), ordered(ab), strict(ab)})},
      {"visit a, b, c in strict order within 60 s",
       all({sequence(abc, kT), ordered(abc), strict(abc)})},
      {"visit a, b fairly within 60 s", all({visitAll(ab, kT), waits(ab, 1)})},
      {"visit a, b, c fairly within 60 s", all({visitAll(abc, kT), waits(abc, 1)})},
      {"patrol a, b every 60 s", patrolled(ab, kT)},
      {"patrol a then b every 60 s", roundsOf(ab, kT)},
      {"patrol a, b in order every 60 s", all({roundsOf(ab, kT), notBefore(ab), waits(ab, 1)})},
      {"patrol a, b, c in order every 100 s",
       all({roundsOf(abc, 100), notBefore(abc), waits(abc, 2)})},
      {"patrol a, b, c in strict order every 100 s",
       all({roundsOf(abc, 100), notBefore(abc), waits(abc, 2), waits(abc, 1)})},
      {"patrol a, b, c fairly every 100 s", all({patrolled(abc, 100), waits(abc, 1)})},
      {"never a before p", ltl::weakUntil(no(visit(0)), p())},
      {"never a", globally(no(visit(0)))},
      {"never p", globally(no(p()))},
      {"never a after p", globally(implies(p(), globally(no(visit(0)))))},
      {"never p after q", globally(implies(q(), globally(no(p()))))},
      {"visit a at most 2 times", counted(0, 0, 2, kT)},
      {"visit a at least 2 times within 60 s", counted(0, 2, kMany, kT)},
      {"visit a exactly 2 times within 60 s", counted(0, 2, 2, kT)},
      {"visit p at most 2 times", countedEdges(2)},
      {"visit a at most 12 times", counted(0, 0, 12, kT)},
      {"visit a at least 11 times within 900 s", counted(0, 11, kMany, 900)},
      {"visit a then b then a within 60 s", sequence({0, 1, 0}, kT)},
      {"never a after a or exit", counted(0, 0, 1, kT)},
      {"whenever p then q", globally(implies(p(), no(q(0))))},
      {"whenever p then a", globally(implies(p(), in(0)))},
      {"when p then q", globally(implies(becomes(p()), no(q(0))))},
      {"whenever p then q within 20 s", globally(implies(p(), ltl::soon(20, q())))},
      {"when p then q within 20 s", globally(implies(becomes(p()), ltl::soon(20, q())))},
      {"whenever p then q for 20 s", globally(implies(p(), ltl::during(20, no(q(0)))))},
      {"when p then q for 20 s", globally(implies(becomes(p()), ltl::during(20, no(q(0)))))},
      {"whenever p then q next tick", globally(implies(p(), ltl::next(q())))},
      {"whenever and only when p then q",
       globally(all({implies(p(), no(q(0))), implies(q(), no(p(0)))}))},
      {"whenever and only when p then q next tick",
       globally(all({implies(p(), ltl::next(q())), implies(p(0), ltl::weakNext(no(q())))}))},
      {"hold q until p within 60 s", ltl::until(no(q(0)), ltl::both(p(), early(kT)))},
      {"in a: never p", globally(implies(in(0), no(p())))},
      {"outside a: never p", globally(implies(no(in(0)), no(p())))},
      {"before p: never a", ltl::weakUntil(no(visit(0)), p())},
      {"after p: never a", globally(implies(p(), globally(no(visit(0)))))},
      {"from p to q: never a",
       globally(implies(all({p(), no(q())}), ltl::weakUntil(no(visit(0)), q())))},
  };
}

class Monitors : public testing::TestWithParam<Promise> {};

TEST_P(Monitors, SeeWhatTheFormulaSays) {
  frontend::testing_support::FrontendRun compiled(missionWith(GetParam().text));
  const auto mission = compiled.compile();
  ASSERT_TRUE(mission.has_value()) << compiled.said();
  std::mt19937 rng(7);  // NOLINT: the same flights each time
  const Flown flown(*mission);
  size_t broken = 0;
  for (size_t i = 0; i < kFlights; ++i) {
    const auto ticks = randomFlight(rng);
    Flight flight;
    const bool violated = flown.violated(ticks, flight);
    std::string story;
    for (const ltl::Tick& tick : flight) {
      story += fmt::format("\n{} s:", tick.time);
      for (size_t s = 0; s < kStates; ++s) {
        story += tick.inside[s] ? fmt::format(" {}{}", static_cast<char>('a' + s),
                                              tick.entered[s] ? " entered" : "")
                                : "";
      }
      story += fmt::format(", p {}, q {}", tick.cause, tick.response);
    }
    ASSERT_EQ(violated, !GetParam().formula(flight, 0)) << "flight " << i << story;
    broken += violated ? 1U : 0U;
  }
  EXPECT_GT(broken, 0U) << "no flight puts it to the test";
  EXPECT_LT(broken, kFlights) << "no flight meets it";
}

TEST_P(Monitors, AreTheSameInTheTextForm) {
  frontend::testing_support::FrontendRun compiled(missionWith(GetParam().text));
  const auto mission = compiled.compile();
  ASSERT_TRUE(mission.has_value()) << compiled.said();
  const std::string text = ir::print(*mission);
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const uint32_t file = sources.add("m.ir", text);
  const auto again = ir::read(sources, file, diagnostics);
  ASSERT_TRUE(again.has_value()) << text;
  EXPECT_EQ(ir::print(*again), text);
}

std::string nameOf(const testing::TestParamInfo<Promise>& info) {
  std::string name = std::to_string(info.index) + "_" + info.param.text;
  for (char& c : name) {
    c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Monitors, testing::ValuesIn(promises()), nameOf);

}  // namespace
}  // namespace glider::tests
