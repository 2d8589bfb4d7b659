// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/mission_facts.h"

#include "compiler/boards.h"
#include "ir/core/walk.h"
#include "ir/eval/arithmetic.h"
#include "ir/eval/evaluate.h"
#include "ir/eval/interpreter.h"
#include "ir/prove/energy/energy_bound.h"
#include "platforms/load/power.h"
#include "support/one_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_set>
#include <variant>

namespace glider::flights {
namespace {

using ir::ExprId;
using ir::Op;

void addOnce(std::vector<std::string>& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) {
    names.push_back(name);
  }
}

/// Calls `visit` once for the expression at `root` and for each one in it and in its temporals, in
/// the order of the text.
void visitAll(const ir::Mission& m, ExprId root, const std::function<void(ExprId)>& visit) {
  std::vector<ExprId> open{root};
  std::unordered_set<uint32_t> seen;
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    if (!id.valid() || !seen.insert(id.index).second) {
      continue;
    }
    visit(id);
    const ir::Expr& e = m[id];
    open.insert(open.end(), e.operands.rend() - static_cast<std::ptrdiff_t>(ir::operandCount(e)),
                e.operands.rend());
    if (e.op == Op::Temporal) {
      open.push_back(m[e.temporal].operand);
    }
  }
}

void visitBlock(const ir::Mission& m, ir::BlockId block, const std::function<void(ExprId)>& visit) {
  ir::forEachStatement(m, block, [&](const ir::Statement& statement) {
    visitAll(m, statement.value, visit);
    for (const ExprId value : statement.values) {
      visitAll(m, value, visit);
    }
  });
}

/// Calls `visit` for each list of cases: those of the mission and its states first, then those of
/// their profiles and routes.
void forEachList(const ir::Mission& m,
                 const std::function<void(const std::vector<ir::Case>&)>& visit) {
  visit(m.always);
  for (const ir::State& state : m.states) {
    visit(state.cases);
  }
  for (const ir::State& state : m.states) {
    visit(state.profile.cases);
    visit(state.route.cases);
  }
}

std::vector<std::string> readSensors(const ir::Mission& m) {
  std::vector<std::string> names;
  const auto note = [&](ExprId id) {
    const ir::Expr& e = m[id];
    if (e.sensor.valid()) {
      addOnce(names, m[e.sensor].vehicle_name);
    }
  };
  forEachList(m, [&](const std::vector<ir::Case>& cases) {
    for (const ir::Case& one : cases) {
      visitAll(m, one.guard, note);
    }
  });
  forEachList(m, [&](const std::vector<ir::Case>& cases) {
    for (const ir::Case& one : cases) {
      visitBlock(m, one.action, note);
    }
  });
  return names;
}

