// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/dock/dock_line.h"

#include <algorithm>
#include <array>

namespace glider::slocum {

bool DockLine::isEcho(const std::string& body) {
  const auto found = std::ranges::find(said_, body);
  if (found == said_.end()) {
    return false;
  }
  said_.erase(found);
  ++counts_.echoes;
  return true;
}

/// True if the byte ends a good sentence.
bool DockLine::take(uint8_t byte) {
  ++counts_.bytes;
  in_sentence_ += byte == '\r' || byte == '\n' ? 0 : 1;
  const bool ends = reader_.push(byte);
  if (ends) {
    const uint64_t own = reader_.size() + 4;  // with `$`, `*` and the sum
    const bool first = counts_.sentences++ == 0;
    counts_.stray += first || in_sentence_ < own ? 0 : in_sentence_ - own;
    bad_before_ = first ? reader_.bad() : bad_before_;
    in_sentence_ = 0;
  }
  if (in_sentence_ > 2 * hooks::extctl::kMostBody) {  // no sentence is so long
    counts_.stray += counts_.sentences == 0 ? 0 : in_sentence_;
    in_sentence_ = 0;
  }
  counts_.damaged = counts_.sentences == 0 ? 0 : reader_.bad() - bad_before_;
  return ends;
}

std::vector<std::string> DockLine::hear() {
  flush();
  std::vector<std::string> heard;
  std::array<uint8_t, 512> bytes;
  constexpr int kMostReads = 16;  // a line full of noise must not keep the check from its time
  for (int reads = 0; reads < kMostReads && !gone_; ++reads) {
    const int32_t count =
        host_.line.read(host_.line.self, bytes.data(), static_cast<uint32_t>(bytes.size()));
    gone_ = count < 0;
    for (int32_t i = 0; i < count; ++i) {
      beginning_ += beginning_.size() < kMostBeginning
                        ? std::string(1, static_cast<char>(bytes.at(static_cast<size_t>(i))))
                        : "";
      if (take(bytes.at(static_cast<size_t>(i)))) {
        std::string body(reader_.body(), reader_.size());
        if (!isEcho(body)) {
          heard.push_back(std::move(body));
        }
      }
    }
    if (count <= 0) {
      break;
    }
  }
  return heard;
}

void DockLine::say(const std::string& body) {
  constexpr size_t kMostSaid = 64, kMostQueued = 8192;
  std::array<char, hooks::extctl::kMostBody + 16> text;
  hooks::extctl::SentenceWriter writer(text.data(), static_cast<uint32_t>(text.size()));
  writer.put(body.c_str());
  const uint32_t size = writer.end();
  if (out_.size() > kMostQueued) {
    return;  // the device takes nothing: what it does not take is lost, as on the vehicle
  }
  out_.append(text.data(), size);
  ++counts_.sent_sentences;
  said_.push_back(body);
  if (said_.size() > kMostSaid) {
    said_.pop_front();
  }
  flush();
}

void DockLine::flush() {
  while (!out_.empty() && !gone_) {
    const int32_t taken =
        host_.line.write(host_.line.self, reinterpret_cast<const uint8_t*>(out_.data()),
                         static_cast<uint32_t>(out_.size()));
    gone_ = taken < 0;
    if (taken <= 0) {
      return;
    }
    counts_.sent_bytes += static_cast<uint64_t>(taken);
    out_.erase(0, static_cast<size_t>(taken));
  }
}

void DockLine::restart() {
  (void)hear();
  counts_ = {};
  in_sentence_ = 0;
}

}  // namespace glider::slocum
