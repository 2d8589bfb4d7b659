// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/naps/sleepy_mission.h"

#include "tests/random_missions/random.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace glider::naps {
namespace {

using random_missions::Random;

constexpr const char* kComparisons[] = {"<", "<=", ">", ">=", "==", "!="};

class Writer {
 public:
  explicit Writer(uint64_t seed) : random_(seed) {}

  std::string mission() {
    states_ = random_.between(2, 4);
    std::string text = fmt::format("mission sleepy{}", parameters());
    text += profile();
    if (random_.chance(0.5)) {
      text += "always\n" + cases(2, false);
    }
    for (uint32_t i = 0; i < states_; ++i) {
      text += state(i);
    }
    return text;
  }

 private:
  std::string parameters() {
    return "\nparam deep: length = 8 m in 0 m .. 10 m\nparam long: time = 100 s in 0 s .. 200 s\n"
           "var flag: bool = false\nvar tally: number = 0\n"
           "var aim: length = 6 m in 0 m .. 10 m\nvar wait: time = 8 s in 0 s .. 60 s\n";
  }

  /// One that commands by what it reads.
  std::string profile() {
    in_profile_ = true;
    std::string text = fmt::format(
        "flightprofile own(at: length, deep: length, long: time)\nbegin\n  var down: bool = {}\n"
        "  entry do if {} then descend(at, 26 deg) else ascend(2 m, 26 deg) end end\n  events\n"
        "    case {} do set down = {} if {} then descend(at, 26 deg) else ascend(2 m, 26 deg) end "
        "end stay\n"
        "    case {} do if down then hover(at) end end stay\n"
        "    case {} do ascend(3 m, 26 deg) end stay\nend\n",
        random_.chance(0.5), guard(1), guard(1), guard(1), guard(0), guard(0), guard(1));
    in_profile_ = false;
    return text;
  }

  std::string state(uint32_t number) {
    const char* profiles[] = {"yo(3 m, deep)", "own(6 m, 4 m, 50 s)", "own(deep, deep, long)",
                              "dive_to(7 m)",  "climb_to(2 m)",       "hover_at(5 m)",
                              "surfaced"};
    is_last_ = number == states_ - 1;
    const char* routes[] = {"heading(90 deg)", "noheading", "nav(39 N 73 W)"};
    return fmt::format(
        "state s{}\nbegin\n  flightroute {}\n  flightprofile {}\n"
        "  sensors missiontime, depth, temp, battery\n  events\n{}end\n",
        number, random_.pick(routes), random_.pick(profiles), cases(random_.between(1, 3), true));
  }

  std::string cases(uint32_t count, bool whole) {
    std::string text;
    for (uint32_t i = 0; i < count; ++i) {
      text += fmt::format("    case {}{} {}\n", guard(2), action(), transition());
    }
    return text + (whole ? "" : "");
  }

  std::string action() {
    switch (random_.between(0, 13)) {
      case 0:
        return fmt::format(" do set flag = {} end", random_.chance(0.5));
      case 1:
        return fmt::format(" do set flag = {} end", guard(1));
      case 2:
        return " do set tally = tally + 1 end";
      case 3:
        return fmt::format(" do if {} then set flag = {} end end", guard(1), random_.chance(0.5));
      case 4:
        return fmt::format(" do if flag then set flag = false else {} end end", command());
      case 5:
        return fmt::format(" do {} set aim = {} m end", command(), random_.between(1, 9));
      case 6:
        return fmt::format(" do set wait = {} s end", 4 * random_.between(1, 8));
      case 7:
        return fmt::format(" do {} end", command());
      default:
        return "";
    }
  }

  std::string command() {
    const char* commands[] = {"descend(aim, 26 deg)", "ascend(2 m, 26 deg)", "hover(aim)",
                              "descend(9 m, 26 deg)"};
    return random_.pick(commands);
  }

  /// The last state is called by the others, and returns.
  std::string transition() {
    if (random_.chance(0.4)) {
      return "stay";
    }
    if (is_last_) {
      return "return";
    }
    const uint32_t to = random_.between(0, states_ - 1);
    return fmt::format("{} s{}", to == states_ - 1 ? "call" : "goto", to);
  }

