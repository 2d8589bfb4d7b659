// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/logged_values.h"

#include "flights/logged_form.h"
#include "hooks/protocol/messages.h"
#include "ir/core/walk.h"
#include "support/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glider::flights {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// A column for one value of the statements that have the same text.
struct ValueColumn {
  support::LoggedValue value;
  LoggedForm form;
  std::vector<std::pair<size_t, double>> points;  ///< row, value
};

/// The `log` statements of one text and so many values.
struct Statements {
  std::string text;
  std::vector<ValueColumn> columns;
};

/// "bloom at depth" as a part of a column's name, without what a table of commas cannot hold.
std::string asName(std::string_view text) {
  std::string name;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (plain) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  name.erase(name.find_last_not_of('_') + 1);
  return name;
}

std::vector<Statements> statementsOf(const compiler::Checked& mission,
                                     const support::Trace& trace) {
  const ir::Mission& m = mission.mission();
  const SensorUnit declared = unitsOf(mission.platform());
  const auto unit_of = [&](const std::string& sensor) -> std::string {
    const int column = trace.column(sensor);
    if (column >= 0) {
      return trace.columns[static_cast<size_t>(column)].unit;
    }
    return declared(sensor);
  };
  std::vector<Statements> all;
  forEachLog(m, [&](const ir::Statement& statement) {
    const auto same = std::ranges::find_if(all, [&](const Statements& other) {
      return other.text == statement.text && other.columns.size() == statement.values.size();
    });
    if (same != all.end() || statement.values.empty()) {
      return;
    }
    Statements made{statement.text, {}};
    // A position is two values of one text.
    const auto halfOf = [](const ir::Expr& value) {
      return value.type.kind == ir::TypeKind::Latitude    ? "latitude"
             : value.type.kind == ir::TypeKind::Longitude ? "longitude"
                                                          : "";
    };
    for (const ir::ExprId id : statement.values) {
      const support::SourceRange range = m[id].range;
      ValueColumn column;
      column.value.text = statement.text;
      column.value.value = range.valid() ? support::onOneLine(mission.sources().text(range)) : "";
      const bool half = std::ranges::count(statement.values, range,
                                           [&](ir::ExprId other) { return m[other].range; }) == 2;
      column.value.half = halfOf(m[id]);
      column.value.value += half ? " " + column.value.half : "";
      column.value.column = "log_" + asName(statement.text + " " + column.value.value);
      column.form = formOf(m, id, unit_of);
      made.columns.push_back(std::move(column));
    }
    all.push_back(std::move(made));
  });
  return all;
}

/// The values at the end of a note of a statement with `text`, as runtime/core/tell_notes.cpp
/// writes them; empty if it is another statement's.
std::vector<double> valuesIn(std::string_view note, std::string_view text) {
  std::vector<double> values;
  if (!note.starts_with(text)) {
    return values;
  }
  // What does not fit into a note is cut off, in the middle of a number even.
  const bool cut = note.size() >= hooks::kMostNoteBytes;
  note.remove_prefix(text.size());
  while (note.starts_with(' ')) {
    note.remove_prefix(1);
    const std::string_view word = note.substr(0, note.find(' '));
    double value = kUnknown;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word != "unknown" && (error != std::errc() || end != word.data() + word.size())) {
      return {};
    }
    note.remove_prefix(word.size());
    if (cut && note.empty()) {
      break;
    }
    values.push_back(word == "unknown" ? kUnknown : value);
  }
  return note.empty() ? values : std::vector<double>{};
}

/// The first row at or after `time_s`; the last one if there is none.
size_t rowOf(const support::Trace& trace, double time_s) {
  size_t low = 0, high = trace.rowCount() - 1;
  while (low < high) {
    const size_t middle = (low + high) / 2;
    (trace.at(middle, 0) < time_s ? low : high) =
        trace.at(middle, 0) < time_s ? middle + 1 : middle;
  }
  return low;
}

/// The note of `statements` with these values, in the unit of the columns, for people.
std::string shownNote(const Statements& statements, const std::vector<double>& values) {
  std::vector<LoggedForm> forms;
  std::ranges::transform(statements.columns, std::back_inserter(forms), &ValueColumn::form);
  const std::string list = shownValues(forms, values);
  const char* rest = values.size() < statements.columns.size() ? ", …" : "";
  return statements.text + (statements.text.empty() ? "" : " ") + list + rest;
}

/// "deep 20.287355423 m 6.18456231454 rad unknown": the note for tables, with all its digits.
std::string noteInUnits(const Statements& statements, const std::vector<double>& values) {
  std::string text = statements.text;
  for (size_t i = 0; i < values.size(); ++i) {
    const LoggedForm& form = statements.columns[i].form;
    text += (text.empty() ? "" : " ") + exactValue(form, values[i]);
  }
  return text;
}

