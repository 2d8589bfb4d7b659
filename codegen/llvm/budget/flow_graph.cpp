// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/flow_graph.h"

#include <fmt/format.h>

#include <optional>
#include <unordered_map>
#include <utility>

namespace glider::codegen {

bool goesOn(Flow flow) {
  return flow == Flow::Next || flow == Flow::JumpIf || flow == Flow::JumpAheadIf ||
         flow == Flow::Call || flow == Flow::CallByPointer || flow == Flow::ReturnIf;
}

namespace {

/// Where an instruction may lead; empty if that is unknown.
std::optional<std::vector<uint64_t>> successors(const Image& image, const Instruction& one) {
  std::vector<uint64_t> targets;
  if (one.flow == Flow::Unknown) {
    return std::nullopt;
  }
  if (one.flow == Flow::JumpByTable) {
    targets = image.tableTargets(one);
    return targets.empty() ? std::nullopt : std::optional(targets);
  }
  if (one.flow == Flow::JumpAhead || one.flow == Flow::JumpAheadIf) {
    targets = image.aheadTargets(one);
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

std::string FlowGraph::whyLost(const Image& image, uint64_t address) {
  return fmt::format("it is not known where `{}` continues at {:#x}", image.baseNameAt(address),
                     address);
}

std::expected<FlowGraph, std::string> FlowGraph::follow(const Image& image, uint64_t entry) {
  auto graph = asFarAsKnown(image, entry);
  if (graph && !graph->lost.empty()) {
    const uint32_t place = graph->instructions[*graph->lost.begin()];
    return std::unexpected(whyLost(image, image.code()[place].address));
  }
  return graph;
}

std::expected<FlowGraph, std::string> FlowGraph::asFarAsKnown(const Image& image, uint64_t entry) {
  FlowGraph graph;
  std::unordered_map<uint64_t, uint32_t> number_of;
  auto meet = [&](uint64_t address) -> std::optional<uint32_t> {
    const auto place = image.at(address);
    if (!place) {
      return std::nullopt;
    }
    const auto [known, added] =
        number_of.try_emplace(address, static_cast<uint32_t>(graph.instructions.size()));
    if (added) {
      graph.instructions.push_back(*place);
    }
    return known->second;
  };
  if (!meet(entry)) {
    return std::unexpected(whyLost(image, entry));
  }
  for (uint32_t i = 0; i < graph.instructions.size(); ++i) {
    const auto targets = successors(image, image.code()[graph.instructions[i]]);
    std::vector<uint32_t> next;
    bool known = targets.has_value();
    for (const uint64_t target : targets.value_or(std::vector<uint64_t>{})) {
      const auto node = meet(target);
      known = known && node;
      if (node) {
        next.push_back(*node);
      }
    }
    if (!known) {
      graph.lost.insert(i);
    }
    graph.next.push_back(std::move(next));
  }
  return graph;
}

}  // namespace glider::codegen
