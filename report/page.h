// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/diagnostic.h"
#include "support/trace/trace.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glider::report {

/// The greatest number of rows in a page (a day and a half of 4 s cycles); a longer flight is
/// downsampled to about as many.
inline constexpr size_t kPageRows = 32768;

/// The built page, divided where the title and the flight's data are inserted. Written by
/// report/page/build.mjs.
extern const std::array<std::string_view, 3> kPageParts;

/// The whole page for `trace`, as HTML, with what went wrong at its top.
std::string renderPage(const support::Trace& trace,
                       const std::vector<support::Diagnostic>& reported = {});

/// Escapes `json` for use inside a script element: no `<`, and no line separator that ends a line
/// in older JavaScript. Only for JSON, where these characters only occur in strings.
std::string escapeForScript(std::string_view json);
/// `text` as the content of an HTML element or a quoted attribute.
std::string escapeHtml(std::string_view text);

}  // namespace glider::report
