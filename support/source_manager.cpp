// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/source_manager.h"

#include <algorithm>
#include <utility>

namespace glider::support {

uint32_t SourceManager::add(std::string name, std::string text) {
  File file{std::move(name), std::move(text), {0}};
  for (uint32_t i = 0; i < file.text.size(); ++i) {
    if (file.text[i] == '\n') {
      file.line_starts.push_back(i + 1);
    }
  }
  files_.push_back(std::move(file));
  return static_cast<uint32_t>(files_.size() - 1);
}

std::string_view SourceManager::text(SourceRange range) const {
  return std::string_view(text(range.file)).substr(range.begin, range.end - range.begin);
}

LineColumn SourceManager::place(uint32_t file, uint32_t offset) const {
  const File& f = files_.at(file);
  offset = std::min<uint32_t>(offset, static_cast<uint32_t>(f.text.size()));
  auto next = std::upper_bound(f.line_starts.begin(), f.line_starts.end(), offset);
  const auto line = static_cast<uint32_t>(next - f.line_starts.begin());
  uint32_t column = 1;
  for (uint32_t i = f.line_starts[line - 1]; i < offset; ++i) {
    const bool continuation = (static_cast<unsigned char>(f.text[i]) & 0xC0U) == 0x80U;
    column += continuation ? 0 : 1;
  }
  return {line, column};
}

std::string_view SourceManager::line(uint32_t file, uint32_t line) const {
  const File& f = files_.at(file);
  if (line == 0 || line > f.line_starts.size()) {
    return {};
  }
  const uint32_t begin = f.line_starts[line - 1];
  size_t end = f.text.find('\n', begin);
  end = end == std::string::npos ? f.text.size() : end;
  if (end > begin && f.text[end - 1] == '\r') {
    --end;
  }
  return std::string_view(f.text).substr(begin, end - begin);
}

}  // namespace glider::support
