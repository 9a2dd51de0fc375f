#include "injection/wire/frame_role.hpp"

#include <algorithm>

#include "device/objects/sdo_channels.hpp"
#include "libcanopen/base/object_index.hpp"

namespace injection {
namespace {

using canopen::Identifier;

Identifier identifier_at(const device::Device& device, std::uint16_t index) noexcept {
  const auto cob_id = device.dictionary().stored(index, 0);
  return cob_id ? canopen::valid_identifier(static_cast<std::uint32_t>(*cob_id)) : 0;
}

/// Of COB-IDs whose bit 31 says something else than that they do not exist.
Identifier consumed_at(const device::Device& device, std::uint16_t index) noexcept {
  const auto cob_id = device.dictionary().stored(index, 0);
  return cob_id ? canopen::identifier_in(static_cast<std::uint32_t>(*cob_id)) : 0;
}

std::uint16_t server_of(const device::Device& device, Identifier identifier, device::SdoWay way) noexcept {
  for (std::size_t server = 0; server < device.node().sdo_servers(); ++server)
    if (device::sdo_identifier(device.dictionary(), device.node_id(), server, way) == identifier)
      return static_cast<std::uint16_t>(server + 1);
  return 0;
}

std::uint16_t pdo_of(std::span<const canopen::PdoSettings> pdos, Identifier identifier) noexcept {
  const auto found = std::ranges::find(pdos, identifier, &canopen::PdoSettings::identifier);
  return found != pdos.end() ? static_cast<std::uint16_t>(found->number + 1) : std::uint16_t{0};
}

Role role_of_sent(const device::Device& device, Identifier identifier, const canopen::Frame& frame) noexcept {
  if (identifier == canopen::function_code::kErrorControl + device.node_id())
    return {.kind = frame.data[0] == 0 ? EventKind::BootUp : EventKind::Heartbeat};
  if (const auto server = server_of(device, identifier, device::SdoWay::Response))
    return {EventKind::SdoResponse, server};
  if (identifier == identifier_at(device, canopen::object::kCobIdEmcy)) return {.kind = EventKind::Emcy};
  if (const auto pdo = pdo_of(device.node().transmit_pdos(), identifier)) return {EventKind::Tpdo, pdo};
  return {};
}

/// Whether an NMT command is for the node (CiA 301, 7.2.8.3.1.1: 0 is all of them).
bool is_for(const device::Device& device, const canopen::Frame& command) noexcept {
  return command.data[1] == 0 || command.data[1] == device.node_id();
}

/// Whether an SDO server takes a request: of eight bytes, and not in Stopped.
bool is_served(const device::Device& device, const canopen::Frame& request) noexcept {
  constexpr std::uint8_t kSdoBytes = 8;
  const canopen::NmtState state = device.node().state();
  return request.length == kSdoBytes &&
         (state == canopen::NmtState::PreOperational || state == canopen::NmtState::Operational);
}

Role role_of_received(const device::Device& device, Identifier identifier, const canopen::Frame& frame) noexcept {
  if (identifier == canopen::function_code::kNmt)
    return {.kind = is_for(device, frame) ? EventKind::Nmt : EventKind::Frame};
  if (identifier == consumed_at(device, canopen::object::kCobIdSync)) return {.kind = EventKind::Sync};
  if (identifier == consumed_at(device, canopen::object::kCobIdTime)) return {.kind = EventKind::Time};
  if (const auto server = server_of(device, identifier, device::SdoWay::Request)) {
    if (!is_served(device, frame)) return {};
    return {EventKind::SdoRequest, server};
  }
  if (const auto pdo = pdo_of(device.node().receive_pdos(), identifier)) return {EventKind::Rpdo, pdo};
  return {};
}

}  // namespace

Role role_of(const device::Device& device, const canopen::Frame& frame, bool is_sent) noexcept {
  const Identifier identifier = canopen::identifier_of(frame);
  if (frame.remote) {
    const bool guards = identifier == canopen::function_code::kErrorControl + device.node_id();
    return {.kind = guards ? EventKind::Guard : EventKind::Frame};
  }
  return is_sent ? role_of_sent(device, identifier, frame) : role_of_received(device, identifier, frame);
}

}  // namespace injection
