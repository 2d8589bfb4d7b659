// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/log_in_units.h"

#include "report/text.h"
#include "runtime/log/mission_log.h"

namespace glider::driver {

using flights::LoggedForm;
using Half = LoggedForm::Half;

namespace {

LoggedForm ofTime() {
  return flights::formOf({ir::TypeKind::Quantity, support::dimension::time});
}

/// "bottom" of "bottom.latitude" and "bottom.longitude".
std::string placeName(const std::string& name) {
  return name.substr(0, name.rfind('.'));
}

}  // namespace

LogInUnits::LogInUnits(const compiler::Optimised& mission) {
  const flights::SensorUnit unit = flights::unitsOf(mission.platform());
  for (const char* clock : {"statetime", "resumetime", "missiontime"}) {
    named_[clock] = ofTime();
  }
  const ir::Mission& written = mission.checked->mission();
  for (const ir::Variable& variable : written.variables) {
    if (variable.kind == ir::VariableKind::Parameter) {
      named_[variable.name] = flights::formOf(variable.type);
    }
  }
  nameSensors(written, unit);
  nameNotes(written, unit);
}

void LogInUnits::nameSensors(const ir::Mission& mission, const flights::SensorUnit& unit) {
  for (const ir::Sensor& sensor : mission.sensors) {
    named_[sensor.name] = named_[sensor.vehicle_name] = flights::formOf(sensor, unit);
  }
  for (const ir::State& state : mission.states) {
    for (const ir::LogItem& item : state.log) {
      named_.try_emplace(item.name, flights::formOf(mission, item.value, unit));
    }
  }
}

void LogInUnits::nameNotes(const ir::Mission& mission, const flights::SensorUnit& unit) {
  flights::forEachLog(mission, [&](const ir::Statement& statement) {
    std::vector<LoggedForm>& forms = notes_[{
        statement.text.substr(0, runtime::MissionLog::kNameBytes), statement.values.size()}];
    for (size_t i = 0; i < statement.values.size(); ++i) {
      const LoggedForm form = flights::formOf(mission, statement.values[i], unit);
      // Of two statements that are alike, what differs has no unit.
      i == forms.size() ? forms.push_back(form)
                        : void(forms[i] = forms[i] == form ? form : LoggedForm{});
    }
  });
}

/// Of each value of `entry`; what the mission does not name has none.
std::vector<LoggedForm> LogInUnits::formsOf(const logs::LogEntry& entry) {
  std::vector<LoggedForm> forms;
  bool strange = false;
  if (entry.kind == runtime::LogRecord::Note && !entry.unknown_set) {
    const auto note = notes_.find({entry.name, entry.values.size()});
    strange = note == notes_.end();
    forms = strange ? std::vector<LoggedForm>(entry.values.size()) : note->second;
  } else {
    for (const auto& [name, value] : entry.values) {
      const auto found = named_.find(name);
      strange = strange || found == named_.end();
      forms.push_back(found != named_.end() ? found->second : LoggedForm{});
    }
  }
  strangers_ += strange ? 1 : 0;
  return forms;
}

logs::LogEntry LogInUnits::converted(const logs::LogEntry& entry) {
  logs::LogEntry made = entry;
  const std::vector<LoggedForm> forms = formsOf(entry);
  for (size_t i = 0; i < forms.size(); ++i) {
    made.values[i].second *= forms[i].to_shown;
    made.units.push_back(forms[i].unit);
  }
  return made;
}

std::string LogInUnits::values(const logs::LogEntry& entry) {
  const std::vector<LoggedForm> forms = formsOf(entry);
  std::vector<double> shown;
  for (size_t i = 0; i < forms.size(); ++i) {
    shown.push_back(entry.values[i].second * forms[i].to_shown);
  }
  if (entry.kind == runtime::LogRecord::Note) {
    return flights::shownValues(forms, shown);
  }
  std::string list;
  for (size_t i = 0; i < shown.size(); ++i) {
    const std::string& name = entry.values[i].first;
    const bool place = i + 1 < shown.size() && forms[i].half == Half::Latitude &&
                       forms[i + 1].half == Half::Longitude &&
                       placeName(name) == placeName(entry.values[i + 1].first);
    const size_t count = place ? 2 : 1;
    list += (list.empty() ? "" : ", ") + report::plain(place ? placeName(name) : name) + " " +
            flights::shownValues({&forms[i], count}, {&shown[i], count});
    i += count - 1;
  }
  return list;
}

}  // namespace glider::driver
