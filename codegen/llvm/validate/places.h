// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/lower/abi_types.h"
#include "codegen/llvm/lower/mission_index.h"
#include "codegen/llvm/validate/numbers.h"
#include "ir/core/mission.h"

#include <llvm/IR/DataLayout.h>

#include <map>
#include <optional>
#include <string>

namespace glider::codegen::validate {

/// An address: the number of an object in its upper half, the offset in bytes in its lower. Null
/// is 0.
using Address = uint64_t;

/// What a place of memory is to the mission.
enum class CellKind : uint8_t {
  Number,   ///< a double that may be any number or unknown
  Settled,  ///< a double that is never -0: a reading, a time
  Truth,    ///< a double that is 0, 1 or unknown
  Word,     ///< 32 bits
  Hidden    ///< belongs to the runtime's own work; reached only through its functions
};

struct Cell {
  CellKind kind = CellKind::Number;
  uint32_t bytes = 8;
  std::string name;    ///< as a pilot says it: "depth", "the variable `n`"
  bool stable = true;  ///< no function that a mission calls changes it
};

/// The memory of a running mission: the context, and the arrays behind its pointers, which do not
/// overlap (runtime/core/lay_out.h). Objects are named once, by what they are or hold, so that code
/// and mission mean the same address by the same object.
class Places {
 public:
  /// All outlive this.
  Places(const ir::Mission& mission, const MissionIndex& index, const AbiTypes& types,
         const llvm::DataLayout& layout)
      : mission_(mission), index_(index), types_(types), layout_(layout) {}

  [[nodiscard]] const ir::Mission& mission() const { return mission_; }
  /// The address of the object `name`.
  Address object(const std::string& name);
  /// The object at which a pointer in the context points; empty: there is no pointer at `offset`.
  std::optional<Address> behind(Address pointer);

  // Places that are meant by the mission.
  Address context(unsigned field);
  Address variable(ir::VariableId id);
  Address temporal(ir::TemporalId id, uint32_t slot);
  Address reading(ir::SensorId id, unsigned field);
  Address call(ir::UseId id, unsigned field);
  Address behaviourMemory(uint32_t block);
  Address text(const std::string& text);

  /// What is at an address. Throws Undecided if nothing whole begins there.
  Cell at(Address address);
  /// The fields of the context that lie wholly between two offsets.
  std::vector<Address> fieldsIn(Address from, uint64_t bytes);

 private:
  Cell inContext(uint64_t offset);
  Cell inReadings(uint64_t offset);
  Cell inCalls(uint64_t offset);
  Cell inVariables(uint64_t offset);
  Cell inTemporals(uint64_t offset);
  [[nodiscard]] std::optional<unsigned> fieldAt(llvm::StructType* type, uint64_t offset) const;
  [[nodiscard]] uint64_t offsetOf(llvm::StructType* type, unsigned field) const;

  const ir::Mission& mission_;
  const MissionIndex& index_;
  const AbiTypes& types_;
  const llvm::DataLayout& layout_;
  std::map<std::string, Address> objects_;
};

/// The object of an address, at offset 0, and the offset.
constexpr Address objectOf(Address address) {
  return address >> 32U << 32U;
}
constexpr uint64_t offsetIn(Address address) {
  return address & UINT32_MAX;
}

}  // namespace glider::codegen::validate
