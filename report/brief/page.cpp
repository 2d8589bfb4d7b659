// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/brief/brief.h"
#include "report/brief/html.h"
#include "report/brief/style.h"
#include "report/svg/svg_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::report {
namespace {

using html::cell;
using html::raw;
using html::table;
using html::words;

void addHead(SvgText& page, const Brief& brief) {
  page.add("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
  page.add(
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{}: mission brief</title>\n",
      raw(brief.mission));
  page.add(kBriefStyle);
  page.add("</head>\n<body>\n<h1>{}</h1>\n", raw(brief.mission));
  page.add("<p class=\"file\">Mission brief. File {}, vehicle {}{}{}. Written by {}.</p>\n",
           raw(brief.file), raw(brief.platform), brief.platform_description.empty() ? "" : ": ",
           raw(brief.platform_description), raw(brief.version));
}

/// The requirements that the mission violates come first, so that they are not missed.
void addSummary(SvgText& page, const Brief& brief) {
  const auto violated =
      std::ranges::count(brief.requirements, "refuted", &BriefRequirement::verdict);
  if (violated > 0) {
    page.add(
        "<p class=\"bad\"><strong>Do not fly:</strong> this mission violates {} of its "
        "requirements.</p>\n",
        violated);
  }
  page.add(brief.comment.empty() ? "" : "<p>" + words(brief.comment) + "</p>\n");
  std::string summary;
  for (const std::string& sentence : brief.summary) {
    summary += (summary.empty() ? "" : " ") + words(sentence);
  }
  page.add("<p>{}</p>\n", summary);
}

void addGraph(SvgText& page, const Brief& brief) {
  page.add("<figure>\n{}</figure>\n", graphToSvg(brief.graph, {}));
}

std::string usage(const BriefUse& use) {
  const auto sentence = [](const std::string& text) {
    return text.empty() ? "" : " – " + words(text);
  };
  return fmt::format("<code>{}</code>{}{}", raw(use.name),
                     use.with.empty() ? "" : " (" + words(use.with) + ")", sentence(use.comment));
}

void addEvents(SvgText& page, const std::vector<BriefEvent>& events) {
  page.add("<ol>\n");
  for (const BriefEvent& event : events) {
    page.add("<li>when <code>{}</code>: {}{}</li>\n", raw(event.when), words(event.then),
             event.never.empty() ? "" : " <em>(" + words(event.never) + ")</em>");
  }
  page.add("</ol>\n");
}

void addState(SvgText& page, const BriefState& state, bool first) {
  page.add("<section class=\"state\">\n<h3>{}", raw(state.name));
  page.add(state.parameters.empty() ? "" : " <small>(" + raw(state.parameters) + ")</small>");
  page.add(first ? " <small>– the mission starts here</small>" : "");
  page.add(state.unreached ? " <small>– nothing leads to this state</small>" : "");
  page.add("</h3>\n");
  page.add(state.comment.empty() ? "" : "<p>" + words(state.comment) + "</p>\n");
  page.add("<ul>\n<li>Depth: {}{}</li>\n", usage(state.profile),
           state.deepest.empty() ? "" : " The vehicle is " + raw(state.deepest) + ".");
  page.add("<li>Course: {}</li>\n<li>Logs: {}</li>\n", usage(state.route),
           state.samples.empty() ? "nothing" : words(state.samples));
  page.add(state.instruments.empty() ? ""
                                     : "<li>Instruments: " + words(state.instruments) + "</li>\n");
  page.add(state.entry.empty() ? "" : "<li>On entry: " + words(state.entry) + "</li>\n");
  page.add(state.events.empty() ? "<li>Events: none</li>\n" : "");
  page.add("</ul>\n");
  if (!state.events.empty()) {
    addEvents(page, state.events);
  }
  page.add("</section>\n");
}

void addStates(SvgText& page, const Brief& brief) {
  page.add(
      "<h2>What it does</h2>\n<p class=\"hint\">On every tick, about every {:g} s, the events "
      "are tried from top to bottom; the first whose condition is true happens. A state that "
      "is called comes back to its caller when it returns.</p>\n",
      brief.cycle_s);
  if (!brief.always.empty()) {
    page.add(
        "<section class=\"state\">\n<h3>In every state, before its own events</h3>\n"
        "<p class=\"hint\">An event is left out while the state that it leads to is current or has "
        "called. In a state that one of these led to, only those above that one count.</p>\n");
    addEvents(page, brief.always);
    page.add("</section>\n");
  }
  for (size_t i = 0; i < brief.states.size(); ++i) {
    addState(page, brief.states[i], i == 0);
  }
}

std::string meaning(const BriefValue& value) {
  return words(value.meaning);
}

void addParameters(SvgText& page, const Brief& brief) {
  page.add("<h2>Parameters</h2>\n");
  if (brief.parameters.empty()) {
    page.add("<p>None: nothing can be changed at launch.</p>\n");
    return;
  }
  const bool launch = std::ranges::any_of(
      brief.parameters, [](const BriefValue& value) { return !value.set_to.empty(); });
  std::vector<std::vector<std::string>> rows;
  for (const BriefValue& one : brief.parameters) {
    std::vector<std::string> row = {cell(one.name), raw(one.kind), cell(one.value),
                                    cell(one.range)};
    if (launch) {
      row.push_back(one.set_to.empty() ? "default" : "<strong>" + raw(one.set_to) + "</strong>");
    }
    row.push_back(meaning(one));
    rows.push_back(std::move(row));
  }
  std::vector<std::string> heads = {"name", "type", "default", "range"};
  if (launch) {
    heads.emplace_back("at launch");
  }
  heads.emplace_back("meaning");
  page.add(table(heads, rows));
  for (const std::string& condition : brief.conditions) {
    page.add("<p>Values at launch must satisfy {}.</p>\n", cell(condition));
  }
}

void addValues(SvgText& page, const Brief& brief) {
  if (brief.values.empty()) {
    return;
  }
  std::vector<std::vector<std::string>> rows;
  for (const BriefValue& one : brief.values) {
    rows.push_back({cell(one.name), raw(one.kind), cell(one.value), cell(one.range), meaning(one)});
  }
  page.add("<h2>Other names</h2>\n");
  page.add(
      table({"name", "is a", "value (of a variable: at the start)", "range", "meaning"}, rows));
}

void addSensors(SvgText& page, const Brief& brief) {
  page.add("<h2>Sensors that it needs</h2>\n");
  if (brief.sensors.empty()) {
    page.add("<p>None.</p>\n");
    return;
  }
  page.add(
      "<p class=\"hint\">A sensor that has not reported for the time in the last column, or "
      "whose reading is out of range, is unknown: a condition that needs it does not become "
      "true.</p>\n");
  std::vector<std::vector<std::string>> rows;
  for (const BriefSensor& one : brief.sensors) {
    rows.push_back({cell(one.name), cell(one.vehicle_name), raw(one.from), raw(one.what),
                    raw(one.range), raw(one.stale)});
  }
  page.add(table({"name", "on the vehicle", "from", "is", "valid range", "unknown after"}, rows));
}

void addRequirement(SvgText& page, const BriefRequirement& one) {
  const bool refuted = one.verdict == "refuted";
  page.add("<div class=\"{}\"><strong>{}</strong> {}\n",
           refuted                   ? "bad"
           : one.verdict == "proved" ? "good"
                                     : "warned",
           refuted                   ? "violated:"
           : one.verdict == "proved" ? "proved:"
                                     : "undecided:",
           cell(one.text));
  if (!one.because.empty()) {
    page.add("<ul>\n");
    for (const std::string& why : one.because) {
      page.add("<li>{}</li>\n", words(why));
    }
    page.add("</ul>\n");
  }
  page.add("</div>\n");
}

void addRequirements(SvgText& page, const Brief& brief) {
  page.add("<h2>Requirements</h2>\n");
  if (brief.requirements.empty()) {
    page.add("<p>The mission states none.</p>\n");
  }
  for (const char* verdict : {"refuted", "undecided", "proved"}) {
    for (const BriefRequirement& one : brief.requirements) {
      if (one.verdict == verdict) {
        addRequirement(page, one);
      }
    }
  }
}

void addNotes(SvgText& page, const char* title, const std::vector<BriefNote>& notes) {
  if (notes.empty()) {
    return;
  }
  page.add("<h2>{}</h2>\n<ul>\n", title);
  for (const BriefNote& note : notes) {
    page.add("<li>{}{}{}</li>\n", raw(note.place), note.place.empty() ? "" : ": ",
             words(note.text));
  }
  page.add("</ul>\n");
}

void addBudgets(SvgText& page, const Brief& brief) {
  std::string lines;
  for (const Budget& budget : brief.budgets) {
    std::string line;
    for (const Quantity& quantity : budget.quantities) {
      if (quantity.limit) {
        line += fmt::format("{}{} {}", line.empty() ? "" : "; ", spoken(quantity.name),
                            amount(quantity));
      }
    }
    lines += line.empty() ? "" : fmt::format("<li>{}: {}</li>\n", raw(budget.of), raw(line));
  }
  if (!lines.empty()) {
    page.add("<h2>What it needs of lines and board, at most</h2>\n<ul>\n{}</ul>\n", lines);
  }
}

void addHashes(SvgText& page, const Brief& brief) {
  std::vector<std::vector<std::string>> rows;
  for (const BriefHash& one : brief.hashes) {
    const std::string hash =
        one.sha256.empty() ? "" : "<span class=\"hash\">" + raw(one.sha256) + "</span>";
    rows.push_back(
        {words(one.of), hash + (one.note.empty() || hash.empty() ? "" : "<br>") + words(one.note)});
  }
  page.add("<h2>SHA-256</h2>\n");
  page.add(table({"file", "digest"}, rows));
}

}  // namespace

std::string briefToHtml(const Brief& brief) {
  SvgText page;
  addHead(page, brief);
  addSummary(page, brief);
  addGraph(page, brief);
  addStates(page, brief);
  addParameters(page, brief);
  addValues(page, brief);
  addSensors(page, brief);
  addRequirements(page, brief);
  addNotes(page, "Warnings", brief.warnings);
  addNotes(page, "Remarks", brief.remarks);
  page.add("<h2>Limits assumed</h2>\n<p>{}</p>\n", words(brief.assumptions));
  addBudgets(page, brief);
  addHashes(page, brief);
  page.add("</body>\n</html>\n");
  return page.take();
}

}  // namespace glider::report
