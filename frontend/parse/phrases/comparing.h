// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/phrases/phrase.h"

namespace glider::frontend::phrases {

/// `is above`, `no more than`, `must be at least`: words that compare, with the sign they mean.
struct ComparingPhrase {
  size_t tokens = 0;  ///< 0: there are none
  std::string_view sign;
  uint32_t type = 0;
  bool changes = false;  ///< they say that a value comes there
};
ComparingPhrase comparingAt(const Phrase& phrase, size_t k);

}  // namespace glider::frontend::phrases
