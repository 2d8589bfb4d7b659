// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/page.h"
#include "report/plan/plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace glider::report {
namespace {

using namespace picture;

constexpr double kPictureWidth = 800, kPictureHeight = 560;
constexpr Box kBox{90, 70, kPictureWidth - 40, kPictureHeight - 70};
constexpr int kMostTicks = 8;

/// An axis over the scores of one objective, with some room around them.
class Scale {
 public:
  Scale(const Plan& plan, size_t objective) {
    for (const PlanOption& one : plan.front) {
      const double score = one.scores[objective];
      least_ = &one == plan.front.data() ? score : std::min(least_, score);
      greatest_ = &one == plan.front.data() ? score : std::max(greatest_, score);
    }
    const double span =
        greatest_ > least_ ? greatest_ - least_ : std::max(1.0, std::fabs(greatest_));
    constexpr double kRoom = 0.08;
    least_ -= kRoom * span;
    greatest_ += kRoom * span;
  }
  [[nodiscard]] Axis axis(double from_px, double to_px) const {
    return {least_, greatest_, from_px, to_px};
  }
  [[nodiscard]] double step() const { return niceStep(greatest_ - least_, kMostTicks); }

 private:
  double least_ = 0, greatest_ = 0;
};

std::string titleOf(const PlanObjective& objective) {
  return objective.quantity + (objective.unit.empty() ? "" : " (" + objective.unit + ")");
}

/// The first two objectives in which the options differ; if they do in fewer, the first two.
std::pair<size_t, size_t> axesOf(const Plan& plan) {
  std::vector<size_t> varying;
  for (size_t i = 0; i < plan.objectives.size(); ++i) {
    if (std::ranges::any_of(plan.front, [&](const PlanOption& one) {
          return one.scores[i] != plan.front.front().scores[i];
        })) {
      varying.push_back(i);
    }
  }
  return varying.size() < 2 ? std::pair<size_t, size_t>{0, 1} : std::pair{varying[0], varying[1]};
}

std::string valuesOf(const PlanOption& option) {
  return fmt::format("{}", fmt::join(option.values, ", "));
}

/// The values beside the dots, the chosen one's first; those that would cover another are left out.
void addLabels(SvgText& svg, const Plan& plan, const std::vector<Dot>& dots) {
  constexpr double kBeside = 10, kHigh = 14;
  std::vector<Box> taken;
  for (size_t i = 0; i < dots.size(); ++i) {
    const std::string text = valuesOf(plan.front[i]);
    const bool right = dots[i].x < (kBox.left + kBox.right) / 2;
    const double width = textWidth(text, i == 0 ? kLabelFont : kTickFont);
    const double left = right ? dots[i].x + kBeside : dots[i].x - kBeside - width;
    const Box box{left, dots[i].y - kHigh / 2, left + width, dots[i].y + kHigh / 2};
    const bool covers = std::ranges::any_of(taken, [&](const Box& other) {
      return box.left < other.right && other.left < box.right && box.top < other.bottom &&
             other.top < box.bottom;
    });
    if (!covers) {
      taken.push_back(box);
      addText(svg, {dots[i].x + (right ? kBeside : -kBeside), dots[i].y + 4},
              right ? "start" : "end", i == 0 ? "label halo" : "tick halo", text);
    }
  }
}

}  // namespace

std::string planPicture(const Plan& plan) {
  SvgText svg;
  const std::string title = "What mission " + plan.mission + " could choose";
  beginPage(svg, kPictureWidth, kPictureHeight, title);
  addText(svg, {kBox.left, 30}, "start", "title", title);
  std::vector<std::string> names;
  for (const PlanChoice& choice : plan.choices) {
    names.push_back(choice.name);
  }
  addText(svg, {kBox.left, 52}, "start", "muted",
          fmt::format("beside each: {}; filled: chosen", fmt::join(names, ", ")));
  const auto [first, second] = axesOf(plan);
  const Scale across(plan, first), up(plan, second);
  const Axis x = across.axis(kBox.left, kBox.right), y = up.axis(kBox.bottom, kBox.top);
  addAcross(svg, kBox, x, across.step(), titleOf(plan.objectives[first]));
  addUp(svg, kBox, y, up.step(), titleOf(plan.objectives[second]));
  addFrame(svg, kBox);
  std::vector<Dot> dots;
  for (const PlanOption& one : plan.front) {
    dots.push_back({x.at(one.scores[first]), y.at(one.scores[second])});
  }
  addLabels(svg, plan, dots);
  for (size_t i = dots.size(); i > 0; --i) {  // the chosen one last, above all
    svg.add("<circle class=\"mark\" cx=\"{}\" cy=\"{}\" r=\"5\"{}/>\n", px(dots[i - 1].x),
            px(dots[i - 1].y), i == 1 ? " style=\"fill: #1b2733\"" : "");
  }
  svg.add("</svg>\n");
  return svg.take();
}

}  // namespace glider::report
