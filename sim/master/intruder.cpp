#include "sim/master/intruder.hpp"

#include <array>
#include <chrono>

namespace sim {
namespace {

/// Identifiers without the node-ID: EMCY, PDOs, both ways of SDO, error control.
constexpr std::array<std::uint32_t, 12> kServices{0x080, 0x180, 0x200, 0x280, 0x300, 0x380,
                                                  0x400, 0x500, 0x580, 0x600, 0x600, 0x700};
/// Broadcast: NMT with a command that there is not, SYNC with and without counter, TIME, LSS.
constexpr std::array<std::uint32_t, 4> kBroadcasts{0x000, 0x080, 0x100, 0x7E5};

}  // namespace

Intruder::Intruder(hub::Medium& medium, std::uint8_t node_id, canopen::TimePoint calm, Draw draw)
    : Station{medium, "intruder", draw}, node_id_{node_id}, calm_{calm}, task_{intrude()} {
  task_.start();
}

Task<Done> Intruder::intrude() {
  while (now() < calm_) {
    co_await sleep(std::chrono::microseconds{draw().between(200, 200'000)});
    const auto burst = draw().chance(0.1) ? draw().between(2, 40) : 1;
    for (std::int64_t i = 0; i < burst; ++i) send(next_frame());
  }
  co_return Done{};
}

canopen::Frame Intruder::next_frame() noexcept {
  canopen::Frame frame;
  const bool is_broadcast = draw().chance(0.1);
  frame.id = is_broadcast ? draw().one_of(kBroadcasts) : draw().one_of(kServices) + node_id_;
  frame.length = static_cast<std::uint8_t>(draw().chance(0.7) ? 8 : draw().below(9));
  for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(draw().below(256));
  if (frame.id == 0) frame.data[0] = 0x7F;  // a command that would stop nodes is a leader's
  frame.remote = draw().chance(0.02);
  return frame;
}

}  // namespace sim
