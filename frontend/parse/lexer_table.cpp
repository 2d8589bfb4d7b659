// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/lexer_table.h"

#include <algorithm>

namespace glider::frontend {

LexerTable::LexerTable(grammar::GliderLexer& lexer)
    : LexerATNSimulator(
          lexer.getATN(), lexer.getInterpreter<antlr4::atn::LexerATNSimulator>()->_decisionToDFA,
          lexer.getInterpreter<antlr4::atn::LexerATNSimulator>()->getSharedContextCache()) {}

LexerTable::Number LexerTable::numberOf(antlr4::dfa::DFAState* state) {
  const auto [row, added] = numbers_.try_emplace(state, static_cast<Number>(states_.size()));
  if (!added) {
    return row->second;
  }
  State& known = states_.emplace_back();
  known.state = state;
  known.ends = state->isAcceptState;
  known.next.fill(kUnknown);
  if (state->lexerActionExecutor) {
    const auto actions = state->lexerActionExecutor->getLexerActions();
    known.skipped = true;
    known.usable = std::ranges::all_of(actions, [](const auto& action) {
      return action->getActionType() == antlr4::atn::LexerActionType::SKIP;
    });
  }
  return row->second;
}

LexerTable::Number LexerTable::start() {
  if (start_ == kUnknown) {
    _stateLock.readLock();
    antlr4::dfa::DFAState* first = _decisionToDFA[antlr4::Lexer::DEFAULT_MODE].s0;
    _stateLock.readUnlock();
    start_ = first == nullptr ? kUnknown : numberOf(first);
  }
  return start_;
}

LexerTable::Number LexerTable::follow(Number from, uint8_t byte) {
  antlr4::dfa::DFAState* target = getExistingTargetState(states_[from].state, byte);
  if (target == nullptr) {
    return kUnknown;
  }
  const Number next = target == ERROR.get() ? kNone : numberOf(target);
  states_[from].next[byte] = next;
  return next;
}

std::optional<LexerTable::Found> LexerTable::tokenAt(std::string_view text, size_t at) {
  Number now = start();
  Number last = kUnknown;  // the state in which the longest token so far ends
  size_t end = at;
  // The end of the text may end a token in a way of its own: that is left to ANTLR.
  for (size_t i = at; now != kUnknown && i < text.size(); ++i) {
    const auto byte = static_cast<uint8_t>(text[i]);
    if (byte >= kBytes) {
      return std::nullopt;
    }
    Number next = states_[now].next[byte];
    if (next == kUnknown) {
      next = follow(now, byte);
    }
    if (next == kNone) {
      if (last == kUnknown || !states_[last].usable) {
        return std::nullopt;
      }
      const State& final = states_[last];
      return Found{final.skipped ? 0 : static_cast<uint32_t>(final.state->prediction), end};
    }
    now = next;
    if (now != kUnknown && states_[now].ends) {
      last = now;
      end = i + 1;
    }
  }
  return std::nullopt;
}

}  // namespace glider::frontend
