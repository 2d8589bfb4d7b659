// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/json_document.h"

#include "driver/exit_code.h"
#include "driver/terminal.h"
#include "driver/usage/values.h"

#include <cmath>
#include <vector>

namespace glider::driver {
namespace {

Json documentOf(const std::string& command, int status) {
  return {{"glidercc", GLIDER_VERSION},
          {"command", command},
          {"status", status},
          {"diagnostics", Json::array()}};
}

Json placeOf(const support::LineColumn& at) {
  return {{"line", at.line}, {"column", at.column}};
}

/// As in the document of `check`.
Json diagnosticOf(const Reported& reported) {
  Json one = {{"id", support::code(reported.id)},
              {"name", support::catalogueRow(reported.id).slug},
              {"severity", support::word(reported.severity)}};
  if (!reported.file.empty()) {
    one["file"] = reported.file;
    one["begin"] = placeOf(reported.begin);
    one["end"] = placeOf(reported.end);
  }
  one["message"] = reported.message;
  if (!reported.hint.empty()) {
    one["hint"] = reported.hint;
  }
  return one;
}

support::Result<void> print(const Json& document) {
  return printOut(document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace

void addFormatOption(CLI::App& command, bool& json) {
  command
      .add_option_function<std::string>(
          "--format", [&json](const std::string& format) { json = format == "json"; },
          "Output format: text, or json, one document with all findings [text]")
      ->check(oneOf({"text", "json"}))
      ->option_text("FORMAT");
}

int inFormat(bool json, const std::string& command, const std::function<int(Json*)>& work) {
  if (!json) {
    return work(nullptr);
  }
  Json members = Json::object();
  const KeptReports kept;
  const int status = work(&members);
  Json document = documentOf(command, status);
  for (const Reported& reported : kept.all()) {
    document["diagnostics"].push_back(diagnosticOf(reported));
  }
  document.update(members);
  const auto printed = print(document);
  return printed ? status : reportFailure(printed.error());
}

void printUsageError(const std::string& command, const std::string& message,
                     const std::string& hint) {
  Json document = documentOf(command, kWorldFailed);
  document["diagnostics"].push_back({{"severity", "error"}, {"message", message}, {"hint", hint}});
  (void)print(document);  // the exit code is that of the error
}

Json numberOrNull(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

}  // namespace glider::driver
