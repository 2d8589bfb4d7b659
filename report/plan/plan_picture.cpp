// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/page.h"
#include "report/plan/plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace glider::report {
namespace {

using namespace picture;

constexpr double kPictureWidth = 800, kPictureHeight = 560;
constexpr Box kBox{90, 70, kPictureWidth - 40, kPictureHeight - 70};
constexpr int kMostTicks = 8;
/// With more options only the ends and the chosen one have their values beside them.
constexpr size_t kMostLabels = 12;

/// An axis over the scores of one objective, with some room around them.
class Scale {
 public:
  Scale(const Plan& plan, size_t objective) {
    for (const PlanOption& one : plan.front) {
      const double score = one.scores[objective];
      least_ = &one == plan.front.data() ? score : std::min(least_, score);
      greatest_ = &one == plan.front.data() ? score : std::max(greatest_, score);
    }
    const double span = greatest_ > least_ ? greatest_ - least_ : std::max(1.0, greatest_);
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

std::string valuesOf(const PlanOption& option) {
  return fmt::format("{}", fmt::join(option.values, ", "));
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
  const Scale across(plan, 0), up(plan, 1);
  const Axis x = across.axis(kBox.left, kBox.right), y = up.axis(kBox.bottom, kBox.top);
  addAcross(svg, kBox, x, across.step(), titleOf(plan.objectives[0]));
  addUp(svg, kBox, y, up.step(), titleOf(plan.objectives[1]));
  addFrame(svg, kBox);
  for (size_t i = 0; i < plan.front.size(); ++i) {
    const PlanOption& one = plan.front[i];
    const Dot at{x.at(one.scores[0]), y.at(one.scores[1])};
    svg.add("<circle class=\"mark\" cx=\"{}\" cy=\"{}\" r=\"5\"{}/>\n", px(at.x), px(at.y),
            i == 0 ? " style=\"fill: #1b2733\"" : "");
    if (i == 0 || i + 1 == plan.front.size() || plan.front.size() <= kMostLabels) {
      const bool right = at.x < (kBox.left + kBox.right) / 2;
      addText(svg, {at.x + (right ? 10 : -10), at.y + 4}, right ? "start" : "end",
              i == 0 ? "label halo" : "tick halo", valuesOf(one));
    }
  }
  svg.add("</svg>\n");
  return svg.take();
}

}  // namespace glider::report
