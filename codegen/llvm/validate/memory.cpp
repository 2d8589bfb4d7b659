// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/validate/memory.h"

#include "codegen/llvm/validate/undecided.h"

#include <fmt/format.h>

#include <set>

namespace glider::codegen::validate {

Effects::Effects(Numbers& numbers, Places& places)
    : numbers_(numbers),
      places_(places),
      world_(numbers.z3().array_sort(numbers.z3().bv_sort(64), numbers.z3().bv_sort(64))) {}

Memory Effects::first() {
  return {{}, z3().constant("world", world_)};
}

/// With what the runtime keeps to when it writes such a cell.
z3::expr Effects::initially(Address address) {
  const auto found = initial_.find(address);
  if (found != initial_.end()) {
    return found->second;
  }
  const Cell cell = places_.at(address);
  const z3::expr value = z3().bv_const(fmt::format("cell {:x}", address).c_str(), cell.bytes * 8);
  if (cell.bytes == sizeof(double)) {
    numbers_.assumeCanonical(value);
    numbers_.addFact(value, numbers_.isKnown(value) || value == numbers_.unknown());
  }
  if (cell.kind == CellKind::Settled) {
    numbers_.addFact(value, value != numbers_.constant(-0.0));
  } else if (cell.kind == CellKind::Truth) {
    numbers_.addFact(value, value == numbers_.constant(0) || value == numbers_.constant(1) ||
                                value == numbers_.unknown());
  }
  initial_.emplace(address, value);
  return value;
}

z3::expr Effects::load(const Memory& memory, Address address) {
  const Cell cell = places_.at(address);
  if (!cell.stable) {
    const z3::expr held = z3::select(memory.world, this->address(address));
    return cell.bytes == sizeof(double) ? numbers_.canonical(held) : held.extract(31, 0);
  }
  const auto found = memory.cells.find(address);
  return found != memory.cells.end() ? found->second : initially(address);
}

void Effects::store(Memory& memory, Address address, const z3::expr& value) {
  const Cell cell = places_.at(address);
  if (value.get_sort().bv_size() != cell.bytes * 8 || cell.kind == CellKind::Hidden) {
    throw Undecided("a store of another size than what is there");
  }
  const z3::expr kept = cell.bytes == sizeof(double) ? numbers_.canonical(value) : value;
  if (!cell.stable) {
    memory.world = z3::store(memory.world, this->address(address),
                             cell.bytes == sizeof(double) ? kept : z3::zext(kept, 32));
    return;
  }
  memory.cells.insert_or_assign(address, kept);
}

Outcome Effects::either(const z3::expr& condition, const Outcome& a, const Outcome& b) {
  return {z3::eq(a.result, b.result) ? a.result : z3::ite(condition, a.result, b.result).simplify(),
          either(condition, a.memory, b.memory)};
}

Memory Effects::either(const z3::expr& condition, const Memory& a, const Memory& b) {
  std::set<Address> changed;
  for (const Memory* one : {&a, &b}) {
    for (const auto& [address, value] : one->cells) {
      changed.insert(address);
    }
  }
  auto choose = [&](const z3::expr& yes, const z3::expr& no) {
    return z3::eq(yes, no) ? yes : z3::ite(condition, yes, no).simplify();
  };
  Memory result{{}, choose(a.world, b.world)};
  for (const Address address : changed) {
    const z3::expr value = choose(load(a, address), load(b, address));
    if (places_.at(address).bytes == sizeof(double)) {
      numbers_.assumeCanonical(value);
    }
    result.cells.emplace(address, value);
  }
  return result;
}

void Effects::command(Memory& memory, const std::string& name,
                      const std::vector<z3::expr>& arguments) {
  std::vector<z3::expr> all{memory.world};
  all.insert(all.end(), arguments.begin(), arguments.end());
  memory.world = numbers_.call(fmt::format("{}/{}", name, arguments.size()), world_, all);
}

z3::expr Effects::foreign(Memory& memory, const std::string& name,
                          const std::vector<z3::expr>& arguments) {
  std::vector<z3::expr> all{memory.world};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const z3::expr result = numbers_.call("result of " + name, z3().bv_sort(64), all);
  command(memory, name, arguments);
  return result;
}

z3::expr Effects::pure(const std::string& name, const std::vector<z3::expr>& arguments) {
  return numbers_.settle(numbers_.numberOf(name, arguments));
}

void Effects::window(Memory& memory, const std::string& name, Address slot,
                     const std::vector<z3::expr>& arguments) {
  const Address content = slot + sizeof(double);
  if (places_.at(slot).kind != CellKind::Number || places_.at(content).kind != CellKind::Hidden) {
    throw Undecided("a window's function gets something else than a window");
  }
  std::vector<z3::expr> all{load(memory, slot), load(memory, content)};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const z3::expr value = numbers_.numberOf(name + " gives", all);
  memory.cells.insert_or_assign(content, numbers_.numberOf(name + " keeps", all));
  memory.cells.insert_or_assign(slot, value);
}

}  // namespace glider::codegen::validate
