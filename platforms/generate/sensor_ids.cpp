// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Writes the C header of a platform's sensors while glidercc is built, in the same way as `glidercc
// platform --header`: glider_sensor_ids platforms/slocum.toml generated/platforms/slocum_sensors.h

#include "platforms/generate/sensor_header.h"
#include "platforms/load/load_platform.h"
#include "support/files.h"

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: glider_sensor_ids PLATFORM.toml HEADER.h\n");
    return 2;
  }
  const auto platform = glider::platforms::loadPlatform(argv[1]);
  if (!platform) {
    std::fprintf(stderr, "%s\n", platform.error().message.c_str());
    return 1;
  }
  const auto written =
      glider::support::writeFileAtomically(argv[2], glider::platforms::sensorHeader(*platform));
  if (!written) {
    std::fprintf(stderr, "%s\n", written.error().message.c_str());
    return 2;
  }
  return 0;
}