/// As notes have them: with 12 digits.
double asNoted(double value) {
  constexpr int kDigits = 12;
  double read = value;
  const std::string text = fmt::format("{:.{}g}", value, kDigits);
  std::from_chars(text.data(), text.data() + text.size(), read);
  return read;
}

/// The text of a note with all its values.
std::string wholeText(const support::LoggedNote& note) {
  std::string text = note.text;
  for (const double value : note.values) {
    text += std::isnan(value) ? " unknown" : fmt::format(" {}", asNoted(value));
  }
  return text;
}

/// Finds what the mission has logged itself for the notes that the vehicle has received.
class WholeNotes {
 public:
  explicit WholeNotes(const support::Trace& trace) : notes_(trace.notes) {}

  /// The note whose begin the vehicle has received in `event` as `told`; null: it is not known.
  const support::LoggedNote* of(const support::TraceEvent& event, const std::string& told) {
    // In order; the same note of two ticks at one time is there once.
    for (const size_t from : {next_, size_t{0}}) {
      for (size_t i = from; i < notes_.size(); ++i) {
        if (notes_[i].mission_time_s == event.mission_time_s && begins(notes_[i], told)) {
          next_ = i + 1;
          return &notes_[i];
        }
      }
    }
    return nullptr;
  }

 private:
  static bool begins(const support::LoggedNote& note, const std::string& told) {
    const std::string whole = wholeText(note);
    return told.size() < hooks::kMostNoteBytes ? whole == told : whole.starts_with(told);
  }

  const std::vector<support::LoggedNote>& notes_;
  size_t next_ = 0;
};

void readNotes(support::Trace& trace, std::vector<Statements>& all) {
  WholeNotes whole_notes(trace);
  for (support::TraceEvent& event : trace.events) {
    if (event.id != support::EventId::Note || event.values.empty()) {
      continue;
    }
    auto& note = std::get<std::string>(event.values[0]);
    const bool cut = note.size() >= hooks::kMostNoteBytes;
    const support::LoggedNote* const logged = whole_notes.of(event, note);
    if (cut && logged != nullptr) {
      note = wholeText(*logged);
    }
    for (Statements& statements : all) {
      const bool its = logged != nullptr && logged->text == statements.text;
      std::vector<double> values = its ? logged->values : valuesIn(note, statements.text);
      std::ranges::transform(values, values.begin(), asNoted);
      const bool whole = values.size() == statements.columns.size();
      if (!whole && (values.empty() || !cut || logged != nullptr)) {
        continue;
      }
      values.resize(std::min(values.size(), statements.columns.size()));
      for (size_t i = 0; i < values.size(); ++i) {
        ValueColumn& column = statements.columns[i];
        values[i] *= column.form.to_shown;
        column.points.emplace_back(rowOf(trace, event.time_s), values[i]);
      }
      event.shown = shownNote(statements, values);
      note = whole ? noteInUnits(statements, values) : note;
      break;
    }
  }
}

std::string unusedName(const support::Trace& trace, const std::string& wanted) {
  std::string name = wanted;
  for (int i = 2; trace.column(name) >= 0; ++i) {
    name = wanted + "_" + std::to_string(i);
  }
  return name;
}

/// Makes each row longer by `more` unknown values.
void widen(support::Trace& trace, size_t more) {
  const size_t width = trace.columns.size();
  std::vector<double> rows;
  rows.reserve(trace.rowCount() * (width + more));
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    const auto begin = trace.rows.begin() + static_cast<std::ptrdiff_t>(row * width);
    rows.insert(rows.end(), begin, begin + static_cast<std::ptrdiff_t>(width));
    rows.insert(rows.end(), more, kUnknown);
  }
  trace.rows = std::move(rows);
}

}  // namespace

void addLoggedValues(const compiler::Optimised& mission, support::Trace& trace) {
  if (trace.rowCount() == 0) {
    return;
  }
  std::vector<Statements> all = statementsOf(*mission.checked, trace);
  readNotes(trace, all);
  std::vector<ValueColumn> columns;
  for (Statements& statements : all) {
    std::ranges::move(statements.columns, std::back_inserter(columns));
  }
  widen(trace, columns.size());
  const size_t first = trace.columns.size(), width = first + columns.size();
  for (size_t i = 0; i < columns.size(); ++i) {
    ValueColumn& column = columns[i];
    column.value.column = unusedName(trace, column.value.column);
    trace.columns.push_back({column.value.column, column.form.unit});
    for (const auto& [row, value] : column.points) {
      trace.rows[row * width + first + i] = value;
    }
    trace.facts.logged.push_back(column.value);
  }
}

}  // namespace glider::flights
