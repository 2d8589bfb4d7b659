// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/prediction_table.h"

#include <algorithm>

namespace glider::frontend {
namespace {

antlr4::atn::ParserATNSimulator& simulatorOf(grammar::GliderParser& reader) {
  return *reader.getInterpreter<antlr4::atn::ParserATNSimulator>();
}

}  // namespace

PredictionTable::PredictionTable(grammar::GliderParser& reader, LexemeStream& tokens)
    : ParserATNSimulator(&reader, reader.getATN(), simulatorOf(reader).decisionToDFA,
                         simulatorOf(reader).getSharedContextCache()),
      tokens_(tokens),
      types_(reader.getATN().maxTokenType + 2),
      starts_(decisionToDFA.size()) {}

size_t PredictionTable::adaptivePredict(antlr4::TokenStream* input, size_t decision,
                                        antlr4::ParserRuleContext* context) {
  // In the full mode a choice also depends on the rules around it.
  if (getPredictionMode() == antlr4::atn::PredictionMode::SLL) {
    if (const size_t chosen = known(decision)) {
      return chosen;
    }
  }
  return ParserATNSimulator::adaptivePredict(input, decision, context);
}

size_t PredictionTable::known(size_t decision) {
  Number now = start(decision);
  for (size_t k = 0; now != kUnknown; ++k) {
    const size_t type = tokens_.typeAhead(k);
    const Number next = states_[now].next[type + 1];  // the type of the end of the file is -1
    now = next == kUnknown ? follow(now, type) : next;
    if (now != kUnknown && (states_[now].chosen != 0 || !states_[now].usable)) {
      return states_[now].usable ? states_[now].chosen : 0;
    }
  }
  return 0;
}

PredictionTable::Number PredictionTable::start(size_t decision) {
  antlr4::dfa::DFA& dfa = decisionToDFA[decision];
  const bool operators = dfa.isPrecedenceDfa();
  const int level = operators ? parser->getPrecedence() : 0;
  std::vector<Number>& starts = starts_[decision];
  const auto at = static_cast<size_t>(std::max(level, 0));
  if (at >= starts.size()) {
    starts.resize(at + 1, kUnknown);
  }
  if (starts[at] == kUnknown) {
    _edgeLock.readLock();
    antlr4::dfa::DFAState* first = operators ? dfa.getPrecedenceStartState(level) : dfa.s0;
    _edgeLock.readUnlock();
    starts[at] = first == nullptr ? kUnknown : numberOf(first);
  }
  return starts[at];
}

PredictionTable::Number PredictionTable::follow(Number from, size_t type) {
  antlr4::dfa::DFAState* target = getExistingTargetState(states_[from].state, type);
  if (target == nullptr || target == ERROR.get()) {
    return kUnknown;
  }
  const Number next = numberOf(target);
  states_[from].next[type + 1] = next;
  return next;
}

PredictionTable::Number PredictionTable::numberOf(antlr4::dfa::DFAState* state) {
  const auto [row, added] = numbers_.try_emplace(state, static_cast<Number>(states_.size()));
  if (added) {
    State& known = states_.emplace_back();
    known.state = state;
    known.usable = state->predicates.empty();
    known.chosen = state->isAcceptState && known.usable ? state->prediction : 0;
    known.next.assign(types_, kUnknown);
  }
  return row->second;
}

}  // namespace glider::frontend
