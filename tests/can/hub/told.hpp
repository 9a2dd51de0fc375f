#pragma once

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <linux/can.h>

#include "can/hub/medium/medium.hpp"
#include "can/port/wire.hpp"
#include "tests/fakes/candump.hpp"

namespace told {

using namespace std::chrono_literals;

/// The time at which a test begins.
inline constexpr canopen::TimePoint kStart{1000s};

/// The frame that @p text, in candump's notation, describes.
inline can_frame wire(std::string_view text) {
  return bus::to_wire(fakes::frame_of(text));
}

/// @p frame in candump's notation.
inline std::string text_of(const can_frame& frame) {
  return fakes::candump(bus::from_wire(frame));
}

/// A passage of the frame @p text from @p sender.
inline hub::Passage passage(hub::Participant& sender, std::string_view text) {
  hub::Passage passage;
  passage.frame = wire(text);
  passage.sender = &sender;
  return passage;
}

/// A participant that keeps what it sees, and does what a test wants at each frame.
class Listener final : public hub::Participant {
 public:
  std::vector<std::string> seen;       ///< in candump's notation
  std::vector<hub::Passage> passages;  ///< the same, whole
  unsigned rooms = 0;                  ///< calls of on_room()
  hub::Identity who;
  std::function<void(const hub::Passage&)> at_frame;
  std::function<void()> at_room;

  void receive(const hub::Passage& passage) noexcept override {
    seen.push_back(text_of(passage.frame));
    passages.push_back(passage);
    if (at_frame) at_frame(passage);
  }
  [[nodiscard]] hub::Identity identity() const noexcept override { return who; }
  void on_room() noexcept override {
    ++rooms;
    if (at_room) at_room();
  }
};

/// AXISD_TEST_SEED, else a new seed for random tests.
inline unsigned seed() {
  const char* const wanted = std::getenv("AXISD_TEST_SEED");
  return wanted != nullptr ? static_cast<unsigned>(std::strtoul(wanted, nullptr, 10)) : std::random_device{}();
}

}  // namespace told
