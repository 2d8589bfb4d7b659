// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/depth_chart.h"

#include "report/figures.h"
#include "report/picture/colours.h"
#include "report/picture/contours.h"
#include "report/svg/text_lines.h"

#include <algorithm>
#include <cmath>

namespace glider::report::picture {
namespace {

using support::Trace;

/// The greatest depth that the chart shows: a little more than the flight's, and the seabed if it
/// is near.
double deepestShown(const std::vector<double>& depth, const std::vector<double>& seabed) {
  const Extent flown = extentOf(depth), ground = extentOf(seabed);
  const double deepest = std::fmax(flown.greatest > 0 ? flown.greatest : 0, 1);
  const bool near = ground.least < 1.5 * deepest;
  return 1.06 * (near ? std::fmin(std::fmax(deepest, ground.greatest), 1.3 * deepest) : deepest);
}

std::vector<double> depthsOf(const Trace& trace) {
  return valuesOf(trace, trace.column("m_depth") >= 0 ? "m_depth" : "true_depth");
}

std::vector<Line> downsampled(std::vector<Line> lines) {
  for (Line& line : lines) {
    line = simplified(line, kUnseen);
  }
  return lines;
}

class Chart {
 public:
  Chart(SvgText& svg, const Trace& trace, const Colouring& colouring, const Box& box)
      : svg_(svg),
        trace_(trace),
        colouring_(colouring),
        box_(box),
        time_(valuesOf(trace, "time")),
        depth_(depthsOf(trace)),
        seabed_(valuesOf(trace, "water_depth")),
        deepest_(deepestShown(depth_, seabed_)),
        y_(depthAxis(trace, box)) {
    const Extent times = extentOf(time_);
    first_ = times.least >= 0 ? times.least : 0;
    last_ = times.greatest > first_ ? times.greatest : first_ + 1;
  }

  std::vector<LegendEntry> draw() {
    svg_.add(
        "<clipPath id=\"chart\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n",
        px(box_.left), px(box_.top), px(box_.width()), px(box_.height()));
    axes();
    svg_.add("<g clip-path=\"url(#chart)\">\n");
    isotherms();
    ground();
    changes();
    range();
    track();
    marked();
    beside();
    svg_.add("</g>\n");
    addFrame(svg_, box_);
    band();
    return std::move(legend_);
  }

 private:
  [[nodiscard]] Dot at(double time_s, double depth_m) const {
    return {box_.left + (time_s - first_) / (last_ - first_) * box_.width(), y_.at(depth_m)};
  }

  void axes() {
    constexpr double kMinute = 60, kHour = 3600, kInMinutes = 100 * kMinute;
    const bool minutes = last_ - first_ <= kInMinutes;
    const double unit = minutes ? kMinute : kHour;
    const Axis time(first_ / unit, last_ / unit, box_.left, box_.right);
    addAcross(svg_, box_, time, niceStep((last_ - first_) / unit, box_.width() > 600 ? 10 : 7),
              minutes ? "time (min)" : "time (h)");
    addUp(svg_, box_, y_, niceStep(deepest_, 7), "depth (m)");
  }

  /// The parts of `values` that are known, over time.
  [[nodiscard]] std::vector<Line> linesOf(const std::vector<double>& values) const {
    std::vector<Line> lines(1);
    for (size_t row = 0; row < values.size(); ++row) {
      if (std::isfinite(values[row]) && std::isfinite(time_[row])) {
        lines.back().push_back(at(time_[row], values[row]));
      } else if (!lines.back().empty()) {
        lines.emplace_back();
      }
    }
    return downsampled(std::move(lines));
  }

  void isotherms() {
    std::vector<double> water = trace_.field.values;
    const Extent range = extentOf(water);
    if (!(range.greatest - range.least > 0.5)) {
      return;
    }
    const double step = niceStep(range.greatest - range.least, 4);
    std::string levels;
    std::vector<Line> lines;
    for (const double level : ticks(range.least, range.greatest, step)) {
      for (const Line& contour : contours(trace_.field, level)) {
        Line& line = lines.emplace_back();
        for (const Dot& dot : contour) {
          line.push_back(at(dot.x, dot.y));
        }
        line = simplified(line, kUnseen);
      }
      levels += (levels.empty() ? "" : ", ") + tickText(level, step);
    }
    addPath(svg_, "isotherm", lines);
    if (!lines.empty()) {
      legend_.push_back({"isotherm", "", "isotherms " + levels + " °C"});
    }
  }

  void ground() {
    if (!(extentOf(seabed_).least < deepest_)) {
      return;
    }
    std::vector<Line> areas = linesOf(seabed_);
    for (Line& area : areas) {
      if (area.size() > 1) {
        area.push_back({area.back().x, box_.bottom + 2});
        area.push_back({area.front().x, box_.bottom + 2});
      }
    }
    addPath(svg_, "seabed", areas);
    legend_.push_back({"seabed", "#d9cdbd", "seabed"});
  }

  void changes() {
    constexpr size_t kMost = 40;  // more lines would look like hatching
    const auto spans = spansOf(trace_);
    std::vector<Line> lines;
    for (size_t i = 1; i < spans.size() && spans.size() <= kMost; ++i) {
      const double x = at(time_[spans[i].begin], 0).x;
      lines.push_back({{x, box_.top}, {x, box_.bottom}});
    }
    addPath(svg_, "change", lines);
  }

