// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace glider::report {

/// `text` with each control character (the start of an escape sequence, a line end) replaced by
/// `?`, on one line.
std::string plain(std::string_view text);
/// The number of code points in UTF-8 `text`; on a terminal each takes one column, except for East
/// Asian and combining characters.
size_t width(std::string_view text);
/// `text` cut to at most `columns` code points, the last of them `…` when something was cut.
std::string cut(std::string_view text, size_t columns);
/// `text` followed by spaces up to `columns`.
std::string padded(std::string_view text, size_t columns);
/// `text` broken at spaces into lines of at most `columns`, the second and later ones indented by
/// `indent`; a longer word is broken. Ends with a newline.
std::string wrapped(std::string_view text, size_t columns, size_t indent);
/// A duration in seconds as `41:40` or `3:02:05`.
std::string clockText(double seconds);

}  // namespace glider::report
