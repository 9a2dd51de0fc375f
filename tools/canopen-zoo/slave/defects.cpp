#include "tools/canopen-zoo/slave/defects.hpp"

namespace zoo {
namespace {

bool names(const canopen::Frame& frame, std::uint16_t index, std::uint8_t sub_index) {
  return (frame.data[1] | frame.data[2] << 8U) == index && frame.data[3] == sub_index;
}

canopen::Frame answer_to(const Slave& slave, const canopen::Frame& request, std::uint8_t command,
                         std::uint32_t value) {
  canopen::Frame answer{.id = slave.cob_id(kSdoResponse), .length = 8, .data = request.data};
  answer.data[0] = command;
  for (std::size_t i = 0; i < 4; ++i) answer.data[4 + i] = static_cast<std::uint8_t>(value >> 8U * i);
  return answer;
}

}  // namespace

bool is_command(const canopen::Frame& frame, canopen::NmtCommand command) {
  return frame.id == 0 && !frame.remote && frame.length == 2 &&
         frame.data[0] == static_cast<std::uint8_t>(command);
}

bool writes(const Slave& slave, const canopen::Frame& frame, std::uint16_t index, std::uint8_t sub_index) {
  return frame.id == slave.cob_id(kSdoRequest) && !frame.remote && frame.length == 8 &&
         (frame.data[0] & 0xE2U) == 0x22 && names(frame, index, sub_index);
}

bool shows(const Slave& slave, const canopen::Frame& frame, std::uint16_t index, std::uint8_t sub_index) {
  return frame.id == slave.cob_id(kSdoResponse) && (frame.data[0] & 0xE2U) == 0x42 &&
         names(frame, index, sub_index);
}

std::uint32_t value_of(const canopen::Frame& frame) {
  std::uint32_t value = 0;
  for (std::size_t i = 8; i-- > 4;) value = value << 8U | frame.data[i];
  return value;
}

void confirm(Slave& slave, const canopen::Frame& request) {
  slave.say(answer_to(slave, request, 0x60, 0));
}

void refuse(Slave& slave, const canopen::Frame& request, std::uint32_t code) {
  slave.say(answer_to(slave, request, 0x80, code));
}

void pretend(Slave& slave, const canopen::Frame& request) {
  const auto index = static_cast<std::uint16_t>(request.data[1] | request.data[2] << 8U);
  slave.dictionary().set(*slave.dictionary().lookup(index, request.data[3]), value_of(request));
  confirm(slave, request);
}

std::int64_t stored(Slave& slave, std::uint16_t index, std::uint8_t sub_index) {
  return slave.dictionary().stored(index, sub_index).value_or(0);
}

bool is_emergency(const Slave& slave, const canopen::Frame& frame, std::uint16_t code) {
  return frame.id == slave.cob_id(kEmcy) && (frame.data[0] | frame.data[1] << 8U) == code;
}

bool of_heartbeat(const canopen::Frame& emergency) {
  return emergency.data[3] != 0;
}

Defect hangs_on(const std::function<bool(const Slave&, const canopen::Frame&)>& kills, bool comes_back) {
  return {.incoming =
              [kills, comes_back](Slave& slave, canopen::Frame& frame) {
                std::int64_t& hangs = slave.memory["hangs"];
                const bool reset = frame.id == 0 && (is_command(frame, canopen::NmtCommand::ResetNode) ||
                                                     is_command(frame, canopen::NmtCommand::ResetCommunication));
                if (hangs != 0 && comes_back && reset) hangs = 0;
                if (hangs == 0 && kills(slave, frame)) hangs = 1;
                return hangs == 0;
              },
          .outgoing = [](Slave& slave, canopen::Frame&) { return slave.memory["hangs"] == 0; }};
}

}  // namespace zoo
