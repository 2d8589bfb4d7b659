// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"

namespace glider::frontend::phrases {

size_t leg(Phrase& phrase) {
  const auto isName = [&](size_t k, std::initializer_list<std::string_view> words) {
    return phrase.type(k) == GliderLexer::NAME &&
           std::ranges::find(words, phrase.text(k)) != words.end();
  };
  if (phrase.before() != GliderLexer::COMMA || !isName(0, {"this", "last"}) ||
      !isName(1, {"leg", "dive", "climb"}) || phrase.type(2) != GliderLexer::RPAREN) {
    return 0;
  }
  phrase.put(phrase.whole(0, 2, GliderLexer::NAME));
  return 2;
}

}  // namespace glider::frontend::phrases
