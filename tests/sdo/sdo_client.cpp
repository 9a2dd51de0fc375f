#include "tests/sdo/sdo_client.hpp"

#include <gtest/gtest.h>

#include "libcanopen/base/little_endian.hpp"
#include "tests/fakes/candump.hpp"

namespace sdo_test {
namespace {

using canopen::Frame;

constexpr std::uint8_t kAbort = 0x80;
constexpr std::uint8_t kExpedited = 0x02;
constexpr std::uint8_t kToggle = 0x10;
constexpr std::uint8_t kLast = 0x01;

}  // namespace

std::uint64_t Upload::number() const {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) value |= std::uint64_t{bytes[i]} << (8 * i);
  return value;
}

Frame SdoClient::request(std::uint8_t command, std::uint16_t index, std::uint8_t sub_index,
                         std::uint32_t value) const {
  Frame frame{.id = request_, .length = 8};
  frame.data[0] = command;
  canopen::store(&frame.data[1], index);
  frame.data[3] = sub_index;
  canopen::store(&frame.data[4], value);
  return frame;
}

/// The answer to @p request, an abort with code FFFFFFFFh if there is none.
Frame SdoClient::answer_to(const Frame& request) {
  if (const auto answer = ask(request)) return *answer;
  ADD_FAILURE() << "no answer to " << fakes::candump(request);
  return {.data = {kAbort, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF}};
}

Upload SdoClient::upload(std::uint16_t index, std::uint8_t sub_index) {
  Upload result;
  Frame answer = answer_to(request(0x40, index, sub_index));
  const auto word = canopen::load<std::uint32_t>(&answer.data[4]);
  if (answer.data[0] == kAbort) return {.abort_code = word};
  if ((answer.data[0] & kExpedited) != 0) {
    const auto unused = static_cast<std::ptrdiff_t>(answer.data[0] >> 2 & 3);
    result.bytes.assign(answer.data.begin() + 4, answer.data.end() - unused);
    return result;
  }
  std::uint8_t toggle = 0;
  do {
    answer = answer_to(request(static_cast<std::uint8_t>(0x60 | toggle), 0, 0));
    if (answer.data[0] == kAbort) return {.abort_code = canopen::load<std::uint32_t>(&answer.data[4])};
    const auto unused = static_cast<std::ptrdiff_t>(answer.data[0] >> 1 & 7);
    result.bytes.insert(result.bytes.end(), answer.data.begin() + 1, answer.data.end() - unused);
    toggle ^= kToggle;
  } while ((answer.data[0] & kLast) == 0);
  EXPECT_EQ(result.bytes.size(), word) << "size announced";
  return result;
}

std::uint32_t SdoClient::download(std::uint16_t index, std::uint8_t sub_index, std::uint32_t value,
                                  unsigned size) {
  const auto command = static_cast<std::uint8_t>(0x23U | (4 - size) << 2);
  const Frame answer = answer_to(request(command, index, sub_index, value));
  return answer.data[0] == kAbort ? canopen::load<std::uint32_t>(&answer.data[4]) : 0;
}

}  // namespace sdo_test
