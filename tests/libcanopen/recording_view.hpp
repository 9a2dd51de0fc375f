#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "libcanopen/sdo/sdo_view.hpp"

/// A view whose objects 3000h to 3FFFh are values of the application, each server with its own. Below 3000h is the
/// dictionary, from 4000h on nothing; the servers behind the first one have no dictionary from 2000h on.
class RecordingView final : public canopen::SdoView {
 public:
  using Bytes = std::vector<std::uint8_t>;

  canopen::ObjectPlace place_of(std::uint8_t server, std::uint16_t index) const noexcept override {
    using enum canopen::ObjectPlace;
    if (index < (server == 0 ? 0x3000 : 0x2000)) return Dictionary;
    return index >= 0x3000 && index < 0x4000 ? Application : Nowhere;
  }
  canopen::Result<std::size_t> read(std::uint8_t server, std::uint16_t index, std::uint8_t sub_index,
                                    std::span<std::uint8_t, 8> value) noexcept override {
    if (answer) return canopen::refuse(*answer);
    if (size_given) return *size_given;
    const auto found = values.find({server, index, sub_index});
    if (found == values.end()) return canopen::refuse(canopen::AbortCode::NoSubIndex);
    std::copy(found->second.begin(), found->second.end(), value.begin());
    return found->second.size();
  }
  canopen::Result<void> write(std::uint8_t server, std::uint16_t index, std::uint8_t sub_index,
                              std::span<const std::uint8_t> value, bool sized) noexcept override {
    if (answer) return canopen::refuse(*answer);
    values[{server, index, sub_index}] = Bytes{value.begin(), value.end()};
    told.push_back(text_of(server, index, sub_index) + " " + std::to_string(value.size()) +
                   (sized ? "" : " at most"));
    if (reaction) reaction();
    return {};
  }

  std::map<std::tuple<std::uint8_t, std::uint16_t, std::uint8_t>, Bytes> values;
  std::vector<std::string> told;             ///< every write: "0 3000:01 2", the last number is that of its bytes
  std::optional<canopen::AbortCode> answer;  ///< to every read and write
  std::optional<std::size_t> size_given;     ///< by every read
  std::function<void()> reaction;            ///< called from within every write

 private:
  static std::string text_of(std::uint8_t server, std::uint16_t index, std::uint8_t sub_index) {
    char text[16];
    std::snprintf(text, sizeof text, "%u %04X:%02X", server, index, sub_index);
    return text;
  }
};
