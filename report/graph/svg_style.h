// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>

namespace glider::report {

/// Colours only repeat the meaning of shapes: a picture printed in black and white has the same
/// information. Dark on a dark screen, never on paper.
constexpr std::string_view kSvgStyle = R"svg(<style>
text { font: 12px "DejaVu Sans Mono", Menlo, Consolas, "Liberation Mono", monospace; fill: #1b2733; white-space: pre }
.title { font-size: 20px; font-weight: bold }
.name { font-size: 15px; font-weight: bold }
.number { font-weight: bold }
.muted { fill: #566573 }
.never { fill: #6b7680; text-decoration: line-through }
.note { fill: #6b7680; font-style: italic }
.paper { fill: #ffffff }
.box { fill: #eef3f8; stroke: #34495e; stroke-width: 1.3 }
.always { fill: #fdf6e3; stroke: #8a6d1f; stroke-width: 1.3; stroke-dasharray: 6 3 }
.unreached { fill: url(#hatch); stroke: #8895a1; stroke-width: 1.3; stroke-dasharray: 2 3 }
.hatch { stroke: #d5dbe1; stroke-width: 3 }
.deepest { stroke-width: 4 }
.line { fill: none; stroke: #34495e; stroke-width: 1.4 }
.interrupt { stroke-dasharray: 7 4; stroke: #8a6d1f }
.lost { stroke-dasharray: 2 4; stroke: #8895a1 }
.call { stroke-width: 5 }
.core { fill: none; stroke: #ffffff; stroke-width: 2.4 }
.deep { stroke-width: 9 }
.head { fill: #34495e; stroke: none }
.end { fill: #ffffff; stroke: #34495e; stroke-width: 1.6 }
@media screen and (prefers-color-scheme: dark) {
  text { fill: #e4ebf1 }
  .muted { fill: #9fb0be }
  .never, .note { fill: #8b98a3 }
  .paper { fill: #10161c }
  .box { fill: #1d2833; stroke: #9db4c8 }
  .always { fill: #2b2616; stroke: #d3b560 }
  .unreached { stroke: #6b7680 }
  .hatch { stroke: #27313b }
  .line { stroke: #9db4c8 }
  .interrupt { stroke: #d3b560 }
  .lost { stroke: #6b7680 }
  .core { stroke: #10161c }
  .head { fill: #9db4c8 }
  .end { fill: #10161c; stroke: #9db4c8 }
}
</style>
<defs><pattern id="hatch" width="8" height="8" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><path class="hatch" d="M0 0V8"/></pattern></defs>
)svg";

}  // namespace glider::report
