// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign.h"

#include <deque>
#include <memory>
#include <mutex>
#include <vector>

namespace glider::campaign::testing {

/// The messages under way between ranks that are threads of this process.
struct Post {
  explicit Post(size_t size) : boxes(size) {}
  std::mutex mutex;
  std::vector<std::deque<Message>> boxes;  ///< of each rank
};

/// One of these ranks.
class JoinedRanks final : public Ranks {
 public:
  JoinedRanks(std::shared_ptr<Post> post, size_t rank) : post_(std::move(post)), rank_(rank) {}
  [[nodiscard]] size_t rank() const override { return rank_; }
  [[nodiscard]] size_t size() const override { return post_->boxes.size(); }
  using Ranks::send;
  void send(size_t to, MessageKind kind, const std::string& text) override {
    const std::scoped_lock lock(post_->mutex);
    post_->boxes.at(to).push_back({rank_, kind, text});
  }
  std::optional<Message> receive() override {
    const std::scoped_lock lock(post_->mutex);
    auto& box = post_->boxes.at(rank_);
    if (box.empty()) {
      return std::nullopt;
    }
    Message first = box.front();
    box.pop_front();
    return first;
  }
  void leave() override {}
  void abort(int) override {}

 private:
  std::shared_ptr<Post> post_;
  size_t rank_;
};

}  // namespace glider::campaign::testing
