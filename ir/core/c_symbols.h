// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The symbols by which a mission finds its C code. They spell the types, so what was compiled
/// against another declaration does not link: "glider.function.density.temperature.number",
/// "glider.sensor.range.length", "glider.profile.spiral.length". After `reads`, a behaviour's names
/// the SBC's own sensors that it reads with their numbers: "glider.route.home.reads.range.0".
namespace glider::ir {

std::string functionSymbol(std::string_view name, const std::vector<Parameter>& parameters,
                           const Type& result);
std::string sensorSymbol(std::string_view name, const Type& type);
/// A sensor of the SBC's own that a behaviour reads.
struct OwnRead {
  std::string_view name;
  uint16_t id = 0;  ///< from kFirstOwnSensor on
};
std::string behaviourSymbol(BehaviourKind kind, std::string_view name,
                            const std::vector<Parameter>& parameters,
                            const std::vector<OwnRead>& own);

/// All that a mission and what it imports declare in C, used or not.
struct CInterface {
  std::vector<Function> functions;
  std::vector<Sensor> sensors;        ///< of the SBC's own
  std::vector<Behaviour> behaviours;  ///< `reads` is left empty
};
/// What a mission uses of C.
CInterface usedInC(const Mission& mission);

/// A symbol, read.
struct CSymbol {
  std::string kind;  ///< "function", "sensor", "profile", "route"
  std::string name;
  std::string declaration;  ///< as the language has it: "function density(temperature): number"
};
/// Empty of what is no such symbol.
std::optional<CSymbol> readSymbol(std::string_view symbol);

}  // namespace glider::ir
