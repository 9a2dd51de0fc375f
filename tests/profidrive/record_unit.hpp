#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "profidrive/channel/parameter_channel.hpp"
#include "profidrive/record/record.hpp"
#include "tests/device/test_unit.hpp"
#include "tests/fakes/candump.hpp"

namespace profidrive {

using Bytes = std::vector<std::uint8_t>;

/// The bytes that @p digits spell, blanks between them allowed.
inline Bytes bytes_of(std::string_view digits) {
  std::string text{digits};
  std::erase(text, ' ');
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(fakes::hexadecimal(std::string_view{text}.substr(i, 2))));
  return bytes;
}

inline std::string digits_of(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    std::array<char, 3> digits{};
    std::snprintf(digits.data(), digits.size(), "%02X", byte);
    text += digits.data();
  }
  return text;
}

/// A unit on a CAN bus that a controller reaches by records and parameter channels too.
struct RecordUnit : device::TestUnit {
  explicit RecordUnit(std::vector<device::AxisSetup> axes = std::vector<device::AxisSetup>(1))
      : TestUnit{{.node_id = 5, .axes = std::move(axes)}} {
    start();
  }

  /// The answer to @p request.
  Bytes serve(const Bytes& request) {
    return device.access_parameters(now, [&](drive::ParameterAccess& access) {
      std::array<std::uint8_t, record::kMostBytes> response{};
      const std::size_t size = record::answer(request, response, access);
      return Bytes{response.begin(), response.begin() + static_cast<std::ptrdiff_t>(size)};
    });
  }
  std::string record(std::string_view request) { return digits_of(serve(bytes_of(request))); }

  /// The answer of the channel of drive object 2 to the four words @p request, in digits as that is.
  std::string exchange(std::string_view request) {
    const Bytes bytes = bytes_of(request);
    ParameterChannel::Words words{};
    for (std::size_t i = 0; i < words.size(); ++i)
      words[i] = static_cast<std::uint16_t>(bytes[2 * i] << 8 | bytes[2 * i + 1]);
    const auto answer = device.access_parameters(
        now, [&](drive::ParameterAccess& access) { return channel.exchange(words, access); });
    Bytes out;
    for (const std::uint16_t word : answer) {
      out.push_back(static_cast<std::uint8_t>(word >> 8));
      out.push_back(static_cast<std::uint8_t>(word));
    }
    return digits_of(out);
  }

  ParameterChannel channel{2};
};

}  // namespace profidrive
