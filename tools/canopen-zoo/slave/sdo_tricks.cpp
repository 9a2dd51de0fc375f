#include "tools/canopen-zoo/slave/sdo_tricks.hpp"

namespace zoo {
namespace {

constexpr std::uint8_t kDownloaded = 0x60, kAbort = 0x80;

canopen::Frame answer(const Slave& slave, std::uint8_t command, const Write& write, std::uint32_t value) {
  canopen::Frame frame{.id = slave.cob_id(kSdoResponse), .length = 8};
  frame.data = {command, static_cast<std::uint8_t>(write.index), static_cast<std::uint8_t>(write.index >> 8U),
                write.sub_index};
  rewrite(frame, value);
  return frame;
}

}  // namespace

std::optional<Write> write_in(const Slave& slave, const canopen::Frame& frame) {
  const bool download = frame.id == slave.cob_id(kSdoRequest) && !frame.remote && (frame.data[0] & 0xE2U) == 0x22;
  if (!download) return std::nullopt;
  const unsigned unused = (frame.data[0] & 1U) != 0 ? frame.data[0] >> 2U & 3U : 0;
  Write write{static_cast<std::uint16_t>(frame.data[1] | frame.data[2] << 8U), frame.data[3], 0};
  for (unsigned i = 4 - unused; i-- > 0;) write.value = write.value << 8U | frame.data[4 + i];
  return write;
}

void rewrite(canopen::Frame& frame, std::uint32_t value) {
  for (unsigned i = 0; i < 4; ++i) frame.data[4 + i] = static_cast<std::uint8_t>(value >> 8U * i);
}

void confirm(Slave& slave, const Write& write) {
  slave.say(answer(slave, kDownloaded, write, 0));
}

void refuse(Slave& slave, const Write& write, std::uint32_t code) {
  slave.say(answer(slave, kAbort, write, code));
}

Defect pretends_to_write(Judgement which) {
  return {.incoming = [which = std::move(which)](Slave& slave, canopen::Frame& frame) {
    const auto write = write_in(slave, frame);
    if (!write || !which(slave, *write)) return true;
    confirm(slave, *write);
    return false;
  }};
}

Defect refuses_to_write(Judgement which, std::uint32_t code) {
  return {.incoming = [which = std::move(which), code](Slave& slave, canopen::Frame& frame) {
    const auto write = write_in(slave, frame);
    if (!write || !which(slave, *write)) return true;
    refuse(slave, *write, code);
    return false;
  }};
}

Defect writes_otherwise(std::function<std::optional<std::uint32_t>(Slave&, const Write&)> value) {
  return {.incoming = [value = std::move(value)](Slave& slave, canopen::Frame& frame) {
    if (const auto write = write_in(slave, frame))
      if (const auto other = value(slave, *write)) rewrite(frame, *other);
    return true;
  }};
}

Defect forgets(std::uint16_t index, std::uint8_t sub_index, std::uint32_t value) {
  return pretends_to_write([=](Slave&, const Write& write) {
    return write.index == index && write.sub_index == sub_index && write.value == value;
  });
}

std::uint32_t held(Slave& slave, std::uint16_t index, std::uint8_t sub_index) {
  return static_cast<std::uint32_t>(slave.dictionary().stored(index, sub_index).value_or(0));
}

bool operational(Slave& slave) {
  return slave.node().state() == canopen::NmtState::Operational;
}

}  // namespace zoo
