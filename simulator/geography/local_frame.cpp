// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/geography/local_frame.h"

namespace glider::simulator {

GeoPosition LocalFrame::position(double x, double y) const {
  GeoPosition out;
  double height = 0;
  frame_.Reverse(x, y, 0, out.latitude_deg, out.longitude_deg, height);
  return out;
}

void LocalFrame::locate(GeoPosition position, double& x, double& y) const {
  double up = 0;
  frame_.Forward(position.latitude_deg, position.longitude_deg, 0, x, y, up);
}

}  // namespace glider::simulator
