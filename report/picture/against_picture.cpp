// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/against_picture.h"

#include "report/picture/colours.h"
#include "report/picture/depth_chart.h"
#include "report/svg/text_lines.h"
#include "report/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::report {
namespace {

using namespace picture;

constexpr double kAgainstLeft = 62, kAgainstMargin = 16, kAgainstTop = 92, kAgainstHigh = 300,
                 kAgainstWide = 940, kAgainstAxisRoom = 62;
constexpr double kText = 17, kStrip = 12, kRow = kText + kStrip + 8;
constexpr size_t kMostText = 110;  ///< of a guard, characters
constexpr const char* kFlicker = "#f3c98b";

/// The colour by which a reader can see why a guard is true: that of a quantity that the mission
/// reads.
PictureStyle usualStyle(const AgainstLogs& against, PictureStyle style) {
  for (const TrackQuantity& quantity : pictureQuantities()) {
    const auto read =
        std::ranges::find(against.sensors, quantity.column, &LoggedSensor::vehicle_name);
    if (!style.colour && read != against.sensors.end() && read->known_ticks > 0) {
      style.colour = quantity.name;
    }
  }
  return style;
}

std::string shortened(std::string text) {
  return columnsOf(text) > kMostText ? text.substr(0, kMostText) + " …" : text;
}

std::string countText(const LoggedCase& one) {
  const size_t count = one.firings.size();
  return count > 0                     ? fmt::format("{} ×", count)
         : one.followed_true_ticks > 0 ? "only after a transition"
         : one.known_ticks > 0         ? "never true"
                                       : "never known";
}

class Page {
 public:
  Page(const AgainstLogs& against, const support::SourceManager& sources, const PictureStyle& style)
      : a_(against),
        sources_(sources),
        colouring_(against.trace, style),
        box_{kAgainstLeft, kAgainstTop,
             kAgainstWide - kAgainstMargin - (colouring_.quantity() ? kScaleRoom : 0),
             kAgainstTop + kAgainstHigh},
        time_(0, std::fmax(against.end.hours * 3600, 1), box_.left, box_.right),
        depth_(valuesOf(against.trace, "m_depth")) {}

  std::string draw() {
    legend_ = stateEntries();
    const auto chart = drawDepthChart(body_, a_.trace, colouring_, box_);
    legend_.insert(legend_.end(), chart.begin(), chart.end());
    if (colouring_.quantity()) {
      drawScale(body_, colouring_, box_);
    }
    transitions();
    double at = box_.bottom + kAgainstAxisRoom - 8;
    for (const LoggedCase& one : a_.cases) {
      strip(one, at);
      at += kRow;
    }
    const double height = at + 12 +
                          drawLegend(body_, legend_, {kAgainstLeft, at + 12},
                                     kAgainstWide - kAgainstLeft - kAgainstMargin);
    return page(height);
  }

 private:
  /// The states in which the mission would have been.
  std::vector<LegendEntry> stateEntries() {
    std::vector<LegendEntry> entries;
    for (size_t i = 0; i < a_.trace.state_names.size(); ++i) {
      const auto states = valuesOf(a_.trace, "state");
      if (std::ranges::find(states, static_cast<double>(i)) != states.end()) {
        entries.push_back({"swatch", std::string(stateColour(static_cast<double>(i))),
                           plain(a_.trace.state_names[i])});
      }
    }
    entries.push_back(
        {"swatch", std::string(kGrey),
         colouring_.quantity() ? "mission not running; colour not known" : "mission not running"});
    return entries;
  }

  void transitions() {
    bool any = false;
    for (const FollowedStep& step : a_.followed) {
      const double depth = depth_.at(step.at.number);
      if (step.kind != FollowedKind::Stay && step.kind != FollowedKind::Start &&
          step.kind != FollowedKind::Gap && std::isfinite(depth)) {
        drawDiamond(body_, {time_.at(step.at.hours * 3600), depthAt(depth)});
        any = true;
      }
    }
    if (any) {
      legend_.push_back({"waypoint", "", "transition of the mission"});
    }
  }

  [[nodiscard]] double depthAt(double depth_m) const {
    return depthAxis(a_.trace, box_).at(depth_m);
  }

  /// A guard with its firings.
  void strip(const LoggedCase& one, double top) {
    const std::string place = one.state.empty() ? "always" : one.state;
    const uint32_t line =
        one.range.valid() ? sources_.place(one.range.file, one.range.begin).line : 0;
    addText(body_, {box_.left, top + kText - 5}, "start", "tick",
            shortened(fmt::format("{}, line {}: {} → {}", place, line, one.guard, one.transition)));
    addText(body_, {box_.right, top + kText - 5}, "end", "tick", countText(one));
    const double strip_top = top + kText;
    body_.add("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#eef1f4\"/>\n",
              px(box_.left), px(strip_top), px(box_.width()), px(kStrip));
    for (const Flicker& flicker : one.flickers) {
      const double left = at(one.firings.at(flicker.first));
      const double right = at(one.firings.at(flicker.first + flicker.count - 1));
      body_.add("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", px(left - 1),
                px(strip_top), px(right - left + 2), px(kStrip), kFlicker);
    }
    if (!one.flickers.empty() && !flicker_told_) {
      legend_.push_back({"swatch", kFlicker,
                         fmt::format("flickers: fires {} times or more within {:.0f} s",
                                     kFlickerFirings, kFlickerSeconds)});
      flicker_told_ = true;
    }
    ticks(one, strip_top);
  }

  void ticks(const LoggedCase& one, double top) {
    std::vector<Line> lines;
    double before = -1;
    for (const LoggedFiring& firing : one.firings) {
      const double x = at(firing);
      if (x - before >= kLeastApart) {
        lines.push_back({{x, top}, {x, top + kStrip}});
        before = x;
      }
    }
    addPath(body_, "frame", lines);
  }

  [[nodiscard]] double at(const LoggedFiring& firing) const {
    return time_.at(firing.at.hours * 3600);
  }

  std::string page(double height) {
    const std::string name = plain(a_.trace.mission);
    SvgText svg;
    beginPage(svg, kAgainstWide, height, "mission " + name + " against " + a_.vehicle);
    addText(svg, {kAgainstLeft, 30}, "start", "title", name + " against " + plain(a_.vehicle));
    addText(svg, {kAgainstLeft, 51}, "start", "muted",
            fmt::format("{} to {} UTC · what the mission would have done; the vehicle did not "
                        "obey it",
                        a_.begin.utc, a_.end.utc));
    svg.add(body_.take());
    svg.add("</svg>\n");
    return svg.take();
  }

  static constexpr double kLeastApart = 0.5;  ///< px, between two ticks

  const AgainstLogs& a_;
  const support::SourceManager& sources_;
  Colouring colouring_;
  Box box_;
  Axis time_;
  std::vector<double> depth_;
  SvgText body_;
  std::vector<LegendEntry> legend_;
  bool flicker_told_ = false;
};

}  // namespace

std::string drawAgainst(const AgainstLogs& against, const support::SourceManager& sources,
                        PictureStyle style) {
  return Page(against, sources, usualStyle(against, std::move(style))).draw();
}

}  // namespace glider::report
