// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/budget/flow_graph.h"

#include <fmt/format.h>

#include <optional>
#include <unordered_map>
#include <utility>

namespace glider::codegen {
namespace {

bool goesOn(Flow flow) {
  return flow == Flow::Next || flow == Flow::JumpIf || flow == Flow::Call ||
         flow == Flow::CallByPointer || flow == Flow::ReturnIf;
}

/// Where an instruction may lead; nothing if nobody can tell.
std::optional<std::vector<uint64_t>> successors(const Image& image, const Instruction& one) {
  std::vector<uint64_t> targets;
  if (one.flow == Flow::Unknown) {
    return std::nullopt;
  }
  if (one.flow == Flow::JumpByTable) {
    targets = image.tableTargets(one);
    return targets.empty() ? std::nullopt : std::optional(targets);
  }
  if (goesOn(one.flow)) {
    targets.push_back(one.address + one.size);
  }
  if (one.flow == Flow::Jump || one.flow == Flow::JumpIf) {
    targets.push_back(one.target);
  }
  return targets;
}

}  // namespace

std::expected<FlowGraph, std::string> FlowGraph::follow(const Image& image, uint64_t entry) {
  FlowGraph graph;
  std::unordered_map<uint64_t, uint32_t> number_of;
  auto meet = [&](uint64_t address) -> std::optional<uint32_t> {
    const auto [known, added] =
        number_of.try_emplace(address, static_cast<uint32_t>(graph.instructions.size()));
    if (added) {
      const auto place = image.at(address);
      if (!place) {
        return std::nullopt;
      }
      graph.instructions.push_back(*place);
    }
    return known->second;
  };
  auto lost = [&](uint64_t address) {
    return std::unexpected(fmt::format("nobody can tell where `{}` goes on at {:#x}",
                                       image.symbolAt(address), address));
  };
  if (!meet(entry)) {
    return lost(entry);
  }
  for (uint32_t i = 0; i < graph.instructions.size(); ++i) {
    const Instruction& one = image.code()[graph.instructions[i]];
    const auto targets = successors(image, one);
    if (!targets) {
      return lost(one.address);
    }
    std::vector<uint32_t> next;
    for (const uint64_t target : *targets) {
      const auto node = meet(target);
      if (!node) {
        return lost(one.address);
      }
      next.push_back(*node);
    }
    graph.next.push_back(std::move(next));
  }
  return graph;
}

}  // namespace glider::codegen
