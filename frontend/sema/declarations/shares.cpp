// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/shares.h"

#include "frontend/sema/declarations/declared_value.h"
#include "frontend/sema/declarations/externals.h"
#include "frontend/sema/declarations/share_fit.h"
#include "frontend/sema/names/values.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::frontend {

namespace {

/// What is received is unknown after as many periods, unless the share says otherwise: two messages
/// in a row may be lost.
constexpr double kPeriodsKept = 3;

/// What a share tells.
struct Told {
  ir::Type type;
  ir::SensorId sensor;
  ir::VariableId variable;
};

/// The numbers that a message holds.
struct Steps {
  double lowest = 0;
  double step = 1;
  uint32_t values = 2;
};

class ShareLowering {
 public:
  ShareLowering(const ast::Share& node, Scope& scope) : node_(node), scope_(scope) {}

  void run() {
    const auto told = this->told();
    const auto steps = told ? this->steps(told->type) : std::nullopt;
    const auto period = this->period();
    const auto stale =
        node_.stale_after ? staleAfter() : std::optional(kPeriodsKept * period.value_or(0));
    if (!told || !steps || !period || !stale) {
      scope_.refused_names.insert(heardName());
      return;
    }
    ir::Share share;
    share.name = node_.name.text;
    share.sensor = told->sensor;
    share.variable = told->variable;
    share.lowest = steps->lowest;
    share.step = steps->step;
    share.values = steps->values;
    share.period_s = *period;
    share.range = node_.where;
    hear(told->type, share, *stale);
    scope_.mission.shares.push_back(std::move(share));
  }

 private:
  [[nodiscard]] std::string heardName() const { return std::string(kPeerPrefix) + node_.name.text; }

  void refuse(std::string_view what) {
    scope_.report(support::diagnostics::shareOfWhat, node_.name.where, node_.name.text, what);
  }

  /// Empty, and reported, if it is not one value of the mission or of the vehicle.
  std::optional<Told> told() {
    if (Named* named = scope_.findNamed(node_.name.text)) {
      return toldOf(*named);
    }
    if (scope_.findConstant(node_.name.text) != nullptr) {
      refuse("a constant");
      return std::nullopt;
    }
    if (findClock(node_.name.text)) {
      refuse("a clock of the mission");
      return std::nullopt;
    }
    const platforms::PlatformSensor* sensor = scope_.findSensor(node_.name.text);
    if (sensor == nullptr) {
      if (!node_.variable && !scope_.refused_names.contains(node_.name.text)) {
        scope_.reportUnknown(support::diagnostics::unknownName, node_.name.where,
                             scope_.suggestName(node_.name.text), node_.name.text);
      }
      return std::nullopt;
    }
    const ir::SensorId id = scope_.subscribe(*sensor, node_.name.text);
    return Told{scope_.mission[id].type, id, {}};
  }

  std::optional<Told> toldOf(Named& named) {
    named.read = true;
    named.written = true;  // a vehicle that only receives never sets it
    if (!named.valid) {
      return std::nullopt;
    }
    if (named.array || named.type.position || named.type.path) {
      refuse(named.array ? "an array" : named.type.path ? "a path" : "a position");
      return std::nullopt;
    }
    return Told{named.type.type, {}, named.variable};
  }

  std::optional<ast::Range> range() const {
    return node_.variable ? node_.variable->range : node_.range;
  }

  /// A right line for it, with what is written so far.
  [[nodiscard]] std::string example(const ir::Type& type) const {
    if (type == boolean()) {
      return fmt::format("share {} every 10 min", node_.name.text);
    }
    const std::string range = this->range() ? scope_.text(whole(*this->range())) + " precision …"
                              : type == latitude()  ? "39 N .. 40 N precision 0.001 deg"
                              : type == longitude() ? "74 W .. 73 W precision 0.001 deg"
                              : type == quantity(support::dimension::length)
                                  ? "0 m .. 200 m precision 1 m"
                              : type == quantity(support::dimension::temperature)
                                  ? "-2 degC .. 35 degC precision 0.1 degC"
                                  : "… .. … precision …";
    return fmt::format("share {} in {} every 10 min", node_.name.text, range);
  }

  /// Empty, and reported, if it has no numbers to choose from, or too many.
  std::optional<Steps> steps(const ir::Type& type) {
    const std::optional<ast::Range> written = range();
    if (type == boolean()) {
      if (written || node_.precision) {
        scope_.report(support::diagnostics::shareForm, node_.where, node_.name.text,
                      "takes no range and no precision: it is true or false", example(type));
        return std::nullopt;
      }
      return Steps{};
    }
    if (!written || !node_.precision) {
      scope_.report(support::diagnostics::shareForm, node_.where, node_.name.text,
                    !written ? "needs a range and a precision: they say how many bits it takes"
                             : "needs a precision: it says how many bits it takes",
                    example(type));
      return std::nullopt;
    }
    const DeclaredType own{type};
    const auto bounds = DeclaredValue(node_.name, own, scope_).bounds(written);
    const auto step = this->step(type);
    return bounds && step ? stepsOf(*bounds, *step) : std::nullopt;
  }

