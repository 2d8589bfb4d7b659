// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>

namespace glider::report {

/// For A4 and for a screen. The names differ from those of report/graph/svg_style.h, which apply to
/// the whole page too.
constexpr std::string_view kBriefStyle = R"css(<style>
@page { size: A4; margin: 13mm 14mm 15mm; @bottom-right { content: counter(page) " / " counter(pages); font: 8pt sans-serif } }
* { box-sizing: border-box }
body { font: 9pt/1.3 "DejaVu Sans", "Liberation Sans", Arial, Helvetica, sans-serif; color: #1b2733; background: #ffffff; margin: 0 auto; max-width: 182mm }
@media screen { body { padding: 8mm 4mm } }
h1 { font-size: 17pt; margin: 0 }
h2 { font-size: 11.5pt; margin: 3mm 0 1mm; padding-bottom: .5mm; border-bottom: .3mm solid #34495e; break-after: avoid }
h3 { font-size: 10pt; margin: 2.2mm 0 .6mm; break-after: avoid }
h3 small { font-weight: normal; font-size: 9pt }
p { margin: 1mm 0; orphans: 3; widows: 3 }
ul, ol { margin: .6mm 0 .6mm; padding-left: 5.5mm }
li { break-inside: avoid }
code { font: 8.2pt "DejaVu Sans Mono", "Liberation Mono", Menlo, Consolas, monospace; background: #eef3f8; border-radius: .6mm; padding: 0 .6mm; overflow-wrap: break-word; -webkit-print-color-adjust: exact; print-color-adjust: exact }
table { border-collapse: collapse; width: 100%; font-size: 8.4pt; margin: 1mm 0 }
th { text-align: left; border-bottom: .3mm solid #8895a1 }
th, td { padding: .5mm 2mm .5mm 0; vertical-align: top }
td { border-bottom: .1mm solid #d5dbe1; overflow-wrap: break-word }
tr { break-inside: avoid }
thead { display: table-header-group }
figure { margin: 2mm 0; text-align: center; break-inside: avoid }
figure svg { max-width: 100%; max-height: 95mm; height: auto; width: auto }
.file { color: #566573; margin: .5mm 0 2mm }
.hint { color: #566573; font-size: 8.6pt }
.state { break-inside: avoid }
.bad { border: .7mm solid #a61b1b; padding: 1.2mm 2mm; margin: 1.2mm 0; break-inside: avoid }
.bad strong, .warned strong { text-transform: uppercase }
.bad strong { color: #a61b1b }
.warned { border-left: 1.2mm solid #b9770e; padding-left: 2mm; margin: 1.2mm 0; break-inside: avoid }
.good { padding-left: 3.2mm; margin: 1.2mm 0; break-inside: avoid }
.hash { font: 7.6pt "DejaVu Sans Mono", "Liberation Mono", Menlo, Consolas, monospace; overflow-wrap: anywhere }
@media screen and (prefers-color-scheme: dark) {
  body { color: #e4ebf1; background: #10161c }
  code { background: #1d2833 }
  h2 { border-color: #9db4c8 }
  td { border-color: #27313b }
  .file, .hint { color: #9fb0be }
  .bad strong { color: #ff8a80 }
}
</style>
)css";

}  // namespace glider::report
