// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/world/random_text.h"

#include "ir/prove/falsification/rng.h"

#include <fmt/format.h>

namespace glider::tests {
namespace {

using ir::prove::Rng;

constexpr double kDeepest = 55;  // m

class Text {
 public:
  explicit Text(uint64_t seed) : dice_(seed) {}

  std::string mission() {
    flying_ = 2 + dice_.below(4);
    called_ = 1 + dice_.below(2);
    text_ =
        "mission random\n\n"
        "param bottom: length = 25 m in 12 m .. 45 m\n\n"
        "flightprofile up(top: length, climb: angle)\nbegin\n"
        "  entry do ascend(top, climb) end\nend\n\n"
        "flightprofile down(bottom: length, dive: angle)\nbegin\n"
        "  entry do descend(bottom, dive) end\nend\n\n";
    text_ += fmt::format("always\n  case missiontime >= {} min exit\n\n", 60 + dice_.below(120));
    for (uint32_t i = 0; i < flying_ + called_; ++i) {
      state(i);
    }
    return text_;
  }

 private:
  std::string metres(double lowest, double highest) {
    return fmt::format("{:.1f} m", dice_.within(lowest, highest));
  }
  std::string pitch() { return fmt::format("{} deg", 12 + dice_.below(22)); }
  std::string name(uint32_t state) const {
    return fmt::format("{}{}", state < flying_ ? "fly" : "call", state);
  }

  std::string profile() {
    const double top = dice_.within(0.5, 25);
    const std::string bottom = dice_.chance(0.3)
                                   ? fmt::format("{:.1f} m + bottom / 2", top)
                                   : fmt::format("{:.1f} m", dice_.within(top + 3, kDeepest));
    switch (dice_.below(10)) {
      case 9:
        return fmt::format("fixed_trim({:.0f} cc, {:.2f} inch)", dice_.within(-233, 233),
                           dice_.within(-0.6, 0.6));
      case 0:
        return fmt::format("thermotrackyo({:.1f} m, {}, {}, {}, 4 degC, 5 m)", top, bottom, pitch(),
                           pitch());
      case 1:
        return fmt::format("dive_to({}, {})", bottom, pitch());
      case 2:
        return fmt::format("climb_to({:.1f} m, {})", top, pitch());
      case 3:
        return fmt::format("hover_at({})", metres(1.5, 40));
      case 4:
        return "surfaced";
      case 5:
        return fmt::format("up({:.1f} m, {})", top, pitch());
      case 6:
        return fmt::format("down({}, {})", bottom, pitch());
      default:
        return fmt::format("yo({:.1f} m, {}, {}, {})", top, bottom, pitch(), pitch());
    }
  }

  std::string route() {
    return dice_.chance(0.5) ? fmt::format("heading({} deg)", dice_.below(360))
                             : "nav(39.18 N, 73.82 W)";
  }

  std::string guard() {
    switch (dice_.below(5)) {
      case 0:
        return "depth > " + metres(5, kDeepest);
      case 1:
        return "depth < " + metres(1, 20);
      case 2:
        return fmt::format("temp < {:.1f} degC", dice_.within(8, 23));
      case 3:
        return fmt::format("held(depth > {}, 20 s)", metres(3, 30));
      default:
        return fmt::format("resumetime > {} s", 20 + dice_.below(600));
    }
  }

  std::string leave(uint32_t state) {
    if (dice_.chance(0.3) && state < flying_) {
      return "call " + name(flying_ + dice_.below(called_));
    }
    return state < flying_ ? "goto " + name(dice_.below(flying_)) : "return";
  }

  void state(uint32_t state) {
    text_ += fmt::format("state {}\nbegin\n  flightprofile {}\n", name(state), profile());
    text_ += dice_.chance(0.5) ? fmt::format("  flightroute {}\n", route()) : "";
    text_ += "  sensors missiontime, statetime, resumetime, depth, temp, lat, lon\n  events\n";
    const uint32_t cases = dice_.below(3);
    for (uint32_t i = 0; i < cases; ++i) {
      text_ += fmt::format("    case statetime > {} s && {} {}\n", 8 + dice_.below(120), guard(),
                           leave(state));
    }
    text_ += fmt::format("    case statetime >= {} s {}\n", 60 + dice_.below(900),
                         state < flying_ ? "goto " + name((state + 1) % flying_) : "return");
    text_ += "end\n\n";
  }

  Rng dice_;
  uint32_t flying_ = 0, called_ = 0;
  std::string text_;
};

}  // namespace

std::string randomMissionText(uint64_t seed) {
  return Text(seed).mission();
}

}  // namespace glider::tests
