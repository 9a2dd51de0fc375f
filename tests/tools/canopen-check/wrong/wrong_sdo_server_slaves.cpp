#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tests/tools/canopen-check/slave/sdo_defects.hpp"

namespace conformance_test {
namespace {

constexpr std::uint16_t kServer = 0x1201, kDeviceType = 0x1000;
constexpr std::uint32_t kFreeRequest = 0x6A0, kFreeResponse = 0x6A1;

/// The number in the last four bytes of a request.
std::uint32_t word_in(const canopen::Frame& frame) {
  return canopen::load<std::uint32_t>(&frame.data[4]);
}

/// True for a download of four bytes to the request identifier of the second server.
bool sets_request(const canopen::Frame& frame) {
  return is_request(frame, 0x23, kServer, 1);
}

/// Keeps the identifier that the second server had before a reset of the communication.
Defect keeps_identifiers() {
  return {.incoming =
              [](Slave& slave, canopen::Frame& frame) {
                if (frame.id == 0) slave.memory["command"] = frame.data[0];
                if (sets_request(frame)) slave.memory["request"] = word_in(frame);
                return true;
              },
          .after_reset =
              [](Slave& slave) {
                if (slave.memory["command"] == 0x82 && slave.memory["request"] == kFreeRequest)
                  slave.dictionary().set(*slave.dictionary().lookup(kServer, 1), kFreeRequest);
              }};
}

/// Confirms identifiers of the second server that it should refuse, if @p foolish says so.
Defect takes_identifiers(std::function<bool(std::uint32_t)> foolish) {
  return {.incoming = [=](Slave& slave, canopen::Frame& frame) {
    if (!sets_request(frame) || !foolish(word_in(frame))) return true;
    slave.say(answer(0x60, kServer, 1));
    return false;
  }};
}

/// Refuses the identifiers that no service of the predefined connection set has; takes those of other nodes.
Defect takes_predefined_identifiers_only() {
  Defect defect{.policy = [](canopen::Policy& policy) { policy.predefined_sdo_identifiers = true; }};
  defect.incoming = [](Slave& slave, canopen::Frame& frame) {
    if (!sets_request(frame) || word_in(frame) != kFreeRequest) return true;
    slave.say(answer(kAbortCommand, kServer, 1, 0x06090030));
    return false;
  };
  return defect;
}

/// Answers under the identifier of the second server while it is switched off.
Defect answers_while_off() {
  return {.incoming = [](Slave& slave, canopen::Frame& frame) {
    if (frame.id != kFreeRequest) return true;
    const auto now = slave.dictionary().read(*slave.dictionary().lookup(kServer, 1));
    if (!now || *now != (std::int64_t{0x80000000} | kFreeRequest)) return true;
    canopen::Frame said = answer(0x43, kDeviceType);
    said.id = kFreeResponse;
    slave.say(said);
    return false;
  }};
}

/// Ends the transfer of the first server when the second one is asked.
Defect has_one_transfer() {
  return {.incoming = [](Slave& slave, canopen::Frame& frame) {
    canopen::Frame abort = answer(kAbortCommand);
    abort.id = kSdoRequest;
    if (frame.id == kFreeRequest) slave.node().on_frame(abort, slave.now());
    return true;
  }};
}

}  // namespace

std::vector<WrongSlave> wrong_sdo_server_slaves() {
  return {
      {.name = "HasAnotherCodeForAbsentServers",
       .defect = aborts_with(0x1203, 1, 0x06020000, 0x06090011),
       .found_by = {"sdo.servers"}},
      {.name = "TakesPredefinedIdentifiersOnly",
       .defect = takes_predefined_identifiers_only(),
       .found_by = {"sdo.server-identifiers"}},
      {.name = "HasASilentSecondServer",
       .defect = {.incoming = [](Slave&, canopen::Frame& frame) { return frame.id != kFreeRequest; }},
       .found_by = {"sdo.second-server"}},
      {.name = "HasOneTransferForAllServers",
       .defect = has_one_transfer(),
       .found_by = {"sdo.interleaved-servers"}},
      {.name = "AnswersWhileTheServerIsOff", .defect = answers_while_off(), .found_by = {"sdo.server-disabled"}},
      {.name = "KeepsIdentifiersOverAReset", .defect = keeps_identifiers(), .found_by = {"sdo.server-reset"}},
      {.name = "TakesRestrictedIdentifiersForServers",
       .defect = takes_identifiers([](std::uint32_t identifier) { return identifier == 0x701; }),
       .found_by = {"sdo.server-restricted"}},
      {.name = "TakesIdentifiersInUse",
       .defect = takes_identifiers([](std::uint32_t identifier) { return identifier == 0x605; }),
       .found_by = {"sdo.server-collision"}},
  };
}

}  // namespace conformance_test
