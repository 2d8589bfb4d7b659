// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/taken.h"

#include <map>
#include <utility>

namespace glider::codegen {
namespace {

constexpr size_t kFar = 64;  // instructions between a distance or page and where it is added

bool touches(const Instruction& one, uint8_t number) {
  return ((one.mentions.registers | one.stack.writes) >> number & 1U) != 0;
}

/// The instruction that adds what `code[place]` loads to its own place; null if another use of the
/// register comes first, or the code goes elsewhere.
const Instruction* adderOf(const std::vector<Instruction>& code, size_t place) {
  const uint8_t number = code[place].mentions.literal_to;
  for (size_t i = place + 1; i < code.size() && i <= place + kFar; ++i) {
    if (code[i].mentions.pc_plus == number) {
      return &code[i];
    }
    const bool goes_on = code[i].flow == Flow::Next || code[i].flow == Flow::JumpIf;
    if (!goes_on || touches(code[i], number)) {
      return nullptr;
    }
  }
  return nullptr;
}

/// The instruction that adds what `code[place]` loads to its own place and replaces it with the
/// sum, if it certainly comes next; null otherwise.
const Instruction* onlyAdderOf(const std::vector<Instruction>& code, size_t place) {
  const uint8_t number = code[place].mentions.literal_to;
  for (size_t i = place + 1; i < code.size() && i <= place + kFar; ++i) {
    const Instruction& one = code[i];
    if (one.mentions.pc_plus == number) {
      const bool always = one.stack.condition[0] == '\0';
      return always && (one.stack.writes >> number & 1U) != 0 ? &one : nullptr;
    }
    if (one.flow != Flow::Next || touches(one, number)) {
      return nullptr;
    }
  }
  return nullptr;
}

bool loadsLiteral(const Instruction& one) {
  return one.mentions.literal_to < 15;
}

/// ARM in 64 bits: an address is the sum of a page and a number, which is known where the number is
/// added next and replaces the page. Otherwise the page may be that of any of its places.
void addPages(const std::vector<Instruction>& code, std::set<uint64_t>& addresses) {
  constexpr uint64_t kPage = 4096, kStep = 4;
  const auto summedNext = [&](size_t place) {
    const uint8_t number = code[place].mentions.page_to;
    for (size_t i = place + 1; i < code.size() && i <= place + kFar; ++i) {
      const Instruction& one = code[i];
      if (one.flow != Flow::Next || touches(one, number)) {
        return one.flow == Flow::Next && one.mentions.adds_to == number &&
               (one.stack.writes >> number & 1U) != 0;
      }
    }
    return false;
  };
  for (size_t i = 0; i < code.size(); ++i) {
    const uint64_t page = code[i].mentions.numbers[0];
    const bool of_code = page <= code.back().address && page + kPage > code.front().address;
    if (code[i].mentions.page_to != Mentions::kNone && of_code && !summedNext(i)) {
      for (uint64_t at = page; at < page + kPage; at += kStep) {
        addresses.insert(at);
      }
    }
  }
}

/// Each literal with the only place that can add it, or else with each place of its function that
/// adds a distance from that register: an overestimate.
void addDistances(const std::vector<Instruction>& code, const WordAt& word_at,
                  const StartOf& start_of, std::set<uint64_t>& addresses) {
  std::multimap<std::pair<uint64_t, uint8_t>, uint64_t> adders;  // by function and register
  for (const Instruction& one : code) {
    if (one.mentions.pc_plus != Mentions::kNone) {
      adders.emplace(std::pair(start_of(one.address), one.mentions.pc_plus),
                     one.address + one.mentions.pc_ahead);
    }
  }
  for (size_t i = 0; i < code.size(); ++i) {
    const Instruction& one = code[i];
    const auto word = loadsLiteral(one) ? word_at(one.mentions.numbers[0]) : std::nullopt;
    if (!word) {
      continue;
    }
    if (const Instruction* only = onlyAdderOf(code, i)) {
      addresses.insert(static_cast<uint32_t>(only->address + only->mentions.pc_ahead + *word));
      continue;
    }
    const auto [begin, end] = adders.equal_range({start_of(one.address), one.mentions.literal_to});
    for (auto adder = begin; adder != end; ++adder) {
      addresses.insert(static_cast<uint32_t>(adder->second + *word));
    }
  }
}

}  // namespace

std::set<uint64_t> addressesIn(const std::vector<Instruction>& code, uint64_t offsets,
                               const WordAt& word_at, const StartOf& start_of) {
  std::set<uint64_t> addresses;
  for (const Instruction& one : code) {
    // The target of a call or jump is not a pointer.
    const bool jumps = one.flow == Flow::Call || one.flow == Flow::Jump || one.flow == Flow::JumpIf;
    for (uint8_t i = 0; i < one.mentions.count && !jumps && !loadsLiteral(one); ++i) {
      addresses.insert(one.mentions.numbers[i]);
      if (offsets != 0) {
        addresses.insert(static_cast<uint32_t>(offsets + one.mentions.numbers[i]));
      }
    }
  }
  addDistances(code, word_at, start_of, addresses);
  addPages(code, addresses);
  return addresses;
}

std::set<uint64_t> distancesIn(const std::vector<Instruction>& code) {
  std::set<uint64_t> distances;
  for (size_t i = 0; i < code.size(); ++i) {
    if (loadsLiteral(code[i]) && adderOf(code, i) != nullptr) {
      distances.insert(code[i].mentions.numbers[0]);
    }
  }
  return distances;
}

}  // namespace glider::codegen
