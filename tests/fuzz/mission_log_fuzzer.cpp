// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/frame.h"
#include "logs/render.h"

#include <cstdlib>
#include <cstring>

namespace {

using glider::logs::LogEntry;

/// Reads and shows them; returns how many characters that were.
size_t feed(std::string_view bytes) {
  size_t shown = 0;
  const auto damage = glider::logs::readLog(bytes, [&](const LogEntry& entry) {
    const std::string text = glider::logs::textLine(entry);
    shown += text.size() + glider::logs::csvLines(entry).size();
    if (text.find('\x1b') != std::string::npos || text.find('\n') + 1 != text.size()) {
      std::abort();  // a log must not command the terminal
    }
  });
  if (damage.records > bytes.size()) {
    std::abort();
  }
  return shown;
}

/// The bytes cut into records of right form: {length, payload…}.
std::string asRecords(const uint8_t* bytes, size_t count) {
  std::string log;
  glider::hooks::Frame frame;
  frame.type = glider::hooks::MessageType::Log;
  for (size_t at = 0; at < count; at += frame.size + size_t{1}) {
    const size_t left = count - at - 1;
    frame.size = static_cast<uint16_t>(std::min<size_t>(bytes[at] * size_t{2}, left));
    std::memcpy(frame.payload, bytes + at + 1, frame.size);
    ++frame.sequence;
    uint8_t encoded[glider::hooks::kMostEncodedBytes];
    const uint32_t size = glider::hooks::encodeFrame(frame, encoded);
    log.append(reinterpret_cast<const char*>(encoded), size);
  }
  return log;
}

}  // namespace

// libFuzzer: target mission_log_fuzzer; see scripts/soak/fuzz_hooks.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
  (void)feed({reinterpret_cast<const char*>(bytes), count});
  // Behind a right head, so that what follows is read.
  static constexpr uint8_t kHead[] = {4, 1, 1, 'm', 0};
  std::string log = asRecords(kHead, sizeof kHead);
  log += asRecords(bytes, count);
  (void)feed(log);
  return 0;
}
