// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/layered_control.h"

#include "simulator/slocum/flight/behaviours/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

namespace glider::simulator {
namespace {

/// What is missing when slots are idle.
std::string whyIdle(Abort abort) {
  const char* slot = abort == Abort::HeadingIdle ? " for the heading"
                     : abort == Abort::PitchIdle ? " for the pitch"
                     : abort == Abort::PumpIdle  ? " for the pump"
                                                 : "";
  return fmt::format("no behaviour gives a command{}", slot);
}

}  // namespace

LayeredControl::LayeredControl(const slocum::MissionFile& mission, const hooks::Hull& hull,
                               const MissionVariables& variables, Code15 code_15) {
  for (size_t i = 0; i < mission.behaviours.size(); ++i) {
    const slocum::BehaviourBlock& block = mission.behaviours[i];
    auto behaviour = block.lacks_file ? nullptr : makeBehaviour({block, hull, variables, code_15});
    if (behaviour == nullptr) {
      continue;  // sensors_in (MissionVariables), or the pilot has been warned
    }
    if (auto* hookbeh = dynamic_cast<HookbehAdapter*>(behaviour.get())) {
      hookbeh_ = hookbeh;
    }
    behaviour->setPlace(static_cast<int>(i) + 1);
    layers_.push_back({std::move(behaviour), static_cast<int>(i)});
  }
}

void LayeredControl::tell(Layer& layer, double time_s, Journal& journal) {
  layer.behaviour->tell(time_s, journal);
  // Behaviours that are always active report their own events, if any.
  const std::string& name = layer.behaviour->name();
  const bool quiet = name == "abend" || name == "hookbeh" || name == "sample";
  const Behaviour::State now = layer.behaviour->state();
  if (now != layer.told && !quiet) {
    const std::string label = layer.behaviour->label();
    if (layer.told == Behaviour::State::Waiting) {  // also if it is complete in its first cycle
      journal.add(time_s, EventId::BehaviourStarts, {label}, layer.behaviour->whyStarted());
    }
    if (now != Behaviour::State::Active) {
      const bool complete = now == Behaviour::State::Complete;
      journal.add(time_s, complete ? EventId::BehaviourCompleted : EventId::BehaviourWaits,
                  {label});
    }
  }
  layer.told = now;
}

LayeredControl::Decision LayeredControl::cycle(const Situation& situation, Journal& journal) {
  Decision decision;
  for (Layer& layer : layers_ | std::views::reverse) {
    decision.commands.layer = layer.number;
    layer.behaviour->run(situation, decision.commands);
    tell(layer, situation.flight_s, journal);
    if (decision.abort == Abort::None) {
      decision.abort = layer.behaviour->abort(decision.why);
    }
  }
  for (Layer& layer : layers_) {
    layer.behaviour->noteMasked(decision.commands.maskedFor(layer.number));
  }
  if (decision.abort == Abort::None && !quit()) {
    decision.abort = decision.commands.idleAbort();
    decision.why = whyIdle(decision.abort);
  }
  return decision;
}

const Behaviour* LayeredControl::quitter() const {
  const auto found = std::ranges::find_if(
      layers_, [](const Layer& layer) { return layer.behaviour->endsMission(); });
  return found == layers_.end() ? nullptr : found->behaviour.get();
}

double LayeredControl::lastContact() const {
  double last_s = 0;
  for (const Layer& layer : layers_) {
    last_s = std::max(last_s, layer.behaviour->lastContact());
  }
  return last_s;
}

bool LayeredControl::nothingLeftToFly(bool sbc_gone) const {
  return std::ranges::all_of(layers_, [&](const Layer& layer) {
    const Behaviour& behaviour = *layer.behaviour;
    if (&behaviour == hookbeh_) {
      const hooks::HookState state = hookbeh_->hookState();
      return state == hooks::HookState::Complete || (sbc_gone && state != hooks::HookState::Active);
    }
    return behaviour.flies() ? behaviour.state() == Behaviour::State::Complete
                             : !behaviour.atWork();
  });
}

}  // namespace glider::simulator
