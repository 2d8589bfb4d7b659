// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/symbols.h"
#include "support/source_manager.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glider::frontend {

/// `depth: length` or `pitch: angle = 26 deg`; the type is empty if it is missing.
struct OutlineFormal {
  support::SourceRange name;
  std::string type;
  support::SourceRange usual = {};  ///< the argument if none is given; not valid: there is none
};

/// The part of a declaration before its value or body.
struct OutlineDeclaration {
  SymbolKind kind = SymbolKind::Mission;
  support::SourceRange name;
  support::SourceRange where;    ///< up to where its end is certain: for states up to the body
  std::optional<uint32_t> body;  ///< the one that contains it
  bool external = false;         ///< after `extern`
  std::string size;              ///< of an array: "[8]"
  bool typed = false;            ///< it has a colon
  std::string type;              ///< the type after the colon, without spaces; empty: missing
  bool parenthesised = false;
  bool formals_broken = false;
  std::vector<OutlineFormal> formals;
  std::vector<support::SourceRange> usual_names;  ///< that usual arguments use
};

/// The text of a state, profile or route from its keyword to its `end`, or to what comes next if
/// that is missing.
struct OutlineBody {
  support::SourceRange where;
  uint32_t declaration = 0;
};

/// What the place of a name says about its meaning.
enum class Naming : uint8_t { Value, Function, Command, State, Behaviour, Platform };

/// A name that is used.
struct OutlineUse {
  Naming naming = Naming::Value;
  support::SourceRange where;
  std::optional<uint32_t> body;  ///< the one that contains it
};

/// The declarations of a file and the names that it uses, in the order of the text.
struct Outline {
  std::vector<OutlineDeclaration> declarations;
  std::vector<OutlineBody> bodies;
  std::vector<OutlineUse> uses;
};

/// Reads only the words of the text, not the grammar, so that an error affects only the declaration
/// that contains it.
Outline outlineOf(const support::SourceManager& sources, uint32_t file);

}  // namespace glider::frontend