  // NOLINTNEXTLINE(misc-no-recursion): to that depth
  std::string guard(uint32_t depth) {
    if (depth == 0 || random_.chance(0.3)) {
      return atom();
    }
    switch (random_.between(0, 4)) {
      case 0:
        return fmt::format("!({})", guard(depth - 1));
      case 1:
        return fmt::format("({} || {})", guard(depth - 1), guard(depth - 1));
      case 2:
        return fmt::format("became({})", guard(depth - 1));
      case 3:
        return in_profile_ || random_.chance(0.7)
                   ? fmt::format("held({}, {} s)", guard(depth - 1), 4 * random_.between(1, 6))
                   : fmt::format("held({}, wait)", guard(depth - 1));
      default:
        return fmt::format("({} && {})", guard(depth - 1), guard(depth - 1));
    }
  }

  std::string atom() {
    const char* compares = random_.pick(kComparisons);
    switch (random_.between(0, 9)) {
      case 0:
        return fmt::format("known({})", random_.chance(0.5) ? "depth" : "temp");
      case 1:
        return fmt::format("statetime {} {} s", compares, random_.between(0, 200));
      case 2:
        return fmt::format("missiontime - long {} {} s", compares, random_.between(0, 600));
      case 3:
        return in_profile_ ? "down" : "flag";
      case 4:
        return fmt::format("temp {} {} degC", compares, random_.between(0, 10));
      case 5:
        return fmt::format("depth {} deep - {} m", compares, random_.between(0, 6));
      case 6:
        return fmt::format("{} s {} resumetime + {} s", random_.between(0, 300), compares,
                           random_.between(0, 60));
      case 7:
        if (in_profile_) {
          return "!down";
        }
        return fmt::format("tally {} {}", compares, random_.between(0, 5));
      default:
        return fmt::format("depth {} {} m", compares, random_.between(0, 10));
    }
  }

  Random random_;
  uint32_t states_ = 0;
  bool in_profile_ = false;
  bool is_last_ = false;
};

/// What one sensor reports: slowly up and down between -1 and 11, often nothing new.
class SlowSensor {
 public:
  explicit SlowSensor(Random& random) : random_(random), value_(random.between(0, 10)) {}

  std::optional<double> next() {
    if (silent_ > 0) {
      --silent_;
      return std::nullopt;
    }
    if (random_.chance(0.01)) {
      silent_ = random_.between(2, 30);
    }
    if (random_.chance(0.01)) {
      constexpr double kImpossible[] = {std::numeric_limits<double>::quiet_NaN(), -1e9, 1e9,
                                        std::numeric_limits<double>::infinity()};
      return random_.pick(kImpossible);
    }
    if (random_.chance(0.25)) {
      value_ = std::clamp(value_ + (random_.chance(0.5) ? 1.0 : -1.0), -1.0, 11.0);
    } else if (random_.chance(0.1)) {
      value_ = std::clamp(value_ + random_.uniform(-0.5, 0.5), -1.0, 11.0);
    } else if (random_.chance(0.1)) {
      value_ = std::round(value_);
    }
    return random_.chance(0.9) ? std::optional(value_) : std::nullopt;
  }

 private:
  Random& random_;
  double value_;
  uint32_t silent_ = 0;
};

}  // namespace

std::string sleepyMission(uint64_t seed) {
  return Writer(seed).mission();
}

std::vector<random_missions::StreamTick> slowStream(const ir::Mission& mission, uint64_t seed,
                                                    size_t ticks) {
  Random random(seed);
  std::vector<SlowSensor> sensors(mission.sensors.size(), SlowSensor(random));
  std::vector<random_missions::StreamTick> stream(ticks + 1);
  double time = 0;
  for (random_missions::StreamTick& tick : stream) {
    tick.mission_time = time;
    time += random.chance(0.95) ? 4 : random.between(0, 20);
    for (uint32_t i = 0; i < sensors.size(); ++i) {
      if (const auto raw = sensors[i].next()) {
        tick.frame.push_back({{i}, *raw});
      }
    }
  }
  return stream;
}

}  // namespace glider::naps
