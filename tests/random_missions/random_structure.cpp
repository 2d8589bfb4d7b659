// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_missions/random_structure.h"

#include <fmt/format.h>

namespace glider::random_missions {
namespace {

constexpr const char* kHeader = R"(glider_ir 1
mission m platform slocum
behaviour profile glide symbol gliderProfileGlide () reads ()
behaviour route drift symbol gliderRouteDrift () reads ()
)";

constexpr const char* kGuards[] = {"(ge statetime 4:time)",
                                   "(ge statetime 4:time)",
                                   "(ge statetime 4:time)",
                                   "true",
                                   "false",
                                   "(not (or true (ge statetime 4:time)))"};

std::string guardText(Random& random) {
  return fmt::format("case {} ", random.chance(0.8) ? kGuards[0] : random.pick(kGuards));
}

std::string alwaysText(Random& random, uint32_t states) {
  std::string text = "always ";
  for (uint32_t k = random.between(1, 4); k > 0; --k) {
    constexpr const char* kKinds[] = {"call", "call", "goto", "exit", "stay"};
    const std::string kind = random.pick(kKinds);
    const bool targeted = kind == "call" || kind == "goto";
    text += guardText(random) + kind +
            (targeted ? fmt::format(" s{} ", random.below(states)) : std::string(" "));
  }
  return text;
}

}  // namespace

std::string randomStructure(Random& random, bool with_always) {
  const bool forward = random.chance(0.5);
  const uint32_t states = random.between(1, with_always ? 5 : forward ? 6 : 4);
  const uint32_t most_cases = random.between(1, with_always ? 3 : 5);
  std::string text = kHeader + (with_always ? alwaysText(random, states) : "");
  for (uint32_t s = 0; s < states; ++s) {
    std::string cases;
    for (uint32_t k = random.below(most_cases + 1); k > 0; --k) {
      cases += guardText(random);
      switch (random.below(8)) {
        case 0:
        case 1:
          cases += fmt::format("goto s{} ", random.below(states));
          break;
        case 2:
        case 3:
        case 4:
          cases += forward && s + 1 == states
                       ? "stay "
                       : fmt::format("call s{} ", forward ? random.between(s + 1, states - 1)
                                                          : random.below(states));
          break;
        case 5:
          cases += "return ";
          break;
        case 6:
          cases += "exit ";
          break;
        default:
          cases += "stay ";
      }
    }
    text += fmt::format("state s{} route drift () profile glide () {}\n", s, cases);
  }
  return text;
}

}  // namespace glider::random_missions
