// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/names/functions.h"

#include <algorithm>
#include <iterator>

namespace glider::frontend {
namespace {

struct WindowFunction {
  std::string_view name;
  ir::TemporalKind kind;
};

constexpr Function kFunctions[] = {
#define FUNCTION(name, op, what, ...) {#name, ir::Op::op, #__VA_ARGS__},
#define FREE_FUNCTION FUNCTION
#include "frontend/sema/names/functions.def"
};

constexpr std::string_view kEarth[] = {
#define EARTH_FUNCTION(name, use, what) #name,
#include "frontend/sema/names/functions.def"
};

constexpr std::string_view kFree[] = {
#define FREE_FUNCTION(name, ...) #name,
#define PLACE_FUNCTION(name, ...) #name,
#define HEADING_FUNCTION(name, ...) #name,
#define LEG_FUNCTION(name, ...) #name,
#include "frontend/sema/names/functions.def"
};

constexpr std::string_view kPlaces[] = {
#define PLACE_FUNCTION(name, use, what) #name,
#include "frontend/sema/names/functions.def"
};

constexpr std::string_view kHeadings[] = {
#define HEADING_FUNCTION(name, ...) #name,
#include "frontend/sema/names/functions.def"
};

constexpr WindowFunction kWindows[] = {
#define WINDOW_FUNCTION(name, kind, use, what) {#name, ir::TemporalKind::kind},
#define LEG_FUNCTION WINDOW_FUNCTION
#include "frontend/sema/names/functions.def"
};

}  // namespace

size_t Function::argumentCount() const {
  return 1 + static_cast<size_t>(std::ranges::count(arguments, ','));
}

const Function* findFunction(std::string_view name) {
  const auto* found = std::ranges::find(kFunctions, name, &Function::name);
  return found == std::end(kFunctions) ? nullptr : found;
}

std::optional<ir::TemporalKind> findWindow(std::string_view name) {
  const auto* found = std::ranges::find(kWindows, name, &WindowFunction::name);
  return found == std::end(kWindows) ? std::nullopt : std::optional(found->kind);
}

bool isEarthFunction(std::string_view name) {
  return std::ranges::find(kEarth, name) != std::end(kEarth);
}

bool isPlaceFunction(std::string_view name) {
  return std::ranges::find(kPlaces, name) != std::end(kPlaces);
}

bool isHeadingFunction(std::string_view name) {
  return std::ranges::find(kHeadings, name) != std::end(kHeadings);
}

bool isReservedFunction(std::string_view name) {
  return isFunctionName(name) && std::ranges::find(kFree, name) == std::end(kFree);
}

bool isFunctionName(std::string_view name) {
  return std::ranges::find(functionNames(), name) != functionNames().end();
}

const std::vector<std::string_view>& functionNames() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const FunctionText& function : functionTexts()) {
      list.push_back(function.name);
    }
    return list;
  }();
  return names;
}

std::span<const FunctionText> functionTexts() {
  static constexpr FunctionText kTexts[] = {
#define FUNCTION(name, op, what, ...) {#name, #name "(" #__VA_ARGS__ ")", what},
#define FREE_FUNCTION FUNCTION
#define EARTH_FUNCTION(name, use, what) {#name, use, what},
#define PLACE_FUNCTION(name, use, what) {#name, use, what},
#define HEADING_FUNCTION(name, use, what) {#name, use, what},
#define SPAN_FUNCTION(name, use, what) {#name, use, what},
#define WINDOW_FUNCTION(name, kind, use, what) {#name, use, what},
#define LEG_FUNCTION WINDOW_FUNCTION
#include "frontend/sema/names/functions.def"
  };
  return kTexts;
}

}  // namespace glider::frontend
