#pragma once

#include <array>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <linux/can/bcm.h>

#include "can/hub/broadcast/broadcast_manager.hpp"
#include "tests/can/hub/told.hpp"

namespace told {

/// What a program writes to its CAN_BCM socket.
struct Asked {
  std::uint32_t opcode = 0;
  std::string_view id = "000";  ///< as candump writes it: 123, 00000123, 123#R
  std::uint32_t flags = 0;
  std::vector<std::string> frames{};
  std::uint32_t count = 0;
  std::chrono::microseconds first{};
  std::chrono::microseconds second{};
};

inline bcm_timeval interval(std::chrono::microseconds time) {
  return {static_cast<long>(time.count() / 1'000'000), static_cast<long>(time.count() % 1'000'000)};
}

/// The bytes of @p asked.
inline std::vector<std::byte> message(const Asked& asked) {
  bcm_msg_head head{};
  head.opcode = asked.opcode;
  head.flags = asked.flags;
  head.count = asked.count;
  head.ival1 = interval(asked.first);
  head.ival2 = interval(asked.second);
  const std::string id{asked.id};
  head.can_id = wire(id.find('#') == std::string::npos ? id + '#' : id).can_id;
  head.nframes = static_cast<std::uint32_t>(asked.frames.size());
  std::vector<std::byte> bytes(sizeof head + asked.frames.size() * sizeof(can_frame));
  std::memcpy(bytes.data(), &head, sizeof head);
  for (std::size_t i = 0; i < asked.frames.size(); ++i) {
    const can_frame frame = wire(asked.frames[i]);
    std::memcpy(bytes.data() + sizeof head + i * sizeof frame, &frame, sizeof frame);
  }
  return bytes;
}

/// Keeps what a broadcast manager tells: "RX_CHANGED 123: 123#01", and the whole of the last message.
class Told final : public hub::BroadcastSink {
 public:
  std::vector<std::string> texts;
  bcm_msg_head* last() { return reinterpret_cast<bcm_msg_head*>(bytes_.data()); }
  int interface_index = -1;          ///< of the last one
  std::vector<std::uint32_t> flags;  ///< of all

  void deliver(std::span<const std::byte> message, int index) noexcept override {
    constexpr std::array kNames{"?",         "TX_SETUP",   "TX_DELETE", "TX_READ",   "TX_SEND",
                                "RX_SETUP",  "RX_DELETE",  "RX_READ",   "TX_STATUS", "TX_EXPIRED",
                                "RX_STATUS", "RX_TIMEOUT", "RX_CHANGED"};
    bytes_.assign(message.begin(), message.end());
    interface_index = index;
    flags.push_back(last()->flags);
    can_frame about{};
    about.can_id = last()->can_id;
    std::string text = std::string{kNames.at(last()->opcode)} + ' ' + text_of(about);
    text.back() = ':';  // in place of candump's #
    for (std::size_t i = 0; i < last()->nframes; ++i) {
      can_frame frame{};
      std::memcpy(&frame, bytes_.data() + sizeof(bcm_msg_head) + i * sizeof frame, sizeof frame);
      text += ' ' + text_of(frame);
    }
    EXPECT_EQ(bytes_.size(), sizeof(bcm_msg_head) + last()->nframes * sizeof(can_frame));
    texts.push_back(text);
  }
  /// What was told since the last call.
  std::vector<std::string> take() { return std::exchange(texts, {}); }

 private:
  std::vector<std::byte> bytes_;
};

/// A broadcast manager on interface 1001 of a bus without bit time, a program beside it, and told time.
class BroadcastFixture : public testing::Test {
 public:
  static constexpr int kIndex = 1001;
  using Texts = std::vector<std::string>;

  BroadcastFixture() { medium.attach(other); }

  int ask(const Asked& asked) { return manager.request(message(asked), kIndex, now); }
  /// Goes to @p time after the begin, stopping at each deadline on the way.
  void run_until(canopen::Duration time) {
    const canopen::TimePoint end = kStart + time;
    for (canopen::TimePoint due = manager.next_deadline(); due <= end; due = manager.next_deadline()) {
      now = due;
      medium.on_time(now);
      manager.on_time(now);
    }
    now = end;
    medium.on_time(now);
  }
  /// The other program sends the frame @p text.
  void arrive(std::string_view text) {
    hub::Passage arriving = passage(other, text);
    arriving.interface_index = kIndex;
    medium.send(arriving, now);
  }
  /// What the other program has seen since the last call.
  Texts sent() { return std::exchange(other.seen, {}); }

  canopen::TimePoint now = kStart;
  hub::Medium medium;
  Told told;
  Listener other;
  hub::BroadcastManager manager{medium, told};
};

}  // namespace told