/// Whether `text` is one name of the language.
bool isName(std::string_view text) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  return !text.empty() && letter(text[0]) &&
         std::ranges::all_of(text, [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

constexpr std::string_view kLatitude = ".latitude";

/// Finds each place and each watch circle that the expressions of a mission name. A position is two
/// numbers, latitude and longitude; those of a constant have the range of its name.
class PlaceFinder {
 public:
  PlaceFinder(const compiler::Checked& mission, const std::vector<double>& parameters)
      : mission_(mission), m_(mission.mission()), parameters_(parameters) {
    notePassed();
  }

  void addPlaces(support::MissionFacts& facts) const {
    for (size_t i = 0; i + 1 < m_.exprs.size(); ++i) {
      const ir::Expr &lat = m_.exprs[i], &lon = m_.exprs[i + 1];
      const bool position = lat.op == Op::Constant && lon.op == Op::Constant &&
                            lat.type.kind == ir::TypeKind::Latitude &&
                            lon.type.kind == ir::TypeKind::Longitude;
      if (!position || !lat.range.valid() || !(lat.range == lon.range)) {
        continue;
      }
      const std::string name(mission_.sources().text(lat.range));
      const auto known = std::ranges::find(facts.places, name, &support::NamedPlace::name);
      if (isName(name) && known == facts.places.end()) {
        facts.places.push_back({name, lat.number, lon.number});
      }
    }
  }

  /// The positions that are parameters, as they were set.
  void addParameters(support::MissionFacts& facts) const {
    for (size_t i = 0; i + 1 < parameters_.size(); ++i) {
      const ir::Variable &lat = m_.variables[i], &lon = m_.variables[i + 1];
      const bool position = lat.type.kind == ir::TypeKind::Latitude &&
                            lon.type.kind == ir::TypeKind::Longitude &&
                            lat.name.ends_with(kLatitude);
      if (position) {
        facts.places.push_back({lat.name.substr(0, lat.name.size() - kLatitude.size()),
                                parameters_[i], parameters_[i + 1]});
      }
    }
  }

  /// The points of each path that a state steers along, in their order: "track 1", "track 2", …
  void addPaths(support::MissionFacts& facts) const {
    std::vector<uint32_t> seen;  // tables of latitudes
    for (const ir::State& state : m_.states) {
      const auto note = [&](const ir::Statement& statement, const support::SourceRange& use) {
        const bool steers =
            statement.command == ir::Command::SteerTo && statement.values.size() > 1;
        if (!steers || m_[statement.values[0]].op != Op::Element ||
            m_[statement.values[1]].op != Op::Element) {
          return;
        }
        const ir::TableId north = m_[statement.values[0]].table;
        if (std::ranges::find(seen, north.index) == seen.end()) {
          seen.push_back(north.index);
          addPath(pathName(use, state.name), m_[north], m_[m_[statement.values[1]].table], facts);
        }
      };
      for (const ir::Activity* activity : {&state.route, &state.profile}) {
        const auto look = [&](ir::BlockId block) {
          ir::forEachStatement(m_, block, [&](const auto& one) { note(one, activity->range); });
        };
        look(activity->entry);
        for (const ir::Case& one : activity->cases) {
          look(one.action);
        }
      }
    }
  }

  void addWatched(support::MissionFacts& facts) const {
    forEachList(m_, [&](const std::vector<ir::Case>& cases) {
      for (const ir::Case& one : cases) {
        visitAll(m_, one.guard, [&](ExprId id) { addWatchedOf(m_[id], facts); });
      }
    });
  }

 private:
  /// The name of the path in `along(track, 100 m)`; `otherwise` if it has none there.
  [[nodiscard]] std::string pathName(const support::SourceRange& use,
                                     const std::string& otherwise) const {
    if (!use.valid()) {
      return otherwise;
    }
    const std::string text(mission_.sources().text(use));
    const size_t open = std::min(text.find('('), text.size());
    std::string first = text.substr(open, text.find_first_of(",)", open) - open);
    first.erase(0, std::min(first.find('=') + 1, first.size()));
    std::erase_if(first, [](char c) { return c == '(' || c == ' ' || c == '\n'; });
    return isName(first) ? first : otherwise;
  }

  static void addPath(const std::string& name, const ir::Table& north, const ir::Table& east,
                      support::MissionFacts& facts) {
    for (size_t i = 0; i < std::min(north.values.size(), east.values.size()); ++i) {
      facts.places.push_back({name + " " + std::to_string(i + 1), north.values[i], east.values[i]});
    }
  }

  /// The constants that transitions pass to each argument of a state.
  void notePassed() {
    forEachList(m_, [&](const std::vector<ir::Case>& cases) {
      for (const ir::Case& one : cases) {
        for (size_t i = 0; i < one.arguments.size(); ++i) {
          passed_[m_[one.target].parameters[i].index].push_back(one.arguments[i]);
        }
      }
    });
  }

  /// The value of a number that is made of constants and parameters; NaN if it reads anything else.
  [[nodiscard]] double fixed(ExprId id) const {
    const auto leaves = [this](const ir::Expr& e, std::span<const double>) {
      // Parameters come first among the variables.
      const bool parameter = e.op == Op::Variable && e.variable.index < parameters_.size();
      return ir::asValue(parameter ? parameters_[e.variable.index] : ir::kUnknown, e.type);
    };
    return std::get<double>(ir::evaluate(m_, id, leaves));
  }

  /// All values that a coordinate of a position can have; empty if they are not known.
  [[nodiscard]] std::vector<double> coordinates(ExprId id) const {
    std::vector<double> values;
    const ir::Expr& e = m_[id];
    const auto passed = e.op == Op::Variable ? passed_.find(e.variable.index) : passed_.end();
    if (passed != passed_.end()) {
      for (const ExprId argument : passed->second) {
        values.push_back(fixed(argument));
      }
    } else {
      values.push_back(fixed(id));
    }
    return values;
  }

  /// Of a comparison of a distance from the vehicle with a fixed length.
  void addWatchedOf(const ir::Expr& e, support::MissionFacts& facts) const {
    if (!ir::isComparison(e.op)) {
      return;
    }
    for (const size_t side : {0U, 1U}) {
      const ir::Expr& distance = m_[e.operands[side]];
      if (distance.op == Op::Distance) {
        addWatchedAround(distance, fixed(e.operands[1 - side]), facts);
      }
    }
  }

  void addWatchedAround(const ir::Expr& distance, double radius_m,
                        support::MissionFacts& facts) const {
    for (const size_t first : {0U, 2U}) {
      const auto latitudes = coordinates(distance.operands[first]);
      const auto longitudes = coordinates(distance.operands[first + 1]);
      for (size_t i = 0; i < std::min(latitudes.size(), longitudes.size()); ++i) {
        addWatch({latitudes[i], longitudes[i], radius_m}, facts);
      }
    }
  }

  static void addWatch(const support::WatchCircle& circle, support::MissionFacts& facts) {
    const auto same = [&](const support::WatchCircle& other) {
      return other.latitude_deg == circle.latitude_deg &&
             other.longitude_deg == circle.longitude_deg && other.radius_m == circle.radius_m;
    };
    if (std::isfinite(circle.latitude_deg) && std::isfinite(circle.longitude_deg) &&
        circle.radius_m > 0 && std::ranges::none_of(facts.watch_circles, same)) {
      facts.watch_circles.push_back(circle);
    }
  }

  const compiler::Checked& mission_;
  const ir::Mission& m_;
  const std::vector<double>& parameters_;
  std::map<uint32_t, std::vector<ExprId>> passed_;  ///< by the index of the argument
};

/// What flights with these parameters take at most until they end; nothing if they are not the
/// defaults, for which the bound is.
std::vector<support::Consumer> atMost(const compiler::Checked& mission,
                                      const std::vector<double>& parameters) {
  std::vector<support::Consumer> all;
  const auto board = compiler::usualBoardPower(mission.worlds.widest.platform);
  if (!board || parameters != ir::defaultParameters(mission.mission())) {
    return all;
  }
  const auto bound = ir::prove::energyBoundOf(mission.mission(), mission.worlds.widest.platform,
                                              *board, ir::prove::Parameters::AsWritten);
  if (bound && bound->joules) {
    for (const ir::prove::DeviceEnergy& one : bound->devices) {
      all.push_back({one.device, one.joules / platforms::kJoulesPerWattHour});
    }
  }
  return all;
}

}  // namespace

std::vector<std::string> listedSensors(const ir::Mission& mission) {
  std::vector<std::string> names;
  for (const ir::State& state : mission.states) {
    for (const ir::LogItem& item : state.log) {
      const ir::Expr& e = mission[item.value];
      if (e.op == Op::Sensor && mission[e.sensor].symbol.empty()) {
        addOnce(names, mission[e.sensor].vehicle_name);
      }
    }
  }
  return names;
}

support::MissionFacts missionFacts(const compiler::Optimised& mission,
                                   const std::vector<double>& parameters) {
  support::MissionFacts facts;
  facts.listed = listedSensors(mission.checked->mission());
  facts.read = readSensors(mission.checked->mission());
  const PlaceFinder finder(*mission.checked, parameters);
  finder.addParameters(facts);
  finder.addPlaces(facts);
  finder.addPaths(facts);
  finder.addWatched(facts);
  facts.at_most = atMost(*mission.checked, parameters);
  return facts;
}

std::vector<support::FlownPromise> flownPromises(const RequirementWatch& watch,
                                                 const compiler::Checked& mission,
                                                 const FlownOutcome& found) {
  const std::vector<std::string> texts = watchedTexts(mission);
  const std::vector<ir::Requirement>& requirements = mission.mission().requirements;
  std::vector<support::FlownPromise> promises;
  for (size_t i = 0; i < texts.size(); ++i) {
    support::FlownPromise promise{texts[i], support::Verdict::Held, std::nullopt, ""};
    const auto violation = std::ranges::find(found.violations, i, &FlownViolation::number);
    const auto undecided = std::ranges::find(found.undecided, i, &UndecidedRequirement::number);
    if (violation != found.violations.end()) {
      promise.verdict = support::Verdict::Violated;
      promise.vehicle_time_s = violation->vehicle_time;
      promise.words = violation->words +
                      (violation->words.empty() || violation->after.empty() ? "" : "; ") +
                      violation->after;
    } else if (i < requirements.size() && requirements[i].kind == ir::RequirementKind::Reach) {
      promise.verdict = support::Verdict::NotChecked;
      promise.words = "it says what some flight can do";
    } else if (watch.departed()) {
      promise.verdict = support::Verdict::NotChecked;
      promise.vehicle_time_s = watch.departed();
      promise.words = "the SBC did something else than the watched mission";
    } else if (undecided != found.undecided.end()) {
      promise.verdict = support::Verdict::Undecided;
      promise.words = undecided->why;
    }
    promises.push_back(std::move(promise));
  }
  return promises;
}

}  // namespace glider::flights
