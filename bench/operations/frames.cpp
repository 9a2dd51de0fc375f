#include "bench/operations/frames.hpp"

#include <algorithm>
#include <random>

namespace bench {

bool answers(const canopen::Frame& answer, const canopen::Frame& request, std::uint32_t value) noexcept {
  const canopen::sdo::Address at = canopen::sdo::address_in(request);
  const canopen::sdo::Address told = canopen::sdo::address_in(answer);
  constexpr std::uint8_t kExpedited = 0x43;
  return (answer.data[0] & kExpedited) == kExpedited && told.index == at.index && told.sub_index == at.sub_index &&
         canopen::load<std::uint32_t>(&answer.data[4]) == value;
}

std::vector<canopen::Frame> random_uploads(const canopen::Dictionary& dictionary) {
  constexpr std::size_t kRequests = 1024;
  std::vector<canopen::Frame> every;
  for (const canopen::Entry& entry : dictionary.entries()) {
    if (!entry.readable || entry.size == 0 || entry.size > 4) continue;
    every.push_back(sdo_request(dictionary.node_id(), kUpload, {entry.index, entry.sub_index}));
  }
  std::mt19937 random{1};
  std::vector<canopen::Frame> chosen;
  while (chosen.size() < kRequests) {
    std::shuffle(every.begin(), every.end(), random);
    const std::size_t taken = std::min(every.size(), kRequests - chosen.size());
    chosen.insert(chosen.end(), every.begin(), every.begin() + static_cast<std::ptrdiff_t>(taken));
  }
  return chosen;
}

}  // namespace bench
