// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/states/lower_sample.h"

#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/states/instrument_words.h"
#include "frontend/sema/states/never_true.h"
#include "frontend/spelling.h"
#include "hooks/protocol/sampling.h"
#include "ir/core/mission_writer.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/listed.h"
#include "support/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace glider::frontend {
namespace {

const ir::Type kCodeType{ir::TypeKind::Quantity, {}};
const ir::Type kPeriodType = quantity(support::dimension::time);

/// "`every 10 min`"
std::string everyText(double seconds) {
  constexpr int kMinute = 60;
  constexpr int kHour = 3600;
  const int whole = static_cast<int>(seconds);
  if (whole % kHour == 0 && whole > 0) {
    return fmt::format("`every {} h`", whole / kHour);
  }
  return whole % kMinute == 0 && whole > kMinute ? fmt::format("`every {} min`", whole / kMinute)
                                                 : fmt::format("`every {} s`", whole);
}

/// What to write for a time that no code has, of which `code` has the longest one below.
std::string whatToWrite(uint32_t code) {
  const std::string below = everyText(hookSamplingSecs(code));
  return code + 1 < kHookSamplingCodes ? fmt::format("write {}, or the next longer one: {}", below,
                                                     everyText(hookSamplingSecs(code + 1)))
                                       : fmt::format("write {}: nothing is longer", below);
}

class SampleLowering {
 public:
  explicit SampleLowering(Scope& scope) : scope_(scope) {}

  std::vector<ir::Sampling> run(const ast::SampleMember& node,
                                const support::SourceRange& keyword) {
    if (instruments().empty()) {
      scope_.report(support::diagnostics::noInstruments, keyword, scope_.platform().name);
      return {};
    }
    if (std::ranges::all_of(node.items, [&](const ast::SampleItem& item) {
          return isOnlyLogged(item.instrument.text);
        })) {
      const ast::Name& first = node.items.front().instrument;
      scope_
          .report(support::diagnostics::unknownInstrument, first.where, first.text,
                  fmt::format("`sensors` says what is logged; `sample` switches {}",
                              instrumentsOf(scope_.platform())))
          .fix(keyword, "sensors");
      return {};
    }
    std::vector<ir::Sampling> list;
    for (const ast::SampleItem& item : node.items) {
      if (auto one = lowerItem(item)) {
        list.push_back(*std::move(one));
      }
    }
    std::ranges::sort(list, {}, &ir::Sampling::place);
    return list;
  }

 private:
  [[nodiscard]] const std::vector<platforms::Instrument>& instruments() const {
    return scope_.platform().instruments;
  }

  std::optional<ir::Sampling> lowerItem(const ast::SampleItem& item) {
    const platforms::Instrument* instrument = find(item);
    const auto reads = item.off ? std::optional<ir::Sampling>(off()) : period(item, instrument);
    std::optional<ir::ExprId> when;
    if (item.when) {
      when = ExprLowering(scope_).lowerCondition(*item.when);
    }
    if (instrument == nullptr || !reads || (item.when && !when)) {
      return std::nullopt;
    }
    ir::Sampling one = *reads;
    one.instrument = instrument->name;
    one.words = support::onOneLine(scope_.text(item.how));
    one.place = static_cast<uint32_t>(instrument - instruments().data());
    if (when) {
      warnOfNever(item, *when);
      ir::MissionWriter writer(scope_.mission, item.when->where);
      const uint32_t otherwise = item.off ? kHookSamplingOfVehicle : kHookSamplingOff;
      const ir::ExprId reading = item.off ? code(writer, otherwise) : one.code;
      one.code = certainly(
          writer,
          writer.operation(ir::Op::Select, kCodeType, {*when, one.code, code(writer, otherwise)}),
          reading);
    }
    return one;
  }

  /// `on climbs on dives`, `above 10 m below 30 m`: both are asked for at once.
  void warnOfNever(const ast::SampleItem& item, ir::ExprId when) {
    const auto never = neverTrueFor(scope_.mission, when);
    if (!never) {
      return;
    }
    const ir::Sensor& sensor = scope_.mission[*never];
    const bool depth = sensor.type == quantity(support::dimension::length);
    scope_.report(support::diagnostics::neverSampled, item.how, item.instrument.text,
                  item.off ? "is never off" : "never reads",
                  depth
                      ? "`below` is deeper than, `above` is shallower than: between 10 m and 30 m "
                        "is `below 10 m above 30 m`"
                      : "name one of them; without `on …` it is both on climbs and on dives");
  }

  /// An instrument reads while it is not known whether it is meant to.
  static ir::ExprId certainly(ir::MissionWriter& writer, ir::ExprId number, ir::ExprId otherwise) {
    const ir::ExprId known = writer.operation(ir::Op::Known, {ir::TypeKind::Bool, {}}, {number});
    return writer.operation(ir::Op::Select, kCodeType, {known, number, otherwise});
  }

