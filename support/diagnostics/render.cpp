// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/diagnostics/render.h"

#include "support/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace glider::support {
namespace {

struct Palette {
  std::string_view bold, error, warning, note, caret, reset;
};
constexpr Palette kPlain{};
constexpr Palette kColour{"\x1b[1m",    "\x1b[1;31m", "\x1b[1;35m",
                          "\x1b[1;36m", "\x1b[1;32m", "\x1b[0m"};

std::string_view colourOf(Severity severity, const Palette& p) {
  return severity == Severity::Error ? p.error : severity == Severity::Warning ? p.warning : p.note;
}

std::string excerpt(const SourceManager& sources, SourceRange range, const Palette& p) {
  constexpr size_t kLongestLine = 400;
  const LineColumn begin = sources.place(range.file, range.begin);
  const LineColumn end = sources.place(range.file, std::max(range.end, range.begin));
  const std::string_view line = sources.line(range.file, begin.line);
  if (line.empty() || line.size() > kLongestLine) {
    return {};
  }
  const uint32_t width = end.line == begin.line && end.column > begin.column
                             ? end.column - begin.column
                         : end.line > begin.line && line.size() + 1 > begin.column
                             ? static_cast<uint32_t>(line.size()) + 1 - begin.column
                             : 1;
  return fmt::format("{:>5} | {}\n      | {}{}{}{}{}\n", begin.line, printable(line),
                     std::string(begin.column - 1, ' '), p.caret, "^", std::string(width - 1, '~'),
                     p.reset);
}

std::string block(const SourceManager& sources, SourceRange range, Severity severity,
                  std::string_view message, std::string_view tag, const Palette& p) {
  std::string where;
  if (range.valid()) {
    const LineColumn at = sources.place(range.file, range.begin);
    where = fmt::format("{}:{}:{}: ", sources.name(range.file), at.line, at.column);
  }
  std::string out = fmt::format("{}{}{}{}{}: {}{}{}{}\n", p.bold, where, colourOf(severity, p),
                                word(severity), p.reset, p.bold, printable(message), p.reset, tag);
  return range.valid() ? out + excerpt(sources, range, p) : out;
}

}  // namespace

std::string render(const DiagnosticEngine& diagnostics, const SourceManager& sources, bool colour) {
  const Palette& p = colour ? kColour : kPlain;
  std::string out;
  for (const Diagnostic& d : diagnostics.sorted()) {
    const std::string tag = fmt::format(" [{} {}]", code(d.id), catalogueRow(d.id).slug);
    out += block(sources, d.range, d.severity, d.message, tag, p);
    if (!d.hint.empty()) {
      out += fmt::format("      = {}hint{}: {}\n", p.note, p.reset, printable(d.hint));
    }
    for (const DiagnosticNote& note : d.notes) {
      out += block(sources, note.range, Severity::Note, note.message, "", p);
    }
  }
  return out;
}

}  // namespace glider::support
