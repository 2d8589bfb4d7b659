// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviour.h"
#include "simulator/slocum/flight/behaviours/hookbeh_adapter.h"
#include "simulator/slocum/flight/mission_variables.h"
#include "simulator/slocum/flight/when.h"

#include <memory>
#include <vector>

namespace glider::simulator {

/// The behaviours of a mission in layers: the first of the file has the highest priority. In each
/// cycle they run from the last to the first, and later runners overwrite, so that a behaviour's
/// start condition sees what those below command.
class LayeredControl {
 public:
  /// `hull` is that of the vehicle that hookbeh is built for. `variables` outlives this.
  LayeredControl(const slocum::MissionFile& mission, const hooks::Hull& hull,
                 const MissionVariables& variables, Code15 code_15);

  struct Decision {
    Commands commands;
    Abort abort = Abort::None;
    std::string why;
  };
  Decision cycle(const Situation& situation, Journal& journal);

  /// The behaviour that has ended the mission; null if none has.
  [[nodiscard]] const Behaviour* quitter() const;
  [[nodiscard]] bool quit() const { return quitter() != nullptr; }
  /// When a behaviour last had contact with an operator, s of the mission; 0, its start: not yet.
  [[nodiscard]] double lastContact() const;
  /// True when no behaviour that flies can ever fly again; `sbc_gone` means that the SBC cannot
  /// take control again either.
  [[nodiscard]] bool nothingLeftToFly(bool sbc_gone) const;
  /// The mission's hookbeh; null without one.
  [[nodiscard]] const HookbehAdapter* hookbeh() const { return hookbeh_; }

 private:
  struct Layer {
    std::unique_ptr<Behaviour> behaviour;
    int number = 0;                                     ///< place in the mission file
    Behaviour::State told = Behaviour::State::Waiting;  ///< the state last written to the journal
  };
  static void tell(Layer& layer, double time_s, Journal& journal);

  std::vector<Layer> layers_;
  HookbehAdapter* hookbeh_ = nullptr;
};

}  // namespace glider::simulator
