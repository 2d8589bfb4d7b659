// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/findings/findings.h"
#include "report/findings/uri.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <map>

namespace glider::report {
namespace {

using nlohmann::ordered_json;
using support::Diagnostic;
using support::DiagnosticId;
using support::Severity;
using support::SourceManager;
using support::SourceRange;

/// "EmptyReturn" of "empty-return".
std::string pascalCase(std::string_view slug) {
  std::string name;
  bool first = true;
  for (const char c : slug) {
    if (c != '-') {
      name += first ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    }
    first = c == '-';
  }
  return name;
}

/// The parts of a page: its title, and its first paragraph on one line.
struct PageParts {
  std::string title;
  std::string paragraph;
};

PageParts partsOf(std::string_view page) {
  PageParts parts;
  const size_t heading_end = std::min(page.find('\n'), page.size());
  const std::string_view heading = page.substr(0, heading_end);
  const size_t colon = heading.find(": ");
  parts.title = heading.substr(colon == std::string_view::npos ? 0 : colon + 2);
  std::string_view rest = page.substr(heading_end);
  rest.remove_prefix(std::min(rest.find_first_not_of('\n'), rest.size()));
  parts.paragraph = rest.substr(0, rest.find("\n\n"));
  std::ranges::replace(parts.paragraph, '\n', ' ');
  return parts;
}

ordered_json text(std::string_view said) {
  return {{"text", said}};
}

class Log {
 public:
  Log(const ExplainPage& page, const std::string& version, int exit_code)
      : page_(page), version_(version), exit_code_(exit_code) {}

  void add(const CheckedMission& mission) {
    sources_ = mission.sources;
    for (const Diagnostic& diagnostic : mission.diagnostics) {
      results_.push_back(resultOf(diagnostic));
    }
    for (const Remark& remark : mission.remarks) {
      ordered_json result = {{"kind", "informational"}, {"level", "none"}};
      result["message"] = text(remark.text);
      addLocation(result, remark.range);
      results_.push_back(std::move(result));
    }
    if (mission.failure) {
      ordered_json notice = {{"descriptor", {{"id", support::code(mission.failure->id)}}},
                             {"level", "error"}};
      notice["message"] = text(withHint(mission.failure->message, mission.failure->hint));
      notice["locations"] = {
          {{"physicalLocation", {{"artifactLocation", {{"uri", toUri(mission.path)}}}}}}};
      notices_.push_back(std::move(notice));
    }
  }

  [[nodiscard]] std::string write() const {
    ordered_json driver = {{"name", "glidercc"},
                           {"version", version_},
                           {"semanticVersion", version_},
                           {"rules", rules_}};
    ordered_json invocation = {{"executionSuccessful", notices_.empty()}, {"exitCode", exit_code_}};
    if (!notices_.empty()) {
      invocation["toolExecutionNotifications"] = notices_;
    }
    const ordered_json run = {{"tool", {{"driver", std::move(driver)}}},
                              {"invocations", ordered_json::array({std::move(invocation)})},
                              {"columnKind", "unicodeCodePoints"},
                              {"results", results_}};
    const ordered_json log = {{"$schema",
                               "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/"
                               "sarif-schema-2.1.0.json"},
                              {"version", "2.1.0"},
                              {"runs", ordered_json::array({run})}};
    return log.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
  }

 private:
  [[nodiscard]] static std::string withHint(const std::string& message, const std::string& hint) {
    return hint.empty() ? message : message + "\nHint: " + hint;
  }

  /// The place of the rule in the list; a new rule is added.
  size_t ruleIndex(DiagnosticId id) {
    const auto [known, added] = rule_of_.try_emplace(id, rules_.size());
    if (added) {
      const support::CatalogueRow& row = support::catalogueRow(id);
      const std::string page = page_(id);
      const PageParts parts = partsOf(page);
      ordered_json rule = {{"id", support::code(id)}, {"name", pascalCase(row.slug)}};
      if (!parts.title.empty()) {
        rule["shortDescription"] = text(parts.title);
        rule["fullDescription"] = text(parts.paragraph.empty() ? parts.title : parts.paragraph);
        rule["help"] = {{"text", page}, {"markdown", page}};
      }
      rule["defaultConfiguration"] = {{"level", support::word(row.severity)}};
      rules_.push_back(std::move(rule));
    }
    return known->second;
  }

  [[nodiscard]] ordered_json artifact(uint32_t file) const {
    return {{"uri", toUri(sources_->name(file))}};
  }

  [[nodiscard]] ordered_json region(SourceRange range) const {
    const auto begin = sources_->place(range.file, range.begin);
    const auto end = sources_->place(range.file, std::max(range.begin, range.end));
    return {{"startLine", begin.line},
            {"startColumn", begin.column},
            {"endLine", end.line},
            {"endColumn", end.column}};
  }

  [[nodiscard]] ordered_json physical(SourceRange range) const {
    return {{"artifactLocation", artifact(range.file)}, {"region", region(range)}};
  }

  void addLocation(ordered_json& to, SourceRange range) const {
    if (range.valid() && sources_ != nullptr) {
      to["locations"] = ordered_json::array({{{"physicalLocation", physical(range)}}});
    }
  }

  ordered_json resultOf(const Diagnostic& diagnostic) {
    ordered_json result = {{"ruleId", support::code(diagnostic.id)},
                           {"ruleIndex", ruleIndex(diagnostic.id)},
                           {"level", support::word(diagnostic.severity)}};
    result["message"] = text(withHint(diagnostic.message, diagnostic.hint));
    addLocation(result, diagnostic.range);
    for (const support::DiagnosticNote& note : diagnostic.notes) {
      ordered_json related = {{"id", result["relatedLocations"].size()}};
      if (note.range.valid() && sources_ != nullptr) {
        related["physicalLocation"] = physical(note.range);
      }
      related["message"] = text(note.message);
      result["relatedLocations"].push_back(std::move(related));
    }
    if (!diagnostic.fixes.empty()) {
      result["fixes"] = ordered_json::array({fixOf(diagnostic)});
    }
    return result;
  }

  /// All replacements of a diagnostic are one fix, with a change for each file.
  [[nodiscard]] ordered_json fixOf(const Diagnostic& diagnostic) const {
    std::map<uint32_t, ordered_json> by_file;
    for (const support::FixIt& fix : diagnostic.fixes) {
      by_file[fix.range.file].push_back(
          {{"deletedRegion", region(fix.range)}, {"insertedContent", text(fix.replacement)}});
    }
    ordered_json changes = ordered_json::array();
    for (auto& [file, replacements] : by_file) {
      changes.push_back({{"artifactLocation", artifact(file)}, {"replacements", replacements}});
    }
    ordered_json fix = ordered_json::object();
    if (!diagnostic.hint.empty()) {
      fix["description"] = text(diagnostic.hint);
    }
    fix["artifactChanges"] = std::move(changes);
    return fix;
  }

  const ExplainPage& page_;
  const std::string& version_;
  int exit_code_;
  const SourceManager* sources_ = nullptr;
  ordered_json rules_ = ordered_json::array(), results_ = ordered_json::array();
  ordered_json notices_ = ordered_json::array();
  std::map<DiagnosticId, size_t> rule_of_;
};

}  // namespace

std::string findingsToSarif(const std::vector<CheckedMission>& missions, const std::string& version,
                            const ExplainPage& page, int exit_code) {
  Log log(page, version, exit_code);
  for (const CheckedMission& mission : missions) {
    log.add(mission);
  }
  return log.write();
}

}  // namespace glider::report
