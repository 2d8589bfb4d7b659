// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/text/read.h"
#include "support/diagnostics/render.h"

#include <gtest/gtest.h>

#include <string>

namespace glider::ir {

/// The mission of this text, which must be right.
inline Mission missionOf(const std::string& text) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  std::optional<Mission> mission = read(sources, sources.add("test", text), diagnostics);
  EXPECT_TRUE(mission.has_value()) << support::render(diagnostics, sources, false);
  return mission.value_or(Mission());
}

/// The start of a text with two behaviours and two sensors.
inline const std::string kHeader = R"(glider_ir 1
mission m platform slocum
sensor depth: length vehicle m_depth id 1 encoding linear to_si 1 lowest -1 highest 100 stale_after 20
sensor temp: temperature vehicle sci_water_temp id 2 encoding linear to_si 1 lowest -2 highest 40 stale_after 20
behaviour profile glide symbol gliderProfileGlide () reads (depth)
behaviour profile to symbol gliderProfileTo (target: length, since: time) reads ()
behaviour route drift symbol gliderRouteDrift () reads ()
)";

/// The start of a text of a mission that tells three values in two messages, and receives two of
/// them.
inline const std::string kTalking =
    kHeader +
    R"(sensor present_time: time vehicle m_present_time id 3 encoding linear to_si 1 lowest 0 highest 4e9 stale_after 60
sensor "peer.top": length received id 65024 encoding linear to_si 1 lowest 0 highest 200 stale_after 600
sensor "peer.found": number received id 65025 encoding linear to_si 1 lowest 0 highest 1 stale_after 600
variable found: bool mission
initial found false
utc present_time
share top of sensor depth received "peer.top" lowest 0 step 0.1 values 2001 every 60
share found of variable found received "peer.found" lowest 0 step 1 values 2 every 60
share warm of sensor temp lowest -2 step 0.05 values 841 every 600
)";

/// The same, with the values of two of three named vehicles.
inline const std::string kNamedTalking = [] {
  std::string text = kTalking;
  text.insert(
      text.find("variable found"),
      R"(sensor "ada.top": length received id 65056 encoding linear to_si 1 lowest 0 highest 200 stale_after 600
sensor "carl.top": length received id 65057 encoding linear to_si 1 lowest 0 highest 200 stale_after 600
vehicle ada
vehicle bob
vehicle carl
)");
  const std::string peer = "received \"peer.top\"";
  text.insert(text.find(peer) + peer.size(),
              " received \"ada.top\" from 1 received \"carl.top\" from 3");
  return text;
}();

/// A state that drifts.
inline std::string stateText(const std::string& name, const std::string& cases) {
  return "state " + name + " route drift () profile glide () " + cases + "\n";
}

}  // namespace glider::ir
