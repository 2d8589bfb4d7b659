// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The layout of a graph: nothing covers anything, in any graph.

#include "report/graph/layered.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace glider::report::layered {
namespace {

struct Box {
  Point middle;
  Size size;
};

struct Case {
  std::vector<Node> nodes;
  std::vector<Edge> edges;
};

/// A graph of up to 12 nodes with cycles, edges beside each other and parts that nothing joins.
Case randomCase(std::mt19937& random) {
  auto upTo = [&](uint32_t most) { return static_cast<uint32_t>(random() % (most + 1)); };
  Case made;
  const uint32_t count = 1 + upTo(11);
  for (uint32_t i = 0; i < count; ++i) {
    const double before = upTo(3) == 0 ? upTo(40) : 0;
    made.nodes.push_back({{20.0 + upTo(200), 20.0 + before + upTo(120)}, before});
  }
  for (uint32_t i = upTo(2 * count); i > 0 && count > 1; --i) {
    const uint32_t from = upTo(count - 1);
    const uint32_t to = (from + 1 + upTo(count - 2)) % count;
    made.edges.push_back({from, to, {10.0 + upTo(150), 10.0 + upTo(60)}, 0});
  }
  return made;
}

bool overlap(const Box& a, const Box& b) {
  return std::abs(a.middle.along - b.middle.along) < (a.size.along + b.size.along) / 2 - 1e-6 &&
         std::abs(a.middle.across - b.middle.across) < (a.size.across + b.size.across) / 2 - 1e-6;
}

std::vector<Box> boxesOf(const Case& of, const Drawing& drawing) {
  std::vector<Box> boxes;
  for (size_t i = 0; i < of.nodes.size(); ++i) {
    boxes.push_back({drawing.nodes[i], of.nodes[i].size});
  }
  for (size_t i = 0; i < of.edges.size(); ++i) {
    boxes.push_back({drawing.edges[i].label, of.edges[i].label});
  }
  return boxes;
}

void expectInside(const Box& box, Size size) {
  EXPECT_GE(box.middle.along - box.size.along / 2, -1e-6);
  EXPECT_LE(box.middle.along + box.size.along / 2, size.along + 1e-6);
  EXPECT_GE(box.middle.across - box.size.across / 2, -1e-6);
  EXPECT_LE(box.middle.across + box.size.across / 2, size.across + 1e-6);
}

TEST(GraphLayout, NothingCoversAnythingAndTheSheetFits) {
  std::mt19937 random(7);
  for (int round = 0; round < 500; ++round) {
    const Case made = randomCase(random);
    const Drawing drawing = layOut(made.nodes, made.edges);
    const std::vector<Box> boxes = boxesOf(made, drawing);
    double least = 1e9, most = -1e9;
    for (size_t i = 0; i < boxes.size(); ++i) {
      expectInside(boxes[i], drawing.size);
      least = std::min(least, boxes[i].middle.across - boxes[i].size.across / 2);
      most = std::max(most, boxes[i].middle.across + boxes[i].size.across / 2);
      for (size_t k = 0; k < i; ++k) {
        EXPECT_FALSE(overlap(boxes[i], boxes[k])) << round << ": " << i << " and " << k;
      }
    }
    // Lines may bend round what stands outermost, but no sheet is mostly empty.
    EXPECT_LE(drawing.size.across - (most - least), 400) << round;
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

TEST(GraphLayout, EdgesBeginAndEndAtTheirNodes) {
  std::mt19937 random(8);
  for (int round = 0; round < 300; ++round) {
    const Case made = randomCase(random);
    const Drawing drawing = layOut(made.nodes, made.edges);
    auto touches = [&](Point point, uint32_t node) {
      const Size size = made.nodes[node].size;
      const Point middle = drawing.nodes[node];
      return std::abs(std::abs(point.along - middle.along) - size.along / 2) < 1e-6 &&
             std::abs(point.across - middle.across) <= size.across / 2 + 1e-6;
    };
    for (size_t i = 0; i < made.edges.size(); ++i) {
      const std::vector<Stretch>& stretches = drawing.edges[i].stretches;
      EXPECT_TRUE(touches(stretches.front().from, made.edges[i].from)) << round << ": " << i;
      EXPECT_TRUE(touches(stretches.back().to, made.edges[i].to)) << round << ": " << i;
    }
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

TEST(GraphLayout, TheSameGraphGivesTheSameDrawing) {
  std::mt19937 random(9);
  const Case made = randomCase(random);
  const Drawing one = layOut(made.nodes, made.edges), two = layOut(made.nodes, made.edges);
  for (size_t i = 0; i < made.nodes.size(); ++i) {
    EXPECT_EQ(one.nodes[i].along, two.nodes[i].along);
    EXPECT_EQ(one.nodes[i].across, two.nodes[i].across);
  }
}

TEST(GraphLayout, AnEmptyGraphIsAnEmptyDrawing) {
  const Drawing drawing = layOut({}, {});
  EXPECT_EQ(drawing.size.along, 0);
  EXPECT_EQ(drawing.size.across, 0);
}

}  // namespace
}  // namespace glider::report::layered
