// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/page.h"

#include "report/downsample.h"
#include "report/facts_json.h"
#include "report/figures.h"
#include "report/warnings.h"

namespace glider::report {

namespace {

// Both have 3 bytes in UTF-8 and differ in the last.
constexpr std::string_view kLineSeparator = "\xe2\x80\xa8";
constexpr std::string_view kParagraphSeparator = "\xe2\x80\xa9";

}  // namespace

std::string escapeForScript(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  for (size_t i = 0; i < json.size(); ++i) {
    const std::string_view three = json.substr(i, 3);
    if (json[i] == '<') {
      out += "\\u003c";
    } else if (three == kLineSeparator || three == kParagraphSeparator) {
      out += three == kLineSeparator ? "\\u2028" : "\\u2029";
      i += 2;
    } else {
      out += json[i];
    }
  }
  return out;
}

std::string escapeHtml(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string renderPage(const support::Trace& trace,
                       const std::vector<support::Diagnostic>& reported) {
  const std::string figures = figuresToJson(flightFigures(trace));
  const std::string flight = support::traceToJson(downsampled(trace, kPageRows));
  std::string page(kPageParts[0]);
  page += escapeHtml(flightTitle(trace));
  page += kPageParts[1];
  const std::string warnings = warningsToJson(reported, flightNotes(trace));
  page += escapeForScript("{\"figures\":" + figures + ",\"warnings\":" + warnings +
                          ",\"facts\":" + factsToJson(trace) +
                          ",\"yos\":" + yosToJson(yosOf(trace)) + ",\"trace\":" + flight + "}");
  page += kPageParts[2];
  return page;
}

}  // namespace glider::report
