// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Paths of any length, put together in any way, keep their ends.

#include "ir/verify/path.h"

#include "ir/verify/structure.h"
#include "tests/random_missions/random.h"
#include "tests/unit/ir/missions.h"

#include <fmt/format.h>

namespace glider::ir {
namespace {

/// What a path keeps of the transitions whose cases are numbered 0, 1, 2…
void expectEnds(const Path& path, size_t size) {
  ASSERT_EQ(path.size(), size);
  for (size_t i = 0; i < size; ++i) {
    ASSERT_EQ(path.keeps(i), i < Path::kFirst || i + Path::kLast >= size) << i << " of " << size;
    if (path.keeps(i)) {
      EXPECT_EQ(path[i].case_index, i);
    }
  }
}

TEST(Path, KeepsBothEndsHoweverItIsPutTogether) {
  random_missions::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    Path path;
    size_t size = 0;
    for (uint32_t parts = random.below(5); parts > 0; --parts) {
      const size_t count = random.below(20);
      Path more;
      more.append(count, [&](size_t k) {
        Edge edge;
        edge.case_index = static_cast<uint32_t>(size + k);
        return edge;
      });
      path.append(more);
      size += count;
    }
    expectEnds(path, size);
  }
}

TEST(Path, OfAMissionIsTheWayThere) {
  std::string text = kHeader;
  for (int s = 0; s < 30; ++s) {
    text += stateText(fmt::format("s{}", s),
                      fmt::format("case (ge statetime 4:time) goto s{}", (s + 1) % 30));
  }
  const Mission mission = missionOf(text);
  const Structure structure(mission);
  for (uint32_t state = 0; state < 30; ++state) {
    const Path path = structure.pathTo({state, Arrived::Free});
    ASSERT_EQ(path.size(), state);
    for (size_t i = 0; i < path.size(); ++i) {
      if (path.keeps(i)) {
        EXPECT_EQ(path[i].from, i);
        EXPECT_EQ(path[i].to, i + 1);
      }
    }
  }
}

}  // namespace
}  // namespace glider::ir
