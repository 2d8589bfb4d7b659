// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/brief/brief_of.h"

#include "analysis/brief/in_words.h"
#include "analysis/brief/summary.h"
#include "analysis/brief/written.h"
#include "analysis/graph_of.h"
#include "codegen/digest.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/abstract/surfacing.h"
#include "ir/verify/value_text.h"
#include "support/diagnostics/ids/verification.h"
#include "support/one_line.h"
#include "support/units/duration_text.h"
#include "support/units/units.h"
#include "support/utc.h"
#include "vehicles/vehicle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace glider::analysis {
namespace {

using report::Brief;
using support::SourceRange;

/// As ir::withUnit, but an angle in degrees.
std::string forPeople(double value, ir::Type type) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  std::string text = ir::withUnit(value, type);
  return text.ends_with(" rad") ? fmt::format("{:.4g} deg", value * kDegrees) : text;
}

/// Puts a checked mission into the parts of report::Brief. Depths and climbs are those of the
/// environment model without what the mission assumes, so that the page is on the safe side.
class BriefMaker {
 public:
  explicit BriefMaker(const BriefSource& source)
      : from_(source),
        checked_(*source.compilation.checked),
        m_(checked_.mission()),
        written_(source.compilation),
        words_(*checked_.lowered, loopsOf(source.compilation.parsed.get())),
        depths_(ir::prove::deepestByState(ir::prove::ProofContext(checked_.worlds.widest))),
        climbs_(ir::prove::climbTimes(ir::prove::ProofContext(checked_.worlds.widest))) {}

  Brief run() {
    Brief brief;
    head(brief);
    structure(brief);
    names(brief);
    findings(brief);
    brief.budgets = from_.found.budgets;
    brief.assumptions = assumptionsOf(checked_.worlds.widest.platform, m_);
    hashes(brief);
    return brief;
  }

 private:
  void head(Brief& brief) const {
    brief.mission = m_.name;
    brief.file = from_.found.path;
    brief.platform = checked_.platform().name;
    brief.platform_description = checked_.platform().description;
    brief.version = from_.version;
    brief.cycle_s = checked_.platform().envelope.cycle_s;
    brief.comment = written_.head();
    brief.summary = summaryOf(checked_, from_.found, from_.own, std::ranges::max(depths_));
  }

