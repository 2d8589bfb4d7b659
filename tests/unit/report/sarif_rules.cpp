// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/report/sarif_rules.h"

#include <set>

namespace glider::report {
namespace {

using nlohmann::json;

class Judge {
 public:
  std::vector<std::string> judge(const json& log) {
    require(log, "log", {"version", "runs"});
    expect(log.value("version", "") == "2.1.0", "the version is not 2.1.0");
    expect(log.contains("runs") && log["runs"].size() == 1, "not one run");
    if (faults_.empty()) {
      run(log["runs"][0]);
    }
    return faults_;
  }

 private:
  void expect(bool holds, const std::string& fault) {
    if (!holds) {
      faults_.push_back(fault);
    }
  }

  void require(const json& object, const std::string& what, const std::vector<const char*>& names) {
    expect(object.is_object(), what + " is not an object");
    for (const char* name : names) {
      expect(object.contains(name), what + " lacks " + name);
    }
  }

  void run(const json& run) {
    require(run, "run", {"tool", "results"});
    require(run["tool"], "tool", {"driver"});
    const json& driver = run["tool"]["driver"];
    require(driver, "driver", {"name", "rules"});
    rules(driver["rules"]);
    const std::string kind = run.value("columnKind", "");
    expect(kind == "unicodeCodePoints" || kind == "utf16CodeUnits", "columnKind " + kind);
    for (const json& invocation : run.value("invocations", json::array())) {
      require(invocation, "invocation", {"executionSuccessful"});
      for (const json& notice : invocation.value("toolExecutionNotifications", json::array())) {
        require(notice, "notification", {"message"});
        message(notice.value("message", json::object()));
      }
    }
    for (const json& one : run["results"]) {
      result(one, driver["rules"]);
    }
  }

  void rules(const json& rules) {
    std::set<std::string> ids;
    for (const json& rule : rules) {
      require(rule, "rule", {"id"});
      expect(ids.insert(rule.value("id", "")).second, "a rule twice");
      for (const char* text : {"shortDescription", "fullDescription", "help"}) {
        if (rule.contains(text)) {
          expect(!rule[text].value("text", "").empty(), std::string("no text in ") + text);
        }
      }
    }
  }

  void message(const json& message) {
    expect(!message.value("text", "").empty(), "a message without text");
  }

  void result(const json& result, const json& rules) {
    require(result, "result", {"message"});
    message(result.value("message", json::object()));
    if (result.contains("ruleIndex")) {
      const size_t index = result["ruleIndex"];
      expect(index < rules.size() && rules[index]["id"] == result.value("ruleId", ""),
             "ruleIndex names another rule");
    }
    static const std::set<std::string> levels{"none", "note", "warning", "error"};
    expect(levels.contains(result.value("level", "warning")), "a level that is none");
    for (const char* list : {"locations", "relatedLocations"}) {
      for (const json& location : result.value(list, json::array())) {
        if (location.contains("physicalLocation")) {
          physical(location["physicalLocation"]);
        }
      }
    }
    for (const json& fix : result.value("fixes", json::array())) {
      require(fix, "fix", {"artifactChanges"});
      expect(!fix["artifactChanges"].empty(), "a fix that changes nothing");
      for (const json& change : fix["artifactChanges"]) {
        require(change, "artifactChange", {"artifactLocation", "replacements"});
        expect(!change["replacements"].empty(), "a change that replaces nothing");
        for (const json& replacement : change["replacements"]) {
          require(replacement, "replacement", {"deletedRegion"});
          region(replacement["deletedRegion"]);
        }
      }
    }
  }

  void physical(const json& place) {
    require(place, "physicalLocation", {"artifactLocation"});
    const std::string uri = place["artifactLocation"].value("uri", "");
    expect(!uri.empty() && uri.find_first_of(" \\\"<>^`{|}") == std::string::npos, "uri " + uri);
    if (place.contains("region")) {
      region(place["region"]);
    }
  }

  void region(const json& region) {
    const int line = region.value("startLine", 0), column = region.value("startColumn", 0);
    const int end_line = region.value("endLine", 0), end_column = region.value("endColumn", 0);
    expect(line >= 1 && column >= 1 && end_line >= line, "a region that is none");
    expect(end_line > line || end_column >= column, "a region that ends before it begins");
  }

  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> sarifFaults(const json& log) {
  return Judge().judge(log);
}

}  // namespace glider::report
