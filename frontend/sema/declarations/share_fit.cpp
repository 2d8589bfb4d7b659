// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/share_fit.h"

#include "frontend/sema/names/values.h"
#include "ir/core/share_messages.h"
#include "platforms/load/modem.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/vehicle.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace glider::frontend {
namespace {

/// Whether the messages of a mission can be sent by the modem of its vehicle.
class ShareFit {
 public:
  ShareFit(const ast::File& file, Scope& scope)
      : file_(file), scope_(scope), modem_(scope.platform().modem) {}

  void check() {
    const ast::Share* any = firstShare(file_, {});
    if (any == nullptr) {
      return;
    }
    const ast::Share& first = *any;
    if (!modem_) {
      scope_.report(support::diagnostics::noModem, first.where, scope_.platform().name);
      return;
    }
    const platforms::PlatformSensor* clock = findTimestamp(scope_.platform());
    if (clock == nullptr) {
      scope_.report(support::diagnostics::unknownSensor, first.where, scope_.platform().name, "utc",
                    "vehicles take turns by the time of the calendar");
      return;
    }
    if (!scope_.mission.shares.empty()) {
      scope_.mission.utc = scope_.subscribe(*clock, clock->name);
    }
    for (const ir::ShareMessage& message : ir::messagesOf(scope_.mission)) {
      check(message);
    }
  }

 private:
  void check(const ir::ShareMessage& message) {
    const std::span<const ir::Share> shares =
        std::span(scope_.mission.shares).subspan(message.first, message.count);
    const ir::Share& last =
        *std::ranges::max_element(shares, {}, [](const ir::Share& s) { return s.range.begin; });
    const ast::Share& node = *firstShare(file_, last.name);
    const std::string every = scope_.text(node.every.where);
    const double slot_s = platforms::slotOf(*modem_, scope_.platform().envelope.cycle_s);
    if (last.period_s < slot_s) {
      scope_.report(
          support::diagnostics::sharePeriod, node.every.where, last.name, every,
          fmt::format("a slot, with the message and its way through the water, is {:g} s long",
                      slot_s),
          fmt::format("write `every {:g} s` or more, and in a fleet of n vehicles n times as much",
                      slot_s));
    }
    if (message.bytes == 0 || message.bytes > modem_->frame_bytes) {
      scope_.report(support::diagnostics::shareTooLarge, last.range, every,
                    message.bytes == 0 ? fmt::format("more than {:g}", modem_->frame_bytes)
                                       : fmt::format("{}", message.bytes),
                    fmt::format("{:g}", modem_->frame_bytes));
    }
  }

  const ast::File& file_;
  Scope& scope_;
  const std::optional<platforms::Modem>& modem_;
};

}  // namespace

const ast::Share* firstShare(const ast::File& file, std::string_view name) {
  for (const ast::Item& item : file.items) {
    const auto* share = std::get_if<ast::Share>(&item);
    if (share != nullptr && (name.empty() || share->name.text == name)) {
      return share;
    }
  }
  return nullptr;
}

void checkShareFit(const ast::File& file, Scope& scope) {
  ShareFit(file, scope).check();
}

}  // namespace glider::frontend