  void structure(Brief& brief) const {
    brief.graph = graphOf(*checked_.lowered, checked_.facts.deepest_path, from_.proved.never_fire);
    brief.always = events(m_.always, brief.graph.always);
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      brief.states.push_back(state(i, brief.graph.states[i]));
    }
  }

  [[nodiscard]] std::vector<report::BriefEvent> events(
      const std::vector<ir::Case>& cases, const std::vector<report::GraphCase>& drawn) const {
    std::vector<report::BriefEvent> all;
    for (size_t i = 0; i < drawn.size(); ++i) {
      all.push_back(words_.event(cases[i], drawn[i].never));
    }
    return all;
  }

  [[nodiscard]] report::BriefState state(uint32_t number, const report::GraphState& drawn) const {
    const ir::State& of = m_.states[number];
    report::BriefState told;
    told.name = of.name;
    told.parameters = drawn.parameters;
    told.comment = written_.commentOf(of.name);
    told.profile = use(of, of.profile, ir::BehaviourKind::Profile, drawn.profile);
    told.route = use(of, of.route, ir::BehaviourKind::Route, drawn.route);
    told.deepest =
        std::isfinite(depths_[number])
            ? fmt::format(
                  "at most {:.4g} m deep{}", depths_[number],
                  std::isfinite(climbs_[number]) ? " as its climb to the surface begins" : "")
            : "";
    told.samples = InWords::samples(of);
    told.instruments = InWords::instruments(of);
    told.entry = words_.block(of.entry);
    told.events = events(of.cases, drawn.cases);
    told.unreached = !drawn.reached;
    return told;
  }

  [[nodiscard]] report::BriefUse use(const ir::State& state, const ir::Activity& activity,
                                     ir::BehaviourKind kind, const std::string& drawn) const {
    report::BriefUse told = written_.use(state.name, kind, m_[activity.behaviour].name);
    if (told.with.empty()) {
      told.name = drawn;  // all that is known of it
    }
    return told;
  }

  void names(Brief& brief) const {
    for (const ParameterRow& row : from_.parameters) {
      brief.parameters.push_back({row.name, row.type, row.initial, row.range, row.set_to, ""});
    }
    written_.describe(brief.parameters);
    brief.conditions = written_.conditions();
    brief.values = written_.values();
    for (const ir::Sensor& sensor : m_.sensors) {
      brief.sensors.push_back(sensorOf(sensor));
    }
  }

  /// As people call it; by the platform file if the family is not known.
  [[nodiscard]] std::string computerOf(const platforms::PlatformSensor& sensor) const {
    const bool science = sensor.computer == platforms::Computer::Science;
    if (const vehicles::Vehicle* vehicle = vehicles::vehicleOf(checked_.platform())) {
      return std::string(science ? vehicle->science_computer : vehicle->flight_computer);
    }
    return science ? "science computer" : "flight computer";
  }

  [[nodiscard]] report::BriefSensor sensorOf(const ir::Sensor& sensor) const {
    const platforms::PlatformSensor* row = checked_.platform().find(sensor.vehicle_name);
    const bool own = !sensor.symbol.empty();
    if (sensor.isHeard()) {
      return {sensor.name,      "",
              "acoustic modem", "what another vehicle of the fleet tells",
              rangeOf(sensor),  support::durationText(sensor.stale_after_s)};
    }
    report::BriefSensor told{
        sensor.name,
        own ? "" : sensor.vehicle_name,
        own || row == nullptr ? "payload computer, code in C" : computerOf(*row),
        row == nullptr ? "" : row->what,
        rangeOf(sensor),
        support::durationText(sensor.stale_after_s)};
    return told;
  }

  /// Whether it is a time since 1970.
  [[nodiscard]] bool isClock(const ir::Sensor& sensor) const {
    const platforms::PlatformSensor* row = checked_.platform().find(sensor.vehicle_name);
    return row != nullptr && row->unit == "timestamp";
  }

  /// In SI units.
  [[nodiscard]] std::string rangeOf(const ir::Sensor& sensor) const {
    if (!std::isfinite(sensor.lowest) || !std::isfinite(sensor.highest)) {
      return "";
    }
    const double factor = sensor.encoding == ir::Encoding::DegreesMinutes ? 0.01 : sensor.to_si;
    const auto shown = [&](double value) {
      const double si = value * factor;
      if (isClock(sensor)) {
        return support::instantText(si);
      }
      const bool time = sensor.type.kind == ir::TypeKind::Quantity &&
                        sensor.type.dimension == support::dimension::time;
      return time ? support::durationText(si) : forPeople(si, sensor.type);
    };
    return fmt::format("{} to {}", shown(sensor.lowest), shown(sensor.highest));
  }

  void findings(Brief& brief) const {
    for (const report::JudgedRequirement& one : from_.found.requirements) {
      brief.requirements.push_back(requirement(one));
    }
    for (const support::Diagnostic& one : from_.found.diagnostics) {
      if (one.severity == support::Severity::Warning) {
        std::string text = fmt::format("{} [{}]", one.message, support::code(one.id));
        brief.warnings.push_back({placeOf(one.range), std::move(text)});
      }
    }
    for (const report::Remark& remark : from_.found.remarks) {
      if (remark.subject == report::Remark::Subject::Other) {
        brief.remarks.push_back({placeOf(remark.range), remark.text});
      }
    }
  }

  [[nodiscard]] report::BriefRequirement requirement(const report::JudgedRequirement& one) const {
    report::BriefRequirement told{support::onOneLine(one.text), one.verdict, {}};
    for (const support::Diagnostic& found : from_.found.diagnostics) {
      if (found.id == support::diagnostics::requirementBroken && found.range == one.range) {
        told.because.push_back(found.message);
        for (const support::DiagnosticNote& note : found.notes) {
          told.because.push_back(note.message);
        }
      }
    }
    told.because.push_back(one.premise);
    told.because.push_back(one.verdict == "undecided" ? one.reason : "");
    told.because.push_back(one.closed_loop ? report::searchInWords(*one.closed_loop) : "");
    std::erase(told.because, "");
    return told;
  }

  [[nodiscard]] std::string placeOf(SourceRange range) const {
    if (!range.valid()) {
      return "";
    }
    const uint32_t line = checked_.sources().place(range.file, range.begin).line;
    return range.file == written_.files().front()
               ? fmt::format("line {}", line)
               : fmt::format("{}, line {}", checked_.sources().name(range.file), line);
  }

  void hashes(Brief& brief) const {
    for (const uint32_t file : written_.files()) {
      const bool standard = checked_.lowered->inStandardLibrary(file);
      const std::string name = standard ? "the standard library" : checked_.sources().name(file);
      brief.hashes.push_back({name, codegen::digestOf(checked_.sources().text(file)), ""});
    }
    brief.hashes.push_back(from_.binary);
  }

  const BriefSource& from_;
  const compiler::Checked& checked_;
  const ir::Mission& m_;
  const Written written_;
  const InWords words_;
  const std::vector<double> depths_;
  const std::vector<double> climbs_;  ///< finite for a state that only climbs to the surface
};

}  // namespace

report::Brief briefOf(const BriefSource& source) {
  return BriefMaker(source).run();
}

}  // namespace glider::analysis
