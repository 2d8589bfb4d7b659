// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/library/yo.h"

#include "runtime/core/assert.h"
#include "runtime/library/library.h"

namespace glider::runtime {

Direction turn(Direction direction, uint32_t phase, double depth, const YoRange& range) {
  const bool depth_unknown = depth != depth;
  if (depth_unknown || depth >= range.bottom) {
    return Direction::Up;
  }
  if (phase != kGliderTick || direction == Direction::None || depth <= range.top) {
    return Direction::Down;
  }
  return direction;
}

void flyLeg(GliderContext* context, Direction direction, const YoRange& range) {
  if (direction == Direction::Down) {
    gliderDescend(context, range.bottom, range.dive);
  } else {
    gliderAscend(context, range.top, range.climb);
  }
}

}  // namespace glider::runtime

extern "C" void gliderProfileYo(GliderContext* context, GliderBehaviourMemory* memory,
                                uint32_t phase, double top, double bottom, double dive,
                                double climb) {
  using glider::runtime::Direction;
  const glider::runtime::YoRange range{top, bottom, dive, climb};
  auto& direction = *reinterpret_cast<Direction*>(memory->bytes);
  if (!GLIDER_ASSERT(*context, direction <= Direction::Up, YoDirection)) {
    return;
  }
  const double depth = gliderRead(context, gliderSensorOf(context, kGliderRoleDepth));
  direction = glider::runtime::turn(direction, phase, depth, range);
  glider::runtime::flyLeg(context, direction, range);
}

extern "C" void gliderProfileSurfaced(GliderContext* context, GliderBehaviourMemory*, uint32_t) {
  gliderSurface(context);
}
