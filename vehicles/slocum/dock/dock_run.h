// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/dock.h"
#include "vehicles/slocum/dock/dock.h"
#include "vehicles/slocum/dock/dock_line.h"

#include <functional>
#include <string>

namespace glider::slocum {

/// A check that runs: its line, its time, and whether it is to go on.
class DockRun {
 public:
  DockRun(const DockSetup& setup, const vehicles::DockHost& host)
      : setup_(setup), host_(host), line_(host), begin_s_(host.now()) {}

  [[nodiscard]] const DockSetup& setup() const { return setup_; }
  [[nodiscard]] const vehicles::DockHost& host() const { return host_; }
  [[nodiscard]] DockLine& line() { return line_; }
  [[nodiscard]] const DockLine& line() const { return line_; }
  /// Since the beginning, s.
  [[nodiscard]] double now() const { return host_.now() - begin_s_; }

  /// Gives what arrives until `until_s` to `take`; false if the check is to end before.
  bool hearUntil(double until_s, const std::function<void(const std::string& body)>& take);
  /// The same, while `wanted` is true.
  bool hearWhile(double until_s, const std::function<bool()>& wanted,
                 const std::function<void(const std::string& body)>& take);
  [[nodiscard]] vehicles::DockEnd end() const;

 private:
  const DockSetup& setup_;
  const vehicles::DockHost& host_;
  DockLine line_;
  double begin_s_;
};

/// The name of a sentence: what is before its first comma.
std::string nameOf(const std::string& body);
/// Whether only a vehicle, or only an SBC, says sentences with this name.
bool isOfVehicle(const std::string& name);
bool isOfSbc(const std::string& name);

}  // namespace glider::slocum
