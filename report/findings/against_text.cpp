// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/findings/against.h"
#include "support/counted.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace glider::report {
namespace {

using support::SourceManager;

constexpr size_t kMostSteps = 30;    ///< of the mission that follows the files
constexpr size_t kMostStays = 3;     ///< in a row, one by one
constexpr size_t kMostFlickers = 3;  ///< of a case

using support::counted;

/// "83 %"; 0 and 100 only if that is exact.
std::string share(uint32_t part, uint32_t all) {
  const double percent = all == 0 ? 0 : 100.0 * part / all;
  if (part == 0 || part == all) {
    return fmt::format("{:.0f} %", percent);
  }
  return percent < 0.1    ? "under 0.1 %"
         : percent > 99.9 ? "over 99.9 %"
                          : fmt::format("{:.{}f} %", percent, percent < 10 || percent > 99 ? 1 : 0);
}

std::string number(double value) {
  return std::isnan(value) ? "unknown" : fmt::format("{:.6g}", value);
}

std::string withUnit(double value, const std::string& unit) {
  if (unit == kTruthUnit && !std::isnan(value)) {
    return value != 0 ? "true" : "false";
  }
  return std::isnan(value) || unit.empty() ? number(value) : number(value) + " " + unit;
}

std::string momentText(const LoggedMoment& at) {
  return fmt::format("{} ({:.2f} h)", at.utc, at.hours);
}

/// "line 12"; "figure2.mission:12" in another file than the mission's.
std::string lineText(const SourceManager& sources, support::SourceRange range) {
  if (!range.valid()) {
    return "case";
  }
  const uint32_t line = sources.place(range.file, range.begin).line;
  return range.file == 0 ? fmt::format("line {}", line)
                         : fmt::format("{}:{}", sources.name(range.file), line);
}

class Text {
 public:
  Text(const AgainstLogs& against, const SourceManager& sources) : a_(against), sources_(sources) {}

  std::string write() {
    head();
    sensors();
    guards();
    followed();
    return std::move(text_);
  }

 private:
  template <typename... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
    text_ += '\n';
  }

  void head() {
    line("{}: {}, {} to {} UTC ({:.2f} h), {}, one for each record of the {} computer", a_.vehicle,
         counted(a_.files.size(), "file"), a_.begin.utc, a_.end.utc, a_.end.hours,
         counted(a_.ticks, "tick"), a_.science ? "science" : "flight");
    if (a_.gaps > 0) {
      line("  {} without records for more than {:.0f} min, the longest {:.1f} h",
           counted(a_.gaps, "gap"), kLongGapSeconds / 60, a_.longest_gap_s / 3600);
    }
    for (const LoggedValue& parameter : a_.parameters) {
      line("  parameter {}: {}", parameter.name, withUnit(parameter.value, parameter.unit));
    }
    if (!a_.without_code.empty()) {
      line("  functions in C are not called, their results are unknown: {}",
           fmt::join(a_.without_code, ", "));
    }
  }

  void sensors() {
    if (a_.sensors.empty()) {
      return;
    }
    size_t widest = 0;
    for (const LoggedSensor& sensor : a_.sensors) {
      widest = std::max(widest, nameOf(sensor).size());
    }
    line("\nsensors that the mission uses");
    for (const LoggedSensor& sensor : a_.sensors) {
      line("  {:{}}  {}", nameOf(sensor), widest,
           sensor.known_ticks == 0
               ? "never known: " + sensor.problem
               : fmt::format("{}, known on {} of ticks, {} to {}",
                             counted(sensor.updates, "update"), share(sensor.known_ticks, a_.ticks),
                             number(sensor.least), withUnit(sensor.greatest, sensor.unit)));
    }
  }

  static std::string nameOf(const LoggedSensor& sensor) {
    return sensor.name == sensor.vehicle_name
               ? sensor.name
               : fmt::format("{} ({})", sensor.name, sensor.vehicle_name);
  }

  void guards() {
    line(
        "\nguards, each as if the mission had been in its state from the first tick on and nothing "
        "had left it");
    std::string before = "nothing";
    for (const LoggedCase& one : a_.cases) {
      const std::string place = one.state.empty() ? "always" : "state " + one.state;
      if (place != before) {
        line("  {}", place);
        before = place;
      }
      guard(one);
    }
    if (a_.cases.empty()) {
      line("  the mission has no cases of its own");
    }
  }

  void guard(const LoggedCase& one) {
    const bool behaviour = one.list == "profile" || one.list == "route";
    line("    {}{}: {} → {}", lineText(sources_, one.range),
         behaviour ? fmt::format(" ({})", one.list) : "", one.guard, one.transition);
    if (one.known_ticks == 0 && one.firings.empty()) {
      line("      never known{}{}", one.unknown_because.empty() ? "" : ": ",
           fmt::join(one.unknown_because, "; "));
      whenFollowed(one);
      return;
    }
    const std::string known = fmt::format("known on {} of ticks", share(one.known_ticks, a_.ticks));
    if (one.firings.empty()) {
      line("{}", one.true_ticks == 0
                     ? "      never true, " + known
                     : fmt::format(
                           "      does not fire: true on {} of ticks, on each of which an earlier "
                           "case fires; {}",
                           share(one.true_ticks, a_.ticks), known));
      whenFollowed(one);
      return;
    }
    line("      fires {}, true on {} of ticks, {}", times(one.firings.size()),
         share(one.true_ticks, a_.ticks), known);
    firing(one.firings.size() == 1 ? "at   " : "first", one.firings.front());
    if (one.firings.size() > 1) {
      firing("last ", one.firings.back());
    }
    flickers(one);
  }