  /// Null, and reported, for what is none, or has been there.
  const platforms::Instrument* find(const ast::SampleItem& item) {
    const ast::Name& name = item.instrument;
    const auto found = std::ranges::find(instruments(), name.text, &platforms::Instrument::name);
    if (found == instruments().end()) {
      reportUnknown(item);
      return nullptr;
    }
    const auto [place, fresh] = named_.emplace(name.text, &name);
    if (!fresh) {
      scope_.report(support::diagnostics::instrumentTwice, name.where, name.text)
          .note(place->second->where, "the first is here");
    }
    return fresh ? &*found : nullptr;
  }

  /// A sensor or a clock, but nothing that an instrument measures.
  bool isOnlyLogged(const std::string& name) {
    const platforms::PlatformSensor* sensor = scope_.findSensor(name);
    return findClock(name).has_value() ||
           (sensor != nullptr && measuring(instruments(), sensor->name) == nullptr);
  }

  void reportUnknown(const ast::SampleItem& item) {
    const ast::Name& name = item.instrument;
    const platforms::PlatformSensor* sensor = scope_.findSensor(name.text);
    if (const platforms::Instrument* one =
            sensor == nullptr ? nullptr : measuring(instruments(), sensor->name)) {
      scope_
          .report(support::diagnostics::unknownInstrument, name.where, name.text,
                  fmt::format("`{}` is what the instrument `{}` measures", name.text, one->name))
          .fix(name.where, one->name);
      return;
    }
    if (isOnlyLogged(name.text)) {
      scope_.report(support::diagnostics::unknownInstrument, name.where, name.text,
                    fmt::format("`sensors {}` logs it; missions can switch {}", name.text,
                                instrumentsOf(scope_.platform())));
      return;
    }
    scope_.reportUnknown(support::diagnostics::unknownInstrument, name.where,
                         insteadOfInstrument(name.text, support::onOneLine(scope_.text(item.how)),
                                             scope_.platform()),
                         name.text);
  }

  ir::Sampling off() {
    ir::MissionWriter writer(scope_.mission);
    return {"", "", 0, code(writer, kHookSamplingOff), {}};
  }

  static ir::ExprId code(ir::MissionWriter& writer, uint32_t number) {
    return writer.number(number, kCodeType);
  }

  /// How often it reads. `instrument` may be null.
  std::optional<ir::Sampling> period(const ast::SampleItem& item,
                                     const platforms::Instrument* instrument) {
    ir::MissionWriter writer(scope_.mission, item.instrument.where);
    if (!item.every) {
      return ir::Sampling{"", "", 0, code(writer, kHookSamplingFastest), {}};
    }
    const size_t before = scope_.mission.exprs.size();
    const auto value =
        ExprLowering(scope_).lowerAs(*item.every, kPeriodType, "the time of `every`");
    if (!value || instrument == nullptr) {
      return std::nullopt;
    }
    const auto constant = evaluate(scope_.mission, *value);
    if (!constant) {
      return changing(writer, *value, *instrument);
    }
    scope_.mission.exprs.resize(before);
    return constantPeriod(writer, *constant, *item.every, *instrument);
  }

  std::optional<ir::Sampling> constantPeriod(ir::MissionWriter& writer, double seconds,
                                             const ast::Expr& written,
                                             const platforms::Instrument& instrument) {
    if (!(seconds > 0) || seconds < instrument.shortest_s) {
      scope_.report(
          support::diagnostics::samplePeriod, written.where, instrument.name, seconds,
          fmt::format("it needs {:g} s for a reading: write {} or a longer time",
                      instrument.shortest_s, everyText(std::max(1.0, instrument.shortest_s))));
      return std::nullopt;
    }
    const uint32_t number = hookSamplingCode(seconds);
    if (hookSamplingSecs(number) != seconds) {
      scope_.report(support::diagnostics::sampledFaster, written.where, instrument.name, seconds,
                    hookSamplingSecs(number), whatToWrite(number));
    }
    return ir::Sampling{"", "", 0, code(writer, number), {}};
  }

  /// The code of the longest period that is not above a time which is known in flight only.
  static ir::Sampling changing(ir::MissionWriter& writer, ir::ExprId seconds,
                               const platforms::Instrument& instrument) {
    const ir::ExprId at_least = writer.operation(
        ir::Op::Max, kPeriodType, {seconds, writer.number(instrument.shortest_s, kPeriodType)});
    ir::ExprId sum = code(writer, kHookSamplingFastest);
    for (uint32_t next = kHookSamplingFastest + 1; next < kHookSamplingCodes; ++next) {
      const ir::ExprId reached =
          writer.operation(ir::Op::GreaterEqual, {ir::TypeKind::Bool, {}},
                           {at_least, writer.number(hookSamplingSecs(next), kPeriodType)});
      const ir::ExprId one =
          writer.operation(ir::Op::Select, kCodeType,
                           {reached, writer.number(1, kCodeType), writer.number(0, kCodeType)});
      sum = writer.operation(ir::Op::Add, kCodeType, {sum, one});
    }
    return {"", "", 0, certainly(writer, sum, code(writer, kHookSamplingFastest)), at_least};
  }

  Scope& scope_;
  std::map<std::string, const ast::Name*> named_;
};

}  // namespace

std::vector<ir::Sampling> lowerSample(const ast::SampleMember& node,
                                      const support::SourceRange& keyword, Scope& scope) {
  return SampleLowering(scope).run(node, keyword);
}

}  // namespace glider::frontend