  /// The depths between which a yo is commanded, where they change: constant depths can be seen
  /// from the track.
  void range() {
    std::vector<Line> lines;
    for (const char* name : {"commanded_top", "commanded_bottom"}) {
      const auto values = valuesOf(trace_, name);
      const Extent extent = extentOf(values);
      if (extent.greatest - extent.least >= kYoDepth) {
        const auto more = steps(values);
        lines.insert(lines.end(), more.begin(), more.end());
      }
    }
    addPath(svg_, "commanded", lines);
    if (!lines.empty()) {
      legend_.push_back({"commanded", "", "commanded range"});
    }
  }

  [[nodiscard]] std::vector<Line> steps(const std::vector<double>& values) const {
    std::vector<Line> lines(1);
    for (size_t row = 0; row < values.size(); ++row) {
      if (!std::isfinite(values[row])) {
        lines.emplace_back();
        continue;
      }
      const Dot here = at(time_[row], values[row]);
      if (!lines.back().empty()) {
        lines.back().push_back({here.x, lines.back().back().y});
      }
      lines.back().push_back(here);
    }
    return downsampled(std::move(lines));
  }

  void marked() {
    const auto values = valuesOf(trace_, "isotherm_depth");
    if (extentOf(values).least >= 0) {
      const auto lines = linesOf(values);
      addPath(svg_, "around", lines);
      addPath(svg_, "marked", lines);
      legend_.push_back({"marked", "", "marked isotherm"});
    }
  }

  /// The simulated flight of the same mission.
  void beside() {
    const auto lines = linesOf(valuesOf(trace_, "sim_depth"));
    if (isKnown(trace_, "sim_depth")) {
      svg_.add(
          "<style>.beside { stroke: #b3206b; stroke-width: 1.2; stroke-dasharray: 6 3 }</style>\n");
      addPath(svg_, "beside", lines);
      legend_.push_back({"beside", "", "simulated flight"});
    }
  }

  /// All pieces of one colour are one path.
  void track() {
    ColouredLines by_colour;
    for (const Piece& piece : colouring_.pieces()) {
      std::vector<Line>& lines = by_colour[piece.colour];
      Line line;
      for (size_t row = piece.begin; row <= piece.end; ++row) {
        if (std::isfinite(depth_[row])) {
          line.push_back(at(time_[row], depth_[row]));
        } else if (trace_.log && !line.empty()) {  // nothing was logged for long
          lines.push_back(simplified(line, kUnseen));
          line.clear();
        }
      }
      lines.push_back(simplified(line, kUnseen));
    }
    addPaths(svg_, "track", by_colour);
  }

  void band() {
    if (!hasPilots(trace_)) {
      return;
    }
    const double top = box_.top - kBand, high = kBand - 7;
    for (const Span& span : spansOf(trace_)) {
      const double left = at(time_[span.begin], 0).x, right = at(time_[span.end], 0).x;
      const std::string_view colour = pilotColour(span.pilot);
      const std::string name = pilotName(trace_, span.pilot);
      svg_.add(
          "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
          "fill=\"{}\"><title>{}</title></rect>\n",
          px(left), px(top), px(std::fmax(right - left, 0.5)), px(high), colour, toXml(name));
      if (textWidth(name, kTickFont) + 8 < right - left) {
        svg_.add(
            "<text class=\"tick\" x=\"{}\" y=\"{}\" text-anchor=\"middle\" "
            "style=\"fill:{}\">{}</text>\n",
            px((left + right) / 2), px(top + high - 5.5), inkOn(colour), toXml(name));
      }
    }
  }

  SvgText& svg_;
  const Trace& trace_;
  const Colouring& colouring_;
  Box box_;
  std::vector<double> time_, depth_, seabed_;
  double deepest_;
  Axis y_;
  double first_ = 0, last_ = 1;
  std::vector<LegendEntry> legend_;
};

}  // namespace

Axis depthAxis(const Trace& trace, const Box& box) {
  return {deepestShown(depthsOf(trace), valuesOf(trace, "water_depth")), 0, box.bottom, box.top};
}

std::vector<LegendEntry> drawDepthChart(SvgText& svg, const Trace& trace,
                                        const Colouring& colouring, const Box& box) {
  return Chart(svg, trace, colouring, box).draw();
}

void drawScale(SvgText& svg, const Colouring& colouring, const Box& box) {
  constexpr double kGap = 14, kWide = 13;
  const double left = box.right + kGap, high = box.height() / Colouring::kSteps;
  for (size_t i = 0; i < Colouring::kSteps; ++i) {
    svg.add("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", px(left),
            px(box.bottom - high * static_cast<double>(i + 1)), px(kWide), px(high + 0.3),
            scaleColour(i, Colouring::kSteps));
  }
  const Extent extent = colouring.extent();
  const Axis axis(extent.least, extent.greatest, box.bottom, box.top);
  const double step = niceStep(extent.greatest - extent.least, 6);
  double widest = 0;
  for (const double value : ticks(extent.least, extent.greatest, step)) {
    const std::string text = tickText(value, step);
    addText(svg, {left + kWide + 6, axis.at(value) + 4}, "start", "tick", text);
    widest = std::fmax(widest, textWidth(text, kTickFont));
  }
  addUpwards(svg, {left + kWide + 6 + widest + 14, (box.top + box.bottom) / 2}, "label",
             colouring.quantity()->title);
}

}  // namespace glider::report::picture
