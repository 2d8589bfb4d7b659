// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glider::driver {

/// What `glidercc build` writes, in the order of the stages.
enum class Emit : uint8_t { Ast, Symbols, Ir, Header, Llvm, Asm, Obj, Exe };

/// A value of `--emit`, and how the names of such files end.
struct EmitRow {
  std::string_view word;
  Emit emit;
  std::string_view suffix;
};
inline constexpr EmitRow kEmits[] = {
    {"ast", Emit::Ast, ".ast"},  {"symbols", Emit::Symbols, ".symbols.json"},
    {"ir", Emit::Ir, ".ir"},     {"header", Emit::Header, ".h"},
    {"llvm", Emit::Llvm, ".ll"}, {"asm", Emit::Asm, ".s"},
    {"obj", Emit::Obj, ".o"},    {"exe", Emit::Exe, ""}};

inline bool needsTarget(Emit emit) {
  return emit >= Emit::Llvm;
}

/// The values of `--emit`.
inline std::vector<std::string> emitWords() {
  std::vector<std::string> words;
  for (const EmitRow& row : kEmits) {
    words.emplace_back(row.word);
  }
  return words;
}

inline Emit emitOf(std::string_view word) {
  return std::ranges::find(kEmits, word, &EmitRow::word)->emit;
}

inline std::string_view suffixOf(Emit emit) {
  return std::ranges::find(kEmits, emit, &EmitRow::emit)->suffix;
}

}  // namespace glider::driver
