// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/micro_modem/messages.h"
#include "hooks/protocol/sentence_reader.h"

#include <stdint.h>

namespace glider::hooks::micro_modem {

using hooks::SentenceReader;

/// The longest that encode writes of a sentence without a text: a frame of 32 bytes, 86.
inline constexpr uint32_t kMostSentence = 96;

// For each sentence of messages.h:
//
// encode writes a whole sentence, from its `$` to its line end, into `bytes`, of which there are
// `capacity`. It returns the size of the sentence; 0 if it does not fit there, if a number is
// greater than messages.h says, or if a text holds what would begin or end a sentence.
//
// decode takes the message out of the body of a sentence (SentenceReader::text). It returns false,
// and the message has no meaning, for another sentence, or if a field is not what it should be
// there (README.md, rules M4 to M8).
#define MODEM_SENTENCE(name)                                                          \
  [[nodiscard]] uint32_t encode(const name& message, char* bytes, uint32_t capacity); \
  [[nodiscard]] bool decode(const Text& body, name& message);
#include "hooks/micro_modem/messages.def"
#undef MODEM_SENTENCE

}  // namespace glider::hooks::micro_modem
