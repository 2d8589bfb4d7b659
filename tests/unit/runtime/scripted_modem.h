// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

/// A modem whose words the test gives.
namespace glider::runtime::testing {

/// `$BODY*HH` and a line end.
inline std::string sentence(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) {
    sum ^= static_cast<unsigned char>(c);
  }
  char end[8];
  std::snprintf(end, sizeof end, "*%02X\r\n", sum);
  return "$" + body + end;
}

class ScriptedModem {
 public:
  /// Answers as a modem does that has nothing else to do.
  static void usual(ScriptedModem& modem, const std::string& body) {
    if (body.starts_with("CCCFG,")) {
      modem.say("CACFG," + body.substr(6));
    } else if (body.starts_with("CCCYC,")) {
      modem.say("CACYC," + body.substr(6));
      modem.say("CADRQ,120000," + body.substr(8, body.find(',', 8) - 8) + ",0,0,32,1");
    } else if (body.starts_with("CCTXD,")) {
      modem.say("CATXF,32");
    }
  }

  /// What it does with a sentence of the host; of one with a wrong sum it gets "?".
  std::function<void(ScriptedModem&, const std::string&)> answer = usual;
  int32_t takes = 1000;            ///< bytes at once, of those that are written; negative: a status
  bool is_gone = false;            ///< reads find the line closed
  std::vector<std::string> heard;  ///< bodies of the host's sentences

  void say(const std::string& body) { bytes(sentence(body)); }
  void bytes(const std::string& bytes) { out_ += bytes; }
  [[nodiscard]] size_t unread() const { return out_.size(); }
  /// Those that begin so.
  [[nodiscard]] std::vector<std::string> heardOf(const std::string& name) const {
    std::vector<std::string> found;
    std::ranges::copy_if(heard, std::back_inserter(found),
                         [&](const std::string& body) { return body.starts_with(name); });
    return found;
  }

  GliderByteStream stream() {
    return {this,
            [](void* self, uint8_t* bytes, uint32_t capacity) {
              return static_cast<ScriptedModem*>(self)->read(bytes, capacity);
            },
            [](void* self, const uint8_t* bytes, uint32_t count) {
              return static_cast<ScriptedModem*>(self)->write(bytes, count);
            }};
  }

 private:
  int32_t read(uint8_t* bytes, uint32_t capacity) {
    const size_t count = std::min<size_t>(capacity, out_.size());
    std::copy_n(out_.begin(), count, bytes);
    out_.erase(0, count);
    return count == 0 && is_gone ? kGliderStreamClosed : static_cast<int32_t>(count);
  }

  int32_t write(const uint8_t* bytes, uint32_t count) {
    if (takes < 0) {
      return takes;
    }
    const auto taken = std::min(count, static_cast<uint32_t>(takes));
    in_.append(bytes, bytes + taken);
    for (size_t end = in_.find("\r\n"); end != std::string::npos; end = in_.find("\r\n")) {
      const std::string line = in_.substr(0, end + 2);
      in_.erase(0, end + 2);
      const std::string body = line.size() > 6 ? line.substr(1, line.size() - 6) : "";
      heard.push_back(sentence(body) == line ? body : "?");
      answer(*this, heard.back());
    }
    return static_cast<int32_t>(taken);
  }

  std::string in_, out_;
};

}  // namespace glider::runtime::testing