  /// In the unit of the bounds: of a latitude or longitude in degrees.
  std::optional<double> step(const ir::Type& type) {
    const bool place = type.kind != ir::TypeKind::Quantity;
    const DeclaredType own{place ? quantity(support::dimension::angle) : type};
    const ast::Name role{"precision", node_.precision->where};
    const auto known = DeclaredValue(role, own, scope_).constant(*node_.precision, "the precision");
    if (!known) {
      return std::nullopt;
    }
    return place ? known->first * 180 / std::numbers::pi : known->first;
  }

  std::optional<Steps> stepsOf(const Bounds& bounds, double step) {
    constexpr double kMost = 1e9;  // below UINT32_MAX
    constexpr double kRounding = 1e-6;
    const double width = bounds.highest - bounds.lowest;
    const double count = std::round(width / step);
    const auto refuse = [&](std::string_view why, const std::string& hint) -> std::optional<Steps> {
      scope_.report(support::diagnostics::shareSteps, node_.precision->where,
                    scope_.text(node_.precision->where), why, scope_.text(whole(*range())), hint);
      return std::nullopt;
    };
    if (!(step > 0)) {
      return refuse("is not above 0, for",
                    "the precision is the difference of two neighbouring values");
    }
    if (step > width * (1 + kRounding)) {
      return refuse("is too coarse for", "only its lowest value could be sent");
    }
    if (!(count < kMost)) {
      return refuse("is too fine for", "a share has at most 1,000,000,000 values");
    }
    if (std::fabs(width / step - count) > kRounding * count) {
      return refuse("does not divide",
                    "end the range where a step ends: else its highest values could not be sent");
    }
    return Steps{bounds.lowest, stepWithin(bounds, count), static_cast<uint32_t>(count) + 1};
  }

  /// The step with which the last value is not above the range, in any rounding.
  static double stepWithin(const Bounds& bounds, double count) {
    double step = (bounds.highest - bounds.lowest) / count;
    while (bounds.lowest + count * step > bounds.highest) {
      step = std::nextafter(step, 0);
    }
    return step;
  }

  std::optional<double> time(const ast::Expr& expr, std::string_view after) {
    const DeclaredType type{quantity(support::dimension::time)};
    const auto known = DeclaredValue({std::string(after), expr.where}, type, scope_)
                           .constant(expr, fmt::format("the time after `{}`", after));
    return known ? std::optional(known->first) : std::nullopt;
  }

  /// Empty, and reported, if it is not a time above 0.
  std::optional<double> period() {
    const auto known = time(node_.every, "every");
    if (known && !(*known > 0)) {
      scope_.report(support::diagnostics::sharePeriod, node_.every.where, node_.name.text,
                    scope_.text(node_.every.where), "the time must be above 0 s",
                    "write for example `every 10 min`");
      return std::nullopt;
    }
    return known;
  }

  /// Empty, and reported, if it is not a time above 0.
  std::optional<double> staleAfter() {
    const auto known = time(*node_.stale_after, "stale after");
    if (known && !(*known > 0)) {
      scope_.report(support::diagnostics::staleNotPositive, node_.stale_after->where,
                    scope_.text(node_.stale_after->where));
      return std::nullopt;
    }
    return known;
  }

  void hear(const ir::Type& type, const ir::Share& share, double stale_after) {
    OwnSensor& heard = scope_.heard_sensors[heardName()];
    heard.name = &node_.name;
    platforms::PlatformSensor& sensor = heard.sensor;
    sensor.id = static_cast<uint16_t>(ir::kFirstHeardSensor + scope_.mission.shares.size());
    sensor.name = heardName();
    sensor.kind = kindOf(type);
    sensor.dimension = type.dimension;
    sensor.lowest = share.lowest;
    sensor.highest = share.lowest + (share.values - 1) * share.step;
    sensor.stale_after_s = stale_after;
    heard.usable = true;
  }

  const ast::Share& node_;
  Scope& scope_;
};

}  // namespace

void lowerShares(const ast::File& file, Scope& scope) {
  Context context;
  context.at_start = true;
  const Scope::Within within(scope, context);
  for (const ast::Item& item : file.items) {
    const auto* node = std::get_if<ast::Share>(&item);
    if (node == nullptr) {
      continue;
    }
    if (const ast::Share* first = firstShare(file, node->name.text); first != node) {
      scope.report(support::diagnostics::shareTwice, node->name.where, node->name.text)
          .note(first->name.where, "the first is here");
    } else if (scope.mission.shares.size() == ir::kMostShares) {
      scope.report(support::diagnostics::tooManyShares, node->name.where, node->name.text,
                   ir::kMostShares);
    } else {
      ShareLowering(*node, scope).run();
    }
  }
}

void finishShares(const ast::File& file, Scope& scope) {
  std::vector<ir::Share>& shares = scope.mission.shares;
  for (ir::Share& share : shares) {
    const auto heard = scope.heard_sensors.find(std::string(kPeerPrefix) + share.name);
    share.peer = scope.subscribed(heard->second.sensor);
  }
  // By name, so that the same lines in another order are the same messages.
  std::ranges::sort(shares, {}, [](const ir::Share& share) {
    return std::pair(share.period_s, std::string_view(share.name));
  });
  checkShareFit(file, scope);
}

}  // namespace glider::frontend
