// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/launch/launch.h"

#include "runtime/launch/quote.h"

#include <string.h>

namespace glider::runtime {

Launch::Launch(const GliderMission& mission) : mission_(mission) {
  for (uint32_t i = 0; i < mission.parameter_count && i < kMostParameters; ++i) {
    values_[i] = mission.parameters[i].initial;
  }
}

bool Launch::set(const Piece& setting) {
  const char* equals = setting.find('=');
  if (equals == setting.end) {
    Text text(problem_, kProblemBytes);
    quote(text, setting.trimmed()).put(" sets nothing; write `name=value`");
    return refuse(text);
  }
  const Piece name = Piece{setting.begin, equals}.trimmed();
  const uint32_t parameter = find(name);
  return parameter == kMostParameters
             ? refuseUnknown(name)
             : assign(parameter, name, Piece{equals + 1, setting.end}.trimmed());
}

bool Launch::setAll(const char* file_name, const Piece& content) {
  file_ = file_name;
  line_ = 0;
  bool good = true;
  for (const char* begin = content.begin; good && begin != content.end;) {
    ++line_;
    const char* end = Piece{begin, content.end}.find('\n');
    const Piece setting = Piece{begin, Piece{begin, end}.find('#')}.trimmed();
    good = setting.empty() || set(setting);
    begin = end != content.end ? end + 1 : end;
  }
  file_ = nullptr;
  return good;
}

bool Launch::refuseUnknown(const Piece& name) {
  Text text(problem_, kProblemBytes);
  text.put("the mission has no parameter ");
  quote(text, name);
  text.put(mission_.parameter_count == 0 ? "; it has none" : "; it has ");
  listNames(text);
  return refuse(text);
}

/// Terminates the problem with a zero, and puts the location in front of it. Always false.
bool Launch::refuse(Text& text) {
  problem_[text.size()] = '\0';
  if (file_ != nullptr) {
    char place[kProblemBytes];
    Text placed(place, kProblemBytes);
    placed.put(file_, kMostQuoted).put(':').putCount(line_).put(": ").put(problem_);
    memcpy(problem_, place, placed.size());
    problem_[placed.size()] = '\0';
  }
  return false;
}

}  // namespace glider::runtime
