#pragma once

#include "libcanopen/base/little_endian.hpp"
#include "tools/canopen-zoo/slave/slave.hpp"

/// What defects of an SDO server are made of.
namespace zoo {

inline constexpr std::uint8_t kAbortCommand = 0x80;

/// True for a request of eight bytes to the first server whose command byte is @p command.
[[nodiscard]] inline bool is_request(const Slave& slave, const canopen::Frame& frame, std::uint8_t command) {
  return frame.id == slave.cob_id(kSdoRequest) && !frame.remote && frame.length == 8 && frame.data[0] == command;
}
/// The same about the entry @p index, @p sub_index.
[[nodiscard]] inline bool is_request(const Slave& slave, const canopen::Frame& frame, std::uint8_t command,
                                     std::uint16_t index, std::uint8_t sub_index = 0) {
  return is_request(slave, frame, command) && canopen::load<std::uint16_t>(&frame.data[1]) == index &&
         frame.data[3] == sub_index;
}
/// True for a frame of the first server that begins with @p command and is about the entry.
[[nodiscard]] inline bool is_answer(const Slave& slave, const canopen::Frame& frame, std::uint8_t command,
                                    std::uint16_t index, std::uint8_t sub_index = 0) {
  return frame.id == slave.cob_id(kSdoResponse) && frame.data[0] == command &&
         canopen::load<std::uint16_t>(&frame.data[1]) == index && frame.data[3] == sub_index;
}
/// True for an abort of the first server with @p code.
[[nodiscard]] inline bool is_abort(const Slave& slave, const canopen::Frame& frame, std::uint32_t code) {
  return frame.id == slave.cob_id(kSdoResponse) && frame.data[0] == kAbortCommand &&
         canopen::load<std::uint32_t>(&frame.data[4]) == code;
}

/// A frame of the first server.
[[nodiscard]] inline canopen::Frame answer(const Slave& slave, std::uint8_t command, std::uint16_t index = 0,
                                           std::uint8_t sub_index = 0, std::uint32_t word = 0) {
  canopen::Frame frame{.id = slave.cob_id(kSdoResponse), .length = 8};
  frame.data[0] = command;
  canopen::store(&frame.data[1], index);
  frame.data[3] = sub_index;
  canopen::store(&frame.data[4], word);
  return frame;
}

/// Answers requests that begin with @p command about the entry with @p reply, which the node never sees.
[[nodiscard]] inline Defect answers(std::uint8_t command, std::uint16_t index, std::uint8_t sub_index,
                                    std::uint8_t reply, std::uint32_t word = 0) {
  return {.incoming = [=](Slave& slave, canopen::Frame& frame) {
    if (!is_request(slave, frame, command, index, sub_index)) return true;
    slave.say(answer(slave, reply, index, sub_index, word));
    return false;
  }};
}

/// Refuses the entry with @p wrong instead of @p right.
[[nodiscard]] inline Defect aborts_with(std::uint16_t index, std::uint8_t sub_index, std::uint32_t right,
                                        std::uint32_t wrong) {
  return {.outgoing = [=](Slave& slave, canopen::Frame& frame) {
    if (is_answer(slave, frame, kAbortCommand, index, sub_index) && is_abort(slave, frame, right))
      canopen::store(&frame.data[4], wrong);
    return true;
  }};
}

/// Gives @p reply instead of the abort @p code where the last request began with a byte from @p first to @p last.
[[nodiscard]] inline Defect forgives(std::uint32_t code, std::uint8_t first, std::uint8_t last,
                                     std::uint8_t reply) {
  return {.incoming =
              [](Slave& slave, canopen::Frame& frame) {
                if (frame.id == slave.cob_id(kSdoRequest)) slave.memory["request"] = frame.data[0];
                return true;
              },
          .outgoing =
              [=](Slave& slave, canopen::Frame& frame) {
                const std::int64_t request = slave.memory["request"];
                if (is_abort(slave, frame, code) && request >= first && request <= last)
                  frame = answer(slave, reply);
                return true;
              }};
}

/// Changes what the server answers with @p command about the entry.
[[nodiscard]] inline Defect changes_answer(std::uint8_t command, std::uint16_t index, std::uint8_t sub_index,
                                           const std::function<void(canopen::Frame&)>& change) {
  return {.outgoing = [=](Slave& slave, canopen::Frame& frame) {
    if (is_answer(slave, frame, command, index, sub_index)) change(frame);
    return true;
  }};
}

}  // namespace zoo
