#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/base/frame.hpp"
#include "libcanopen/od/dictionary.hpp"
#include "libcanopen/sdo/command.hpp"

namespace bench {

/// Command bytes of the requests that are measured (CiA 301, 7.2.4.3).
inline constexpr std::uint8_t kUpload = 0x40;
inline constexpr std::uint8_t kDownloadDone = 0x60;

/// Command byte of an expedited download of @p size bytes, 1..4.
constexpr std::uint8_t expedited_download(unsigned size) noexcept {
  return static_cast<std::uint8_t>(0x23U | (4 - size) << 2);
}

/// The bus of a measured node: counts frames and keeps the last one.
class CountingSink final : public canopen::FrameSink {
 public:
  void send(const canopen::Frame& frame, canopen::Delivery) override {
    last = frame;
    ++count;
  }
  canopen::Frame last;
  std::uint64_t count = 0;
};

/// Throws if @p holds is false: what would be measured is not what it claims to be.
inline void check(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error{"wrong effect: " + what};
}

/// An SDO request of eight bytes to @p node_id.
inline canopen::Frame sdo_request(std::uint8_t node_id, std::uint8_t command, canopen::sdo::Address at,
                                  std::uint32_t word = 0) noexcept {
  return canopen::sdo::response(canopen::function_code::kSdoRequest + node_id, command, at, word);
}

/// True if @p answer is the expedited upload response to @p request with the four value bytes @p value.
bool answers(const canopen::Frame& answer, const canopen::Frame& request, std::uint32_t value) noexcept;

/// Upload requests in a random order that is always the same, one each for 1024 expedited numbers of @p dictionary
/// (some twice if there are fewer).
std::vector<canopen::Frame> random_uploads(const canopen::Dictionary& dictionary);

}  // namespace bench
