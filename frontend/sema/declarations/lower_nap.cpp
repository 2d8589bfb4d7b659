// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/lower_nap.h"

#include "frontend/sema/declarations/declared_value.h"
#include "frontend/sema/declarations/only_item.h"
#include "hooks/protocol/nap_times.h"
#include "platforms/load/dictionary.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/units/duration_text.h"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace glider::frontend {
namespace {

using support::durationText;

/// Less gains nothing: waking alone may take a third of it.
constexpr double kShortest_s = 30;
constexpr double kLongest_s = 3600;
/// A mission that lost its power at the end of a nap must still be in time to continue: the newest
/// checkpoint is up to 20 s older than the nap, and the SBC has to boot.
constexpr double kToResume_s = 60;

/// Whether the vehicle keeps what happens while the SBC sleeps: then it reports for how long.
bool keepsForNaps(const platforms::Platform& platform) {
  const platforms::Dictionary dictionary(platform);
  return dictionary.get().roles[kGliderRoleHookNapSecs] != GLIDER_NO_SENSOR;
}

/// A number without a unit: what it counts is not said.
bool isBare(const ast::Expr& expr) {
  const auto* literal = std::get_if<ast::Literal>(&expr.node);
  return literal != nullptr && literal->unit.empty();
}

/// Reads the time of the line.
class NapReader {
 public:
  /// `resumption`: the mission's own; may be null.
  NapReader(const ast::Nap& node, const ast::Resumption* resumption, Scope& scope)
      : node_(node), resumption_(resumption), scope_(scope) {}

  /// Empty, and reported, if it is not one that the mission may have.
  std::optional<double> read() {
    if (isBare(node_.longest)) {
      refuse("it has no unit", "write a unit, as in " + withUnit());
      return std::nullopt;
    }
    const DeclaredType time{quantity(support::dimension::time)};
    const ast::Name role{"nap at most", node_.where};
    const auto known =
        DeclaredValue(role, time, scope_).constant(node_.longest, "the time of `nap at most`");
    return known && isPossible(known->first) ? std::optional(known->first) : std::nullopt;
  }

 private:
  /// The line with a unit that it can have: minutes, or seconds if that would be too long.
  std::string withUnit() {
    constexpr double kMinute_s = 60;
    const std::string& digits = std::get<ast::Literal>(node_.longest.node).digits;
    const double number = std::strtod(digits.c_str(), nullptr);
    const bool minutes = number * kMinute_s <= kLongest_s;
    const double seconds = minutes ? number * kMinute_s : number;
    if (seconds < kShortest_s || seconds > kLongest_s) {
      return fmt::format("`nap at most {}`", durationText(kLongest_s));
    }
    const double resume_s = seconds + kToResume_s;
    return fmt::format("`nap at most {} {}`", digits, minutes ? "min" : "s") +
           (resume_s > scope_.mission.resume_within_s
                ? fmt::format(" with `resume within {}`", durationText(resume_s))
                : "");
  }

  bool isPossible(double seconds) {
    if (!(seconds >= kShortest_s)) {
      refuse(fmt::format("waking takes up to {}, so that less than {} gains nothing",
                         durationText(kHookMostWakeSecs), durationText(kShortest_s)),
             fmt::format("write `nap at most {}` or a longer time, or delete the line",
                         durationText(kShortest_s)));
    } else if (seconds > kLongest_s) {
      refuse(fmt::format("the longest is {}", durationText(kLongest_s)),
             fmt::format("write `nap at most {}` or a shorter time", durationText(kLongest_s)));
    } else {
      return mayResume(seconds);
    }
    return false;
  }

  bool mayResume(double seconds) {
    const double within = scope_.mission.resume_within_s;
    const double allowed = within - kToResume_s;
    if (seconds <= allowed) {
      return true;
    }
    auto report = scope_.report(support::diagnostics::napBeyondResume, node_.longest.where,
                                scope_.text(node_.longest.where), durationText(within),
                                durationText(kToResume_s), durationText(seconds + kToResume_s));
    if (resumption_ != nullptr) {
      report.note(resumption_->where, "that is here");
    } else {
      report.note({}, "that is so without a line `resume within`");
    }
    if (allowed >= kShortest_s) {
      report.hint(fmt::format("write `resume within {}` or longer, or `nap at most {}`",
                              durationText(seconds + kToResume_s), durationText(allowed)));
    }
    return false;
  }

  void refuse(const std::string& why, const std::string& change) {
    scope_.report(support::diagnostics::napTime, node_.longest.where,
                  scope_.text(node_.longest.where), why, change);
  }

  const ast::Nap& node_;
  const ast::Resumption* resumption_;
  Scope& scope_;
};

}  // namespace

void lowerNap(const ast::File& file, Scope& scope) {
  const auto* line = onlyItem<ast::Nap>(file, [&](const auto& again, const auto&) {
    scope.report(support::diagnostics::memberTwice, again.where, "a mission", "nap");
  });
  if (line == nullptr) {
    return;
  }
  if (!keepsForNaps(scope.platform())) {
    scope.report(support::diagnostics::cannotNap, line->where, scope.platform().name);
    return;
  }
  const auto* resumption = onlyItem<ast::Resumption>(file, [](const auto&, const auto&) {});
  scope.mission.nap_s = NapReader(*line, resumption, scope).read();
}

}  // namespace glider::frontend
