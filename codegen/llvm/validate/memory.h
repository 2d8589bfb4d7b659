// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/validate/numbers.h"
#include "codegen/llvm/validate/places.h"

#include <map>
#include <string>
#include <vector>

namespace glider::codegen::validate {

/// The memory at one place in a function, as terms over what it was when the function began.
struct Memory {
  std::map<Address, z3::expr> cells;  ///< what may have changed
  /// All that only the runtime's functions and the user's read and change: commands, notes, C code.
  z3::expr world;
};

/// What a function does: the number that it returns (0 of one that returns nothing), and memory.
struct Outcome {
  z3::expr result;
  Memory memory;
};

/// What mission and code do to memory: the same for both. The functions that they call are
/// contracts: of each is known what it may change, of what that depends, and nothing else.
class Effects {
 public:
  /// Both outlive this.
  Effects(Numbers& numbers, Places& places);

  /// When the function begins: any memory in which truth values are 0, 1 or unknown, and readings
  /// and times are never -0, as the runtime leaves it.
  Memory first();
  z3::expr load(const Memory& memory, Address address);
  void store(Memory& memory, Address address, const z3::expr& value);
  /// `a` if `condition` holds, else `b`.
  Memory either(const z3::expr& condition, const Memory& a, const Memory& b);
  Outcome either(const z3::expr& condition, const Outcome& a, const Outcome& b);

  /// A function of the runtime that returns nothing and changes the world.
  void command(Memory& memory, const std::string& name, const std::vector<z3::expr>& arguments);
  /// The user's function: its result may be anything, and depend on anything but the context.
  z3::expr foreign(Memory& memory, const std::string& name, const std::vector<z3::expr>& arguments);
  /// A function of runtime/numbers: its result depends on the arguments alone, and is settled.
  z3::expr pure(const std::string& name, const std::vector<z3::expr>& arguments);
  /// A function of the window whose memory begins at `slot`.
  void window(Memory& memory, const std::string& name, Address slot,
              const std::vector<z3::expr>& arguments);

  z3::expr address(Address address) { return z3().bv_val(address, 64); }
  z3::expr word(uint32_t value) { return z3().bv_val(value, 32); }
  z3::expr truth(bool value) { return z3().bool_val(value); }
  z3::context& z3() { return numbers_.z3(); }
  Numbers& numbers() { return numbers_; }
  Places& places() { return places_; }
  /// What each cell held when the function began.
  [[nodiscard]] const std::map<Address, z3::expr>& initial() const { return initial_; }

 private:
  z3::expr initially(Address address);

  Numbers& numbers_;
  Places& places_;
  z3::sort world_;
  std::map<Address, z3::expr> initial_;
};

}  // namespace glider::codegen::validate
