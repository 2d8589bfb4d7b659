// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The symbols by which a mission finds its C code. They contain the types, so code that was
/// compiled against another declaration does not link:
/// "glider.function.density.temperature.number", "glider.sensor.range.length",
/// "glider.profile.spiral.length". After `reads`, the symbol of a behaviour lists the SBC's own
/// sensors that it reads, with their numbers: "glider.route.home.reads.range.0".
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

/// Everything that a mission and its imports declare in C, used or not.
struct CInterface {
  std::vector<Function> functions;
  std::vector<Sensor> sensors;        ///< of the SBC's own
  std::vector<Behaviour> behaviours;  ///< `reads` is left empty
};
/// The C declarations that a mission uses.
CInterface usedInC(const Mission& mission);

/// The parts of a symbol.
struct CSymbol {
  std::string kind;  ///< "function", "sensor", "profile", "route"
  std::string name;
  std::string declaration;  ///< as the language has it: "function density(temperature): number"
};
/// Empty if `symbol` is not such a symbol.
std::optional<CSymbol> readSymbol(std::string_view symbol);

}  // namespace glider::ir
