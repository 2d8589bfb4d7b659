// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/validate/tables.h"

#include "codegen/llvm/lower/abi_types.h"
#include "ir/core/ops.h"
#include "runtime/abi/glider_abi.h"
#include "support/check.h"

#include <fmt/format.h>
#include <llvm/IR/Constants.h>

#include <cstring>

namespace glider::codegen::validate {

const llvm::Constant* fieldOf(const llvm::Constant& record, unsigned field) {
  return llvm::cast_or_null<llvm::Constant>(record.getAggregateElement(field));
}

const llvm::Constant* behind(const llvm::Constant* pointer) {
  const auto* global = llvm::dyn_cast_or_null<llvm::GlobalVariable>(pointer);
  return global != nullptr && global->hasDefinitiveInitializer() ? global->getInitializer()
                                                                 : nullptr;
}

uint64_t wordOf(const llvm::Constant& record, unsigned field) {
  return llvm::cast<llvm::ConstantInt>(fieldOf(record, field))->getZExtValue();
}

namespace {

uint64_t bitsOf(const llvm::Constant& record, unsigned field) {
  return llvm::cast<llvm::ConstantFP>(fieldOf(record, field))
      ->getValueAPF()
      .bitcastToAPInt()
      .getZExtValue();
}

uint64_t bitsOf(double value) {
  uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

/// Notes the first thing that differs.
class Differences {
 public:
  void words(const std::string& what, uint64_t meant, uint64_t found) {
    if (meant != found && said_.empty()) {
      said_ = fmt::format("{} is {} and not {}", what, found, meant);
    }
  }
  void numbers(const std::string& what, double meant, uint64_t found) {
    if (bitsOf(meant) != found && said_.empty()) {
      said_ = fmt::format("{} is not {}", what, meant);
    }
  }
  void missing(const std::string& what) {
    if (said_.empty()) {
      said_ = what + " is missing";
    }
  }
  [[nodiscard]] Validated of(const std::string& what) const {
    return {what, said_.empty() ? Verdict::Same : Verdict::Differs, said_};
  }

 private:
  std::string said_;
};

/// The row of a list that a pointer leads to; null after saying that it is missing.
const llvm::Constant* rowOf(const llvm::Constant* list, size_t number, const std::string& what,
                            Differences& differences) {
  const llvm::Constant* content = behind(list);
  const llvm::Constant* row =
      content != nullptr ? content->getAggregateElement(static_cast<unsigned>(number)) : nullptr;
  if (row == nullptr) {
    differences.missing(what);
  }
  return row;
}

void compareCases(const std::vector<ir::Case>& cases, const llvm::Constant* list,
                  Differences& differences) {
  namespace field = field::GliderCaseInfo;
  for (size_t i = 0; i < cases.size(); ++i) {
    const std::string what = fmt::format("case {}", i + 1);
    if (const llvm::Constant* row = rowOf(list, i, what, differences)) {
      differences.words("the transition of " + what, static_cast<uint64_t>(cases[i].transition),
                        wordOf(*row, field::transition));
      differences.words("the target of " + what,
                        cases[i].target.valid() ? cases[i].target.index : 0,
                        wordOf(*row, field::target));
    }
  }
}

/// The states by their numbers.
void compareStates(const ir::Mission& mission, const llvm::Constant* list,
                   Differences& differences) {
  for (size_t i = 0; i < mission.states.size(); ++i) {
    const std::string what = fmt::format("state {}", i + 1);
    const llvm::Constant* place = rowOf(list, i, what, differences);
    if (place != nullptr && place->getName() != fmt::format("state.{}", i)) {
      differences.missing(what);
    }
  }
}

GliderSource sourceOf(const ir::Expr& value) {
  if (value.op == ir::Op::Sensor) {
    return kGliderSensor;
  }
  switch (ir::opIn<ir::ClockOp>(value.op)) {
    case ir::ClockOp::MissionTime:
      return kGliderMissionTime;
    case ir::ClockOp::StateTime:
      return kGliderStateTime;
    case ir::ClockOp::ResumeTime:
      return kGliderResumeTime;
  }
  CHECK(false, "a value that cannot be logged");
}

void compareLog(const ir::Mission& mission, const ir::State& state, const llvm::Constant* list,
                Differences& differences) {
  namespace field = field::GliderLogInfo;
  for (size_t i = 0; i < state.log.size(); ++i) {
    const ir::LogItem& item = state.log[i];
    const std::string what = fmt::format("`log {}`", item.name);
    if (const llvm::Constant* row = rowOf(list, i, what, differences)) {
      const ir::Expr& value = mission[item.value];
      differences.numbers("the time of " + what, item.period_s, bitsOf(*row, field::period));
      differences.words("what is logged by " + what, sourceOf(value), wordOf(*row, field::source));
      differences.words("the sensor of " + what,
                        value.op == ir::Op::Sensor ? value.sensor.index : 0,
                        wordOf(*row, field::sensor));
    }
  }
}

void compareSensors(const ir::Mission& mission, const llvm::Constant* list,
                    Differences& differences) {
  namespace field = field::GliderSensorInfo;
  for (size_t i = 0; i < mission.sensors.size(); ++i) {
    const ir::Sensor& sensor = mission.sensors[i];
    const std::string what = "the sensor `" + sensor.name + "`";
    if (const llvm::Constant* row = rowOf(list, i, what, differences)) {
      differences.words("the number of " + what, sensor.id, wordOf(*row, field::id));
      differences.words("the encoding of " + what, static_cast<uint64_t>(sensor.encoding),
                        wordOf(*row, field::encoding));
      differences.numbers("the factor of " + what, sensor.to_si, bitsOf(*row, field::to_si));
      differences.numbers("the lowest reading of " + what, sensor.lowest,
                          bitsOf(*row, field::lowest));
      differences.numbers("the highest reading of " + what, sensor.highest,
                          bitsOf(*row, field::highest));
      differences.numbers("the age of " + what, sensor.stale_after_s,
                          bitsOf(*row, field::stale_after));
    }
  }
}

}  // namespace

Validated compareState(const ir::Mission& mission, ir::StateId id,
                       const llvm::Constant& described) {
  namespace field = field::GliderStateInfo;
  const ir::State& state = mission[id];
  Differences differences;
  differences.words("the number of cases", state.cases.size(),
                    wordOf(described, field::case_count));
  differences.words("the number of logged values", state.log.size(),
                    wordOf(described, field::log_count));
  compareCases(state.cases, fieldOf(described, field::cases), differences);
  compareLog(mission, state, fieldOf(described, field::log), differences);
  return differences.of("the table of `" + state.name + "`");
}

Validated compareMission(const ir::Mission& mission, uint32_t stack_depth,
                         const llvm::Constant& described) {
  namespace field = field::GliderMission;
  Differences differences;
  const auto count = [&](const char* what, size_t meant, unsigned of) {
    differences.words(what, meant, wordOf(described, of));
  };
  count("the number of states", mission.states.size(), field::state_count);
  count("the number of sensors", mission.sensors.size(), field::sensor_count);
  count("the number of frames", stack_depth, field::stack_limit);
  count("the number of variables", mission.variables.size(), field::variable_count);
  count("the number of cases of `always`", mission.always.size(), field::always_count);
  count("the number of calls of C functions", mission.uses.size(), field::call_count);
  differences.numbers("the longest outage", mission.resume_within_s,
                      bitsOf(described, field::resume_within));
  count("whether a restart ends the mission", mission.new_after_restart ? 1 : 0,
        field::new_after_restart);
  compareStates(mission, fieldOf(described, field::states), differences);
  compareCases(mission.always, fieldOf(described, field::always), differences);
  compareSensors(mission, fieldOf(described, field::sensors), differences);
  return differences.of("the tables of the mission");
}

}  // namespace glider::codegen::validate
