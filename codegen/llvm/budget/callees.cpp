// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/callees.h"

#include "support/check.h"

#include <algorithm>
#include <set>
#include <string_view>

namespace glider::codegen {
namespace {

/// The mission's functions that a function of the runtime calls in a tick.
struct PointerCall {
  std::string_view file, function;
  const char* prefix;
};
constexpr PointerCall kPointerCalls[] = {
    {"step.cpp", "advance", "advance."},
    {"step.cpp", "firstTrue", "guards."},
    {"step.cpp", "fire", "act."},
    {"step.cpp", "enter", "enter."},
    {"step.cpp", "fly", "profile."},
    {"step.cpp", "fly", "route."},
    {"guard_table.cpp", "firstTrue", "holds."},
};

/// The kinds of functions that are called through pointers.
enum class Kind : uint8_t {
  kOthers,
  kStart,
  kMain,
  kSecondStage,
  kEnds,
  kNobody,
  kAfterSignals,
  kNotHere,
  kKernel,
  kFindsClock,
  kClock,
  kByName,
  kMission,
  kHolds,
  kForesee,
  kNapTick,
  kSensors
};

struct CalleeRow {
  std::string_view name;
  Kind kind = Kind::kOthers;
};

constexpr CalleeRow kKinds[] = {
#define KIND(kind, name, why) {name, Kind::kind},
#define POINTER(caller, kind, why)
#define ATONCE(function, calls, why)
#define GROUP(group, function, excluded, why)
#include "codegen/llvm/budget/callees.def"
#undef KIND
#undef POINTER
#undef ATONCE
#undef GROUP
};

constexpr CalleeRow kCallers[] = {
#define KIND(kind, name, why)
#define POINTER(caller, kind, why) {caller, Kind::kind},
#define ATONCE(function, calls, why)
#define GROUP(group, function, excluded, why)
#include "codegen/llvm/budget/callees.def"
#undef KIND
#undef POINTER
#undef ATONCE
#undef GROUP
};

struct AtOnce {
  std::string_view function;
  uint64_t calls;
};
constexpr AtOnce kAtOnce[] = {
#define KIND(kind, name, why)
#define POINTER(caller, kind, why)
#define ATONCE(function, calls, why) {function, calls},
#define GROUP(group, function, excluded, why)
#include "codegen/llvm/budget/callees.def"
#undef KIND
#undef POINTER
#undef ATONCE
#undef GROUP
};

/// The groups of functions of which some exclude others.
enum Groups : uint32_t {
  kRead = 1,
  kWrite = 2,
  kHear = 4,
  kAnswer = 8,
  kSeat = 16,
  kOuter = 32,
  kLine = 64,
  kReport = 128,
  kProgram = kRead | kWrite | kReport,  ///< what only the main program calls
  kAll = 255,
};

struct GroupRow {
  std::string_view function;
  uint32_t group;
  uint32_t excluded;
};
constexpr GroupRow kGroups[] = {
#define KIND(kind, name, why)
#define POINTER(caller, kind, why)
#define ATONCE(function, calls, why)
#define GROUP(group, function, excluded, why) {function, group, excluded},
#include "codegen/llvm/budget/callees.def"
#undef KIND
#undef POINTER
#undef ATONCE
#undef GROUP
};

bool fits(std::string_view name, std::string_view row) {
  return row.ends_with('*') ? name.starts_with(row.substr(0, row.size() - 1)) : name == row;
}

Kind kindOf(std::string_view name) {
  const auto* row =
      std::ranges::find_if(kKinds, [&](const CalleeRow& one) { return fits(name, one.name); });
  return row == std::end(kKinds) ? Kind::kOthers : row->kind;
}

/// The kinds of functions that a function calls through pointers; kOthers if it has no row.
std::set<Kind> calledBy(std::string_view caller) {
  std::set<Kind> kinds;
  for (const CalleeRow& row : kCallers) {
    if (fits(caller, row.name)) {
      kinds.insert(row.kind);
    }
  }
  return kinds.empty() ? std::set{Kind::kOthers} : kinds;
}

}  // namespace

Callees::Callees(const Image& image, const ir::Mission& mission) : image_(image) {
  for (const ir::Sensor& sensor : mission.sensors) {
    if (!sensor.symbol.empty() || sensor.isHeard()) {
      const auto poll = image.function(sensor.isHeard() ? "gliderNothingHeard" : sensor.symbol);
      CHECK(poll.has_value(), "an executable was linked without the function of a sensor");
      polls_.push_back(*poll);
    }
  }
  for (const uint64_t taken : image.takenFunctions()) {
    const std::string name = image.fullNameAt(taken);
    const auto* row = std::ranges::find(kGroups, name, &GroupRow::function);
    if (row != std::end(kGroups)) {
      groups_.emplace(taken, Group{row->group, row->excluded});
    }
  }
}

std::vector<uint64_t> Callees::inTick(const std::vector<Frame>& frames) const {
  const Frame& frame = frames.front();
  if (frame.line != 0 && frame.file == "readings.cpp" && frame.function == "pollSensors") {
    return polls_;
  }
  std::vector<uint64_t> some, all = polls_;
  bool placed = false;
  for (const PointerCall& call : kPointerCalls) {
    const std::vector<uint64_t> named = image_.functionsNamed(call.prefix);
    all.insert(all.end(), named.begin(), named.end());
    if (frame.line != 0 && frame.file == call.file && frame.function == call.function) {
      some.insert(some.end(), named.begin(), named.end());
      placed = true;
    }
  }
  return placed ? some : all;
}

uint32_t Callees::excludedBy(uint64_t entry) const {
  const auto found = groups_.find(entry);
  return found == groups_.end() ? 0 : found->second.excluded;
}

std::vector<uint64_t> Callees::inProgram(uint64_t call, uint32_t excluded) const {
  const std::set<Kind> wanted = calledBy(image_.baseNameAt(call));
  std::vector<uint64_t> targets;
  if (wanted.contains(Kind::kMission) || wanted.contains(Kind::kSensors)) {
    targets = polls_;  // pollSensors may be inlined into a tick
  }
  for (const uint64_t target : image_.takenFunctions()) {
    const auto found = groups_.find(target);
    const bool may = found == groups_.end() || (found->second.group & excluded) == 0;
    if (may && wanted.contains(kindOf(image_.symbolAt(target)))) {
      targets.push_back(target);
    }
  }
  return targets;
}

uint64_t callsAtOnce(const std::string& symbol) {
  const auto* row = std::ranges::find(kAtOnce, symbol, &AtOnce::function);
  return row == std::end(kAtOnce) ? 1 : row->calls;
}

}  // namespace glider::codegen
