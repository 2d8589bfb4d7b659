// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/evidence/in_profile.h"

#include "ir/certify/names.h"
#include "ir/prove/evidence/formula.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace glider::ir::prove {
namespace {

/// When the times of a ModeBound begin.
constexpr const char* kStart = "(ite (>= |resumed| |surfaced|) |resumed| |surfaced|)";

std::string nameOf(const Mission& mission, VariableId id) {
  return certify::variableName(mission[id], "");
}

/// `time` is no later than this after the start.
std::string startedBy(const std::string& time, double longest) {
  return fmt::format("(<= (- {} {}) {})", time, kStart, realText(longest));
}

void addClimb(FormulaParts& parts, const Mission& mission, const ProfileSurfacing& profile,
              const ModeBound& bound) {
  parts.add("|climbing|");
  parts.add("(<= |top| 0.0)");
  parts.add(startedBy("|climbing since|", bound.from_start ? 0 : bound.longest));
  parts.add(fmt::format("(=> (>= (- |time| |climbing since|) {}) (= |surfaced| |time|))",
                        realText(profile.climb_s)));
  if (!bound.from_start) {
    for (const VariableId id : profile.waits) {
      parts.add(fmt::format("(>= {} |climbing since|)", nameOf(mission, id)));
    }
  }
}

std::string inMode(const Mission& mission, const ProfileSurfacing& profile,
                   const ModeBound& bound) {
  FormulaParts parts;
  for (size_t i = 0; i < profile.own.size(); ++i) {
    const bool is_true = bound.mode.truths[i] == Truth::True;
    parts.add(certify::variableName(mission[profile.own[i]], is_true ? " true" : " false"));
  }
  parts.add(startedBy(nameOf(mission, profile.since), bound.ahead));
  if (bound.climbs()) {
    addClimb(parts, mission, profile, bound);
  } else {
    parts.add(anyOf({startedBy("|time|", bound.longest),
                     fmt::format("(<= (- |time| {}) {})", nameOf(mission, profile.since),
                                 realText(bound.timed))}));
  }
  return parts.all();
}

}  // namespace

std::string inProfile(const Mission& mission, const ProfileSurfacing& profile) {
  if (profile.modes.empty()) {
    return "true";
  }
  std::vector<std::string> modes;
  for (const ModeBound& bound : profile.modes) {
    modes.push_back(inMode(mission, profile, bound));
  }
  return anyOf(modes);
}

std::string timesOfProfile(const Mission& mission, const ProfileSurfacing& profile) {
  if (profile.modes.empty()) {
    return "true";
  }
  std::vector<VariableId> times = profile.waits;
  times.push_back(profile.since);
  FormulaParts parts;
  for (const VariableId id : times) {
    parts.isKnown(mission[id]);
    parts.add(fmt::format("(<= {} |time|)", nameOf(mission, id)));
  }
  return parts.all();
}

}  // namespace glider::ir::prove
