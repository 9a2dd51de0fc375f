#include <array>

#include "libcanopen/base/nmt_state.hpp"
#include "meaning/words.hpp"

namespace meaning {
namespace {

struct Service {
  std::uint32_t function;  ///< identifier without the node-ID
  const char* name;
};
constexpr std::array kServices{
    Service{0x080, "EMCY"},  Service{0x180, "TPDO1"},        Service{0x200, "RPDO1"},      Service{0x280, "TPDO2"},
    Service{0x300, "RPDO2"}, Service{0x380, "TPDO3"},        Service{0x400, "RPDO3"},      Service{0x480, "TPDO4"},
    Service{0x500, "RPDO4"}, Service{0x580, "SDO response"}, Service{0x600, "SDO request"}};
constexpr std::uint32_t kNodes = 0x7F, kSync = 0x080, kTime = 0x100, kErrorControl = 0x700;
constexpr std::uint8_t kToggle = 0x80, kAbort = 0x80;

std::string error_control(const canopen::Frame& frame) {
  if (frame.remote) return "node guarding";
  if (frame.length != 1) return "error control";
  const auto state = static_cast<canopen::NmtState>(frame.data[0] & ~kToggle);
  return state == canopen::NmtState::Initialising ? "boot-up"
                                                  : "heartbeat " + std::string{canopen::name_of(state)};
}

std::string nmt(const canopen::Frame& frame) {
  switch (static_cast<canopen::NmtCommand>(frame.data[0])) {
    case canopen::NmtCommand::Start:
      return "NMT start";
    case canopen::NmtCommand::Stop:
      return "NMT stop";
    case canopen::NmtCommand::EnterPreOperational:
      return "NMT enter pre-operational";
    case canopen::NmtCommand::ResetNode:
      return "NMT reset node";
    case canopen::NmtCommand::ResetCommunication:
      return "NMT reset communication";
  }
  return "NMT";
}

}  // namespace

std::string service_of(const canopen::Frame& frame) {
  if (frame.extended) return "";
  if (frame.id == 0) return nmt(frame);
  if (frame.id == kSync) return "SYNC";
  if (frame.id == kTime) return "TIME";
  const std::uint32_t function = frame.id & ~kNodes;
  if (function == kErrorControl) return error_control(frame);
  for (const Service& service : kServices) {
    if (service.function != function) continue;
    const bool is_sdo = function >= kServices[kServices.size() - 2].function;
    return is_sdo && frame.data[0] == kAbort ? "SDO abort" : service.name;
  }
  return "";
}

}  // namespace meaning
