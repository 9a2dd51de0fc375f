#include "tools/canopen-zoo/slave/defects.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {
namespace {

using canopen::Frame;

constexpr std::uint32_t kMaster = 0x7E5, kSlave = 0x7E4;
constexpr std::uint8_t kSwitchGlobal = 0x04, kConfigureNodeId = 0x11, kSwitchSelective = 0x40, kSwitched = 0x44,
                       kInquireIdentity = 0x5A, kInquireNodeId = 0x5E;

std::uint32_t number_of(const Frame& frame) {
  return static_cast<std::uint32_t>(frame.data[1] | frame.data[2] << 8U | frame.data[3] << 16U) |
         std::uint32_t{frame.data[4]} << 24U;
}

void answer(Slave& slave, std::uint8_t command, std::uint32_t value) {
  Frame frame{.id = kSlave, .length = 8, .data = {command}};
  for (std::size_t i = 0; i < 4; ++i) frame.data[1 + i] = static_cast<std::uint8_t>(value >> 8U * i);
  slave.say(frame);
}

void answer_in_configuration(Slave& slave, const Frame& frame) {
  const std::uint8_t command = frame.data[0];
  if (command == kInquireNodeId) answer(slave, command, slave.node_id());
  if (command == kConfigureNodeId) answer(slave, command, frame.data[1] >= 1 && frame.data[1] <= 127 ? 0 : 1);
  if (command >= kInquireIdentity && command < kInquireIdentity + 4)
    answer(slave, command,
           static_cast<std::uint32_t>(
               stored(slave, 0x1018, static_cast<std::uint8_t>(command - kInquireIdentity + 1))));
}

/// Those services of LSS that a slave with a node-ID has.
bool serve_lss(Slave& slave, const Frame& frame) {
  if (frame.id != kMaster || frame.remote || frame.length != 8) return true;
  const std::uint8_t command = frame.data[0];
  std::int64_t& configuration = slave.memory["configuration"];
  std::int64_t& matches = slave.memory["matches"];
  if (command == kSwitchGlobal) configuration = frame.data[1];
  if (command >= kSwitchSelective && command < kSwitched) {
    const auto part = static_cast<std::uint8_t>(command - kSwitchSelective);
    const bool right = number_of(frame) == stored(slave, 0x1018, static_cast<std::uint8_t>(part + 1));
    matches = right && (part == 0 || matches == part) ? part + 1 : 0;
    if (matches == 4) answer(slave, kSwitched, 0);
    if (matches == 4) configuration = 1;
  }
  if (configuration == 1) answer_in_configuration(slave, frame);
  return true;
}

void support_lss(std::string& eds) {
  eds.replace(eds.find("LSS_Supported=0"), 15, "LSS_Supported=1");
}

/// A slave with LSS that judges the master's frames with @p incoming first, and its own with @p outgoing.
Defect lss_but(
    std::function<bool(Slave&, Frame&)> incoming,
    std::function<bool(Slave&, Frame&)> outgoing = [](auto&&...) { return true; }) {
  return {
      .eds = support_lss,
      .incoming = [incoming = std::move(incoming)](
                      Slave& slave, Frame& frame) { return incoming(slave, frame) && serve_lss(slave, frame); },
      .outgoing = std::move(outgoing)};
}

bool asks(const Frame& frame, std::uint8_t command) {
  return frame.id == kMaster && frame.length == 8 && frame.data[0] == command;
}

}  // namespace

Defect right_lss() {
  return lss_but([](auto&&...) { return true; });
}

std::vector<WrongSlave> wrong_lss_slaves() {
  return {
      {.name = "IsSelectedByNobody",
       .what = "It does not hear LSS switch state selective.",
       .defect = lss_but([](Slave&, Frame& frame) { return !asks(frame, kSwitchSelective); }),
       .found_by = {"lss.switch-selective"}},
      {.name = "IsSelectedByAnotherSerialNumber",
       .what = "LSS switch state selective finds it under any serial number.",
       .defect = lss_but([](Slave&, Frame& frame) {
         if (asks(frame, kSwitched - 1)) frame.data = {kSwitched - 1, 7};
         return true;
       }),
       .found_by = {"lss.switch-selective-others"}},
      {.name = "DoesNotFollowTheSwitchOfAllNodes",
       .what = "It does not obey LSS switch state global to configuration.",
       .defect = lss_but([](Slave&, Frame& frame) { return !(asks(frame, kSwitchGlobal) && frame.data[1] == 1); }),
       .found_by = {"lss.switch-global"}},
      {.name = "HasAnotherRevisionOverLss",
       .what = "LSS tells another revision number than 1018h:03.",
       .defect = lss_but([](Slave& slave, Frame& frame) {
         const bool wrong = asks(frame, kInquireIdentity + 2) && slave.memory["configuration"] == 1;
         if (wrong) answer(slave, frame.data[0], 0x30005);
         return !wrong;
       }),
       .found_by = {"lss.inquire-identity"}},
      {.name = "TakesNodeId128OverLss",
       .what = "LSS confirms 128 as a node-ID.",
       .defect = lss_but([](Slave& slave, Frame& frame) {
         const bool wrong = asks(frame, kConfigureNodeId) && frame.data[1] == 128;
         if (wrong) answer(slave, kConfigureNodeId, 0);
         return !wrong;
       }),
       .found_by = {"lss.node-id-refused"}},
  };
}

}  // namespace zoo
