// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/pointer_jump.h"

#include "codegen/llvm/budget/flow_graph.h"

#include <algorithm>

namespace glider::codegen {

PointerJumps::PointerJumps(const std::vector<Instruction>& code, const StartOf& start_of,
                           const std::set<uint64_t>& words)
    : code_(code), start_of_(start_of), words_(words) {
  for (uint32_t i = 0; i < code.size(); ++i) {
    if (code[i].flow == Flow::Jump || code[i].flow == Flow::JumpIf) {
      jumps_.emplace(code[i].target, i);
    }
  }
}

bool PointerJumps::leaves(uint32_t place) const {
  if (mayGoto(place)) {
    return false;
  }
  std::set<Held> met = {{place, code_[place].pointer}};
  std::vector<Held> work(met.begin(), met.end());
  while (!work.empty()) {
    const Held held = work.back();
    work.pop_back();
    std::vector<Held> earlier;
    if (!before(held, earlier)) {
      return false;
    }
    for (const Held& one : earlier) {
      if (met.insert(one).second) {
        work.push_back(one);
      }
    }
  }
  return true;
}

/// Whether a loaded word, or the table of a switch, is a place within the function: then other ways
/// may lead there than those that are seen.
bool PointerJumps::mayGoto(uint32_t place) const {
  const uint64_t start = start_of_(code_[place].address);
  const auto of_function = [&](uint64_t address) { return start_of_(address) == start; };
  const auto word = words_.upper_bound(start);
  if (start == 0 || (word != words_.end() && of_function(*word))) {
    return true;
  }
  const auto first = std::ranges::lower_bound(code_, start, {}, &Instruction::address);
  const auto end = std::ranges::find_if_not(
      first, code_.end(), [&](const Instruction& one) { return of_function(one.address); });
  return std::ranges::any_of(first, end, [](const Instruction& one) {
    return one.flow == Flow::JumpByTable || one.flow == Flow::Unknown;
  });
}

/// Whether the place that an instruction mentions, if it does, is where a function begins.
bool PointerJumps::ofFunction(const Instruction& one) const {
  const uint64_t place = one.mentions.numbers[0];
  return one.mentions.count == 0 || start_of_(place) == place;
}

/// Adds what the register is after each instruction from which control may come; false if one of
/// them gives it what need not be a pointer.
bool PointerJumps::before(const Held& held, std::vector<Held>& earlier) const {
  const uint64_t address = code_[held.place].address, start = start_of_(address);
  const bool begins = address == start;  // the function was called with it
  bool reached = begins;
  const auto [first, last] = jumps_.equal_range(address);
  for (auto jump = first; jump != last; ++jump) {
    const bool own = start_of_(code_[jump->second].address) == start;
    if (own ? !through({jump->second, held.number}, earlier) : !begins) {
      return false;
    }
    reached = true;
  }
  const bool follows = held.place > 0 && !begins && goesOn(code_[held.place - 1].flow) &&
                       code_[held.place - 1].address + code_[held.place - 1].size == address;
  return follows ? through({held.place - 1, held.number}, earlier) : reached;
}

/// What the register, after the instruction in that place, was before it.
bool PointerJumps::through(const Held& held, std::vector<Held>& earlier) const {
  const Instruction& one = code_[held.place];
  const bool calls = one.flow == Flow::Call || one.flow == Flow::CallByPointer;
  if (calls && (kAArch64Stack.lost >> held.number & 1U) != 0) {
    return false;
  }
  if ((one.stack.writes >> held.number & 1U) == 0) {
    earlier.push_back(held);
    return true;
  }
  const bool copies =
      one.stack.to == held.number && one.stack.bytes == 0 && one.stack.from < kAArch64Stack.pointer;
  if (copies) {
    earlier.push_back({held.place, one.stack.from});
  }
  return copies || ((one.pointers >> held.number & 1U) != 0 && ofFunction(one));
}

}  // namespace glider::codegen