  /// A guard may depend on what is set when the mission enters its state.
  void whenFollowed(const LoggedCase& one) {
    if (one.true_ticks == 0 && one.followed_true_ticks > 0) {
      line("      but true on {} of what the mission would have done, below",
           counted(one.followed_true_ticks, "tick"));
    }
  }

  static std::string times(size_t count) {
    return count == 1 ? "once" : count == 2 ? "twice" : fmt::format("{} times", count);
  }

  void firing(const char* word, const LoggedFiring& firing) {
    line("        {}  {}  {}", word, momentText(firing.at), loggedValues(firing.at, firing.values));
  }

  void flickers(const LoggedCase& one) {
    if (one.flickers.empty()) {
      return;
    }
    line("      flickers {} ({} times or more within {:.0f} s)", times(one.flickers.size()),
         kFlickerFirings, kFlickerSeconds);
    for (size_t i = 0; i < std::min(kMostFlickers, one.flickers.size()); ++i) {
      const Flicker& flicker = one.flickers[i];
      const LoggedFiring& first = one.firings.at(flicker.first);
      line("        from   {}  {}: fires {} within {:.0f} s", momentText(first.at),
           loggedValues(first.at, first.values), times(flicker.count), flicker.seconds);
    }
    if (one.flickers.size() > kMostFlickers) {
      line("        and {} more", one.flickers.size() - kMostFlickers);
    }
  }

  void followed() {
    line(
        "\nwhat the mission would have done; the vehicle did not obey it, so after a transition "
        "its "
        "own flight\nwould have brought other readings");
    size_t shown = 0;
    for (size_t i = 0; i < a_.followed.size() && shown < kMostSteps; ++shown) {
      const size_t stays = staysFrom(i);
      if (stays > kMostStays) {
        summary(i, stays);
        i += stays;
      } else {
        step(a_.followed[i]);
        ++i;
      }
      rest_ = a_.followed.size() - i;
    }
    if (rest_ > 0) {
      line("  and {} more; `--format json` lists all", rest_);
    }
    if (a_.followed.empty()) {
      line("  it does not start: the vehicle does not dive");
    }
  }

  /// How many steps from `i` on stay in one state.
  [[nodiscard]] size_t staysFrom(size_t i) const {
    size_t count = 0;
    while (i + count < a_.followed.size() && a_.followed[i + count].kind == FollowedKind::Stay &&
           a_.followed[i + count].from == a_.followed[i].from) {
      ++count;
    }
    return count;
  }

  /// Several steps that stay, as one line.
  void summary(size_t first, size_t count) {
    std::map<std::string, size_t> by_case;
    for (size_t i = first; i < first + count; ++i) {
      ++by_case[placeOf(a_.followed[i])];
    }
    std::string cases;
    for (const auto& [place, fired] : by_case) {
      cases += fmt::format("{}{} fires {}", cases.empty() ? "" : ", ", place, times(fired));
    }
    line("  {}  {}, until {}: {}", momentText(a_.followed[first].at), a_.followed[first].from,
         momentText(a_.followed[first + count - 1].at), cases);
  }

  [[nodiscard]] std::string placeOf(const FollowedStep& step) const {
    return (step.always ? "always, " : "") + lineText(sources_, step.range);
  }

  void step(const FollowedStep& step) {
    if (step.kind == FollowedKind::Start) {
      line("  {}  starts in {}: {}", momentText(step.at), step.to, loggedValues(step.at, {}));
      return;
    }
    if (step.kind == FollowedKind::Gap) {
      line("  {}  {} ends: no records for too long to continue (`resume within`)",
           momentText(step.at), step.from);
      return;
    }
    if (step.kind == FollowedKind::Violation || step.kind == FollowedKind::Assumption) {
      line("  {}  {}: {} `{}` ({}){}{}", momentText(step.at), step.from,
           step.kind == FollowedKind::Violation ? "violates" : "breaks", step.guard, placeOf(step),
           step.words.empty() ? "" : ": ", step.words);
      return;
    }
    const std::string what =
        step.kind == FollowedKind::Stay ? step.from + " (stay)"
        : step.kind == FollowedKind::Exit
            ? step.from + " → exit"
            : fmt::format("{} → {} ({})", step.from, step.to, wordOf(step.kind));
    line("  {}  {}, {}: {}", momentText(step.at), what, placeOf(step),
         loggedValues(step.at, step.values));
  }

  const AgainstLogs& a_;
  const SourceManager& sources_;
  std::string text_;
  size_t rest_ = 0;  ///< steps that are not shown
};

}  // namespace

const char* wordOf(FollowedKind kind) {
  switch (kind) {
#define FOLLOWED_STEP(name, word) \
  case FollowedKind::name:        \
    return word;
#include "report/findings/followed_steps.def"
#undef FOLLOWED_STEP
  }
  return "";
}

std::string loggedValues(const LoggedMoment& at, const std::vector<LoggedValue>& values) {
  std::string text =
      std::isnan(at.depth_m) ? "depth unknown" : fmt::format("depth {:.1f} m", at.depth_m);
  for (const LoggedValue& value : values) {
    if (value.name != "depth") {
      text += fmt::format(", {} {}", value.name, withUnit(value.value, value.unit));
    }
  }
  return text;
}

std::string againstText(const AgainstLogs& against, const SourceManager& sources) {
  return Text(against, sources).write();
}

}  // namespace glider::report
