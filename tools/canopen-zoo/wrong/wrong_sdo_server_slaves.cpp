#include "tools/canopen-zoo/slave/sdo_defects.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {
namespace {

constexpr std::uint16_t kServer = 0x1201, kDeviceType = 0x1000;
constexpr std::uint32_t kFreeRequest = 0x6A0, kFreeResponse = 0x6A1;

/// The number in the last four bytes of a request.
std::uint32_t word_in(const canopen::Frame& frame) {
  return canopen::load<std::uint32_t>(&frame.data[4]);
}

/// True for a frame under the identifier of the second server, which is valid.
bool asks_second_server(Slave& slave, const canopen::Frame& frame) {
  return frame.id == static_cast<std::uint32_t>(slave.dictionary().stored(kServer, 1).value_or(0));
}

/// True for a download of four bytes to the request identifier of the second server.
bool sets_request(const Slave& slave, const canopen::Frame& frame) {
  return is_request(slave, frame, 0x23, kServer, 1);
}

/// Keeps the identifier that the second server had before a reset of the communication.
Defect keeps_identifiers() {
  return {.incoming =
              [](Slave& slave, canopen::Frame& frame) {
                if (frame.id == 0) slave.memory["command"] = frame.data[0];
                if (sets_request(slave, frame)) slave.memory["request"] = word_in(frame);
                return true;
              },
          .after_reset =
              [](Slave& slave) {
                if (slave.memory["command"] == 0x82 && slave.memory["request"] == kFreeRequest)
                  slave.dictionary().set(*slave.dictionary().lookup(kServer, 1), kFreeRequest);
              }};
}

/// Confirms identifiers of the second server that it should refuse, if @p foolish says so.
Defect takes_identifiers(const std::function<bool(const Slave&, std::uint32_t)>& foolish) {
  return {.incoming = [=](Slave& slave, canopen::Frame& frame) {
    if (!sets_request(slave, frame) || !foolish(slave, word_in(frame))) return true;
    slave.say(answer(slave, 0x60, kServer, 1));
    return false;
  }};
}

/// Refuses the identifiers that no service of the predefined connection set has; takes those of other nodes.
Defect takes_predefined_identifiers_only() {
  Defect defect{.policy = [](canopen::Policy& policy) { policy.predefined_sdo_identifiers = true; }};
  defect.incoming = [](Slave& slave, canopen::Frame& frame) {
    if (!sets_request(slave, frame) || word_in(frame) != kFreeRequest) return true;
    slave.say(answer(slave, kAbortCommand, kServer, 1, 0x06090030));
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
    canopen::Frame said = answer(slave, 0x43, kDeviceType);
    said.id = kFreeResponse;
    slave.say(said);
    return false;
  }};
}

/// Ends the transfer of the first server when the second one is asked.
Defect has_one_transfer() {
  return {.incoming = [](Slave& slave, canopen::Frame& frame) {
    canopen::Frame abort = answer(slave, kAbortCommand);
    abort.id = slave.cob_id(kSdoRequest);
    if (asks_second_server(slave, frame)) slave.node().on_frame(abort, slave.now());
    return true;
  }};
}

}  // namespace

std::vector<WrongSlave> wrong_sdo_server_slaves() {
  return {
      {.name = "HasAnotherCodeForAbsentServers",
       .what = "It refuses 1203h, a server that does not exist, with 06090011h.",
       .defect = aborts_with(0x1203, 1, 0x06020000, 0x06090011),
       .found_by = {"sdo.servers"}},
      {.name = "TakesPredefinedIdentifiersOnly",
       .what = "It refuses 6A0h, which is free, for its second SDO server.",
       .defect = takes_predefined_identifiers_only(),
       .found_by = {"sdo.server-identifiers"}},
      {.name = "HasASilentSecondServer",
       .what = "Its second SDO server does not answer.",
       .defect = {.incoming = [](Slave& slave,
                                 canopen::Frame& frame) { return !asks_second_server(slave, frame); }},
       .found_by = {"sdo.second-server"}},
      {.name = "HasOneTransferForAllServers",
       .what = "A request to its second SDO server ends the transfer of the first.",
       .defect = has_one_transfer(),
       .found_by = {"sdo.interleaved-servers"}},
      {.name = "AnswersWhileTheServerIsOff",
       .what = "It answers requests under 6A0h after that identifier of its second SDO server was switched off.",
       .defect = answers_while_off(),
       .found_by = {"sdo.server-disabled"}},
      {.name = "KeepsIdentifiersOverAReset",
       .what = "6A0h for its second SDO server survives Reset communication.",
       .defect = keeps_identifiers(),
       .found_by = {"sdo.server-reset"}},
      {.name = "TakesRestrictedIdentifiersForServers",
       .what = "It confirms restricted identifiers for its second SDO server, but not that of its first.",
       .defect = takes_identifiers([](const Slave& slave, std::uint32_t identifier) {
         return canopen::is_restricted(identifier) && identifier != slave.cob_id(kSdoRequest);
       }),
       .found_by = {"sdo.server-restricted"}},
      {.name = "TakesIdentifiersInUse",
       .what = "It confirms the identifier of its first SDO server for its second one.",
       .defect = takes_identifiers(
           [](const Slave& slave, std::uint32_t identifier) { return identifier == slave.cob_id(kSdoRequest); }),
       .found_by = {"sdo.server-collision"}},
  };
}

}  // namespace zoo
