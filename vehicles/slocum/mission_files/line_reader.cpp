// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/mission_files/line_reader.h"

#include "support/diagnostics/ids/vehicle.h"

#include <charconv>
#include <cmath>

namespace glider::slocum {

namespace {

constexpr size_t kLargestFile = size_t{1} << 20U;

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

bool isNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

std::string lowerCase(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') {
      c = static_cast<char>(c - 'A' + 'a');
    }
  }
  return out;
}

std::string quoted(std::string_view text) {
  constexpr size_t kMost = 40;
  if (text.empty()) {
    return "the end of the line";
  }
  std::string shown(text.substr(0, kMost));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) {
      c = '?';
    }
  }
  return "`" + shown + (text.size() > kMost ? "…`" : "`");
}

LineReader::LineReader(const support::SourceManager& sources, uint32_t file,
                       support::DiagnosticEngine& diagnostics)
    : text_(sources.text(file)), file_(file), diagnostics_(diagnostics) {}

bool LineReader::acceptable() {
  const char* why = nullptr;
  if (text_.size() > kLargestFile) {
    why = "it is larger than 1 MiB";
  } else if (text_.find('\0') != std::string::npos) {
    why = "it contains a zero byte";
  }
  if (why != nullptr) {
    diagnostics_.report(support::diagnostics::missionFileUnreadable, {file_, 0, 0}, why);
  }
  return why == nullptr;
}

Piece LineReader::trimmed(size_t begin, size_t end) const {
  while (begin < end && isBlank(text_[begin])) {
    ++begin;
  }
  while (end > begin && isBlank(text_[end - 1])) {
    --end;
  }
  return {std::string_view(text_).substr(begin, end - begin),
          {file_, static_cast<uint32_t>(begin), static_cast<uint32_t>(end)}};
}

std::optional<Piece> LineReader::next() {
  while (position_ < text_.size()) {
    const size_t begin = position_;
    const size_t line_end = std::min(text_.find('\n', begin), text_.size());
    const size_t content_end = std::min(text_.find('#', begin), line_end);
    position_ = line_end + 1;
    const Piece line = trimmed(begin, content_end);
    if (!line.empty()) {
      return line;
    }
  }
  return std::nullopt;
}

std::vector<Piece> LineReader::words(Piece line) const {
  std::vector<Piece> out;
  size_t at = line.range.begin;
  while (at < line.range.end) {
    size_t end = at;
    while (end < line.range.end && !isBlank(text_[end])) {
      ++end;
    }
    if (end > at) {
      out.push_back(trimmed(at, end));
    }
    at = end + 1;
  }
  return out;
}

std::optional<double> LineReader::number(Piece piece) {
  double value = 0;
  std::string_view digits = piece.text;
  if (digits.size() > 1 && digits.front() == '+' && digits[1] != '-') {
    digits.remove_prefix(1);
  }
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) {
    diagnostics_.report(support::diagnostics::badMissionNumber, piece.range,
                        piece.text.substr(0, 40));
    return std::nullopt;
  }
  return value;
}

std::optional<Setting> LineReader::setting(Piece rest) {
  const auto refuse = [&](const char* wanted, Piece found) -> std::optional<Setting> {
    diagnostics_.report(support::diagnostics::missionFileSyntax, found.range, wanted,
                        quoted(found.text));
    return std::nullopt;
  };
  size_t at = rest.range.begin;
  while (at < rest.range.end && isNameCharacter(text_[at])) {
    ++at;
  }
  const Piece name = trimmed(rest.range.begin, at);
  const Piece after_name = trimmed(at, rest.range.end);
  if (name.empty()) {
    return refuse("a name", after_name);
  }
  if (after_name.empty() || after_name.text.front() != '(') {
    return refuse("`(unit)`", after_name);
  }
  const size_t close = after_name.text.find(')');
  if (close == std::string_view::npos) {
    return refuse("`)` after the unit", trimmed(rest.range.end, rest.range.end));
  }
  const size_t unit_begin = after_name.range.begin + 1;
  const Piece unit = trimmed(unit_begin, after_name.range.begin + close);
  const Piece value = trimmed(after_name.range.begin + close + 1, rest.range.end);
  const std::vector<Piece> parts = words(value);
  if (parts.empty()) {
    return refuse("a number", value);
  }
  if (parts.size() > 1) {
    return refuse("the end of the line after the number", parts[1]);
  }
  const std::optional<double> read = number(value);
  if (!read) {
    return std::nullopt;
  }
  return Setting{lowerCase(name.text), std::string(unit.text), *read, name.range, value.range};
}

}  // namespace glider::slocum
