// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/extctl/sentence.h"
#include "hooks/protocol/decimal.h"
#include "runtime/extctl/reported.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

namespace {

using namespace glider::hooks::extctl;
using glider::runtime::extctl::Reported;

/// What a program does with what arrives at its port.
void feed(std::string_view bytes, Reported& reported) {
  SentenceReader reader;
  for (const char c : bytes) {
    if (!reader.push(static_cast<uint8_t>(c))) {
      continue;
    }
    if (reader.size() > kMostBody) {
      std::abort();
    }
    if (reader.size() > 3 && std::memcmp(reader.body(), "SD,", 3) == 0) {
      (void)reported.take(reader.body() + 3, reader.size() - 3);
    }
  }
  double value = 0;
  for (uint32_t i = 0; i < kMostSensors; ++i) {
    if (reported.takeReport(i, &value) && std::isinf(value)) {
      std::abort();  // no double: unknown
    }
  }
}

/// The lines of `text` as reports with right sums.
std::string asReports(std::string_view text) {
  std::string line, out;
  char sentence[1100];
  for (size_t at = 0; at <= text.size(); ++at) {
    if (at < text.size() && text[at] != '\n' && line.size() < 900) {
      line += text[at];
      continue;
    }
    SentenceWriter writer(sentence, sizeof sentence);
    writer.put("SD,");
    writer.put(line.c_str());
    out.append(sentence, writer.end());
    line.clear();
  }
  return out;
}

/// What was read and is written again is read as the same.
void checkNumber(std::string_view text) {
  double value = 0;
  if (!glider::hooks::readDecimal(text.data(), static_cast<uint32_t>(text.size()), &value)) {
    return;
  }
  char written[glider::hooks::kMostDecimal];
  if (glider::hooks::writeDecimal(value, written) > glider::hooks::kMostDecimal) {
    std::abort();
  }
  const double once = glider::hooks::asSixDecimals(value);
  if (once == once && glider::hooks::asSixDecimals(once) != once) {
    std::abort();
  }
}

}  // namespace

// libFuzzer: target port_fuzzer; see scripts/soak/fuzz_hooks.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), count);
  Reported reported(kMostSensors);
  feed(text, reported);
  feed(asReports(text), reported);
  checkNumber(text);
  return 0;
}
