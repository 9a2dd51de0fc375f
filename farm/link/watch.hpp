#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include <nats/nats.h>

#include "farm/storage/key_value.hpp"

namespace farm {

/// What is told of the keys of a bucket: a consumer of the stream that the bucket is, which is made anew when it
/// has gone or has left something out.
class Watch {
 public:
  using OnEntry = std::function<void(const Entry&)>;
  using OnAll = std::function<void()>;

  Watch(std::string bucket, std::string pattern, OnEntry on_entry, OnAll on_all);

  /// Begins anew; what follows is about the new beginning.
  void begin() noexcept;
  [[nodiscard]] const std::string& bucket() const noexcept { return bucket_; }

  /// What makes the consumer, which sends to @p inbox: subject and body of a request.
  [[nodiscard]] std::string subject() const;
  [[nodiscard]] std::string body(const std::string& inbox) const;

  /// The server has answered @p answer to that request.
  void on_made(std::string_view answer);
  /// @p message has come to the inbox.
  void on_message(natsMsg* message);
  /// Time has passed, kTick.
  void on_tick() noexcept;
  /// It cannot go on: it is to begin anew.
  void lose() noexcept { is_lost_ = true; }
  [[nodiscard]] bool is_lost() const noexcept { return is_lost_; }

 private:
  void take_entry(natsMsg* message);
  void take_heartbeat(natsMsg* message);
  void tell_all();

  std::string bucket_;
  std::string pattern_;
  OnEntry on_entry_;
  OnAll on_all_;
  std::uint64_t told_ = 0;  ///< messages by the consumer
  int silent_ticks_ = 0;
  bool is_complete_ = false;  ///< all that was there at the beginning was told
  bool is_lost_ = false;
};

}  // namespace farm
