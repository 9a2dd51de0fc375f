#include "can/port/multicast/multicast_message.hpp"

#include <algorithm>
#include <exception>

#include <nlohmann/json.hpp>

namespace bus::multicast {

namespace {

using Map = nlohmann::ordered_json;  // python-can's order of keys

constexpr const char* kIdentifier = "arbitration_id";
constexpr const char* kExtended = "is_extended_id";
constexpr const char* kRemote = "is_remote_frame";
constexpr const char* kError = "is_error_frame";
constexpr const char* kLength = "dlc";
constexpr const char* kData = "data";
constexpr const char* kFd = "is_fd";

/// The flag @p key of @p map; nothing if it is no truth value.
std::optional<bool> flag(const Map& map, const char* key) {
  const auto found = map.find(key);
  return found != map.end() && found->is_boolean() ? std::optional{found->get<bool>()} : std::nullopt;
}

/// The number @p key of @p map; nothing if it is none from 0 to @p highest.
std::optional<std::uint32_t> number(const Map& map, const char* key, std::uint32_t highest) {
  const auto found = map.find(key);
  if (found == map.end() || !found->is_number_unsigned()) return std::nullopt;
  const auto value = found->get<std::uint64_t>();
  return value <= highest ? std::optional{static_cast<std::uint32_t>(value)} : std::nullopt;
}

/// Flags of an identifier, nothing if one is missing or the frame is one of CAN FD.
std::optional<canid_t> read_flags(const Map& map) {
  const auto extended = flag(map, kExtended);
  const auto remote = flag(map, kRemote);
  const auto error = flag(map, kError);
  const bool classical = !map.contains(kFd) || flag(map, kFd) == false;
  if (!extended || !remote || !error || !classical || (*remote && *error)) return std::nullopt;
  return (*extended ? CAN_EFF_FLAG : 0U) | (*remote ? CAN_RTR_FLAG : 0U) | (*error ? CAN_ERR_FLAG : 0U);
}

std::optional<can_frame> read_frame(const Map& map) {
  if (!map.is_object()) return std::nullopt;
  const auto flags = read_flags(map);
  if (!flags) return std::nullopt;
  const bool is_standard = (*flags & (CAN_EFF_FLAG | CAN_ERR_FLAG)) == 0;
  const auto identifier = number(map, kIdentifier, is_standard ? CAN_SFF_MASK : CAN_EFF_MASK);
  const auto length = number(map, kLength, CAN_MAX_DLEN);
  const auto data = map.find(kData);
  if (!identifier || !length || data == map.end() || !data->is_binary()) return std::nullopt;
  const auto& bytes = data->get_binary();
  const bool is_remote = (*flags & CAN_RTR_FLAG) != 0;
  if (bytes.size() != (is_remote ? 0 : *length)) return std::nullopt;
  can_frame frame{};
  frame.can_id = *identifier | *flags;
  frame.len = static_cast<std::uint8_t>(*length);
  std::copy(bytes.begin(), bytes.end(), frame.data);
  return frame;
}

}  // namespace

std::vector<std::uint8_t> pack(const can_frame& frame) {
  const bool extended = (frame.can_id & CAN_EFF_FLAG) != 0;
  const bool remote = (frame.can_id & CAN_RTR_FLAG) != 0;
  const bool error = (frame.can_id & CAN_ERR_FLAG) != 0;
  const auto length = std::min<std::uint8_t>(frame.len, CAN_MAX_DLEN);
  const Map map{
      {"timestamp", 0.0},
      {kIdentifier, frame.can_id & (extended || error ? CAN_EFF_MASK : CAN_SFF_MASK)},
      {kExtended, extended},
      {kRemote, remote},
      {kError, error},
      {"channel", nullptr},
      {kLength, length},
      {kData, Map::binary({frame.data, frame.data + (remote ? 0 : length)})},
      {kFd, false},
      {"bitrate_switch", false},
      {"error_state_indicator", false},
  };
  return Map::to_msgpack(map);
}

std::optional<can_frame> unpack(std::span<const std::uint8_t> datagram) noexcept {
  if (datagram.size() > kLongestDatagram) return std::nullopt;
  try {
    return read_frame(Map::from_msgpack(datagram.begin(), datagram.end(), /*strict=*/true,
                                        /*allow_exceptions=*/false));
  } catch (const std::exception&) {
    return std::nullopt;  // some errors are thrown all the same, and there may be no memory
  }
}

}  // namespace bus::multicast
