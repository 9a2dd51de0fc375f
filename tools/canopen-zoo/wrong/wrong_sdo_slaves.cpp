#include "tools/canopen-zoo/slave/defects.hpp"
#include "tools/canopen-zoo/slave/sdo_defects.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {
namespace {

using Table = std::vector<canopen::EntryDescription>;

constexpr std::uint16_t kDeviceType = 0x1000, kReserved = 0x1004, kGuardTime = 0x100C, kDeviceName = 0x1008;
constexpr std::uint32_t kHighestNodeId = 127;

/// Answers frames that @p foolish describes as if they asked for 1000h.
Defect answers_all(const std::function<bool(const Slave&, const canopen::Frame&)>& foolish) {
  return {.incoming = [=](Slave& slave, canopen::Frame& frame) {
    if (!foolish(slave, frame)) return true;
    slave.say(answer(slave, 0x43, kDeviceType));
    return false;
  }};
}

/// Never toggles while it uploads 1008h.
Defect never_toggles() {
  return {.incoming =
              [](Slave& slave, canopen::Frame& frame) {
                if (frame.id == slave.cob_id(kSdoRequest) && (frame.data[0] & 0xE0) == 0x40)
                  slave.memory["upload"] = is_request(slave, frame, 0x40, kDeviceName) ? 1 : 0;
                return true;
              },
          .outgoing =
              [](Slave& slave, canopen::Frame& frame) {
                if (frame.id == slave.cob_id(kSdoResponse) && slave.memory["upload"] == 1 &&
                    (frame.data[0] & 0xF0) == 0x10)
                  frame.data[0] &= 0xEF;
                return true;
              }};
}

/// Answers a segment behind an abort about 1000h, though there is no transfer.
Defect answers_stray_segments() {
  return {.incoming = [](Slave& slave, canopen::Frame& frame) {
    if (frame.id != slave.cob_id(kSdoRequest)) return true;
    const bool stray = slave.memory["stray"] == 1 && frame.data[0] == 0x60;
    slave.memory["stray"] = is_request(slave, frame, kAbortCommand, kDeviceType) ? 1 : 0;
    if (stray) slave.say(answer(slave, 0x01));
    return !stray;
  }};
}

/// Confirms that 0000h was written to 0000h, not to 100Ch.
Defect confirms_another_entry() {
  return {.incoming =
              [](Slave& slave, canopen::Frame& frame) {
                if (frame.id == slave.cob_id(kSdoRequest))
                  slave.memory["zero"] = is_request(slave, frame, 0x2B, kGuardTime) && frame.data[4] == 0 ? 1 : 0;
                return true;
              },
          .outgoing =
              [](Slave& slave, canopen::Frame& frame) {
                if (slave.memory["zero"] == 1 && is_answer(slave, frame, 0x60, kGuardTime))
                  frame = answer(slave, 0x60);
                return true;
              }};
}

/// Refuses to begin anew directly behind the initiation of an upload of 1008h.
Defect refuses_new_transfers() {
  return {.incoming = [](Slave& slave, canopen::Frame& frame) {
    if (frame.id != slave.cob_id(kSdoRequest)) return true;
    const std::int64_t now = slave.now().time_since_epoch().count();
    const std::int64_t second = canopen::Duration{std::chrono::seconds{1}}.count();
    const bool busy = slave.memory["until"] > now && is_request(slave, frame, 0x40, kDeviceType);
    slave.memory["until"] = is_request(slave, frame, 0x40, kDeviceName) ? now + second : 0;
    if (busy) slave.say(answer(slave, kAbortCommand, kDeviceType, 0, 0x08000022));
    return !busy;
  }};
}

std::vector<WrongSlave> that_refuse_wrongly() {
  return {
      {.name = "HasAnotherCodeForAbsentObjects",
       .what = "It refuses 1004h, which does not exist, with 06090011h.",
       .defect = aborts_with(kReserved, 0, 0x06020000, 0x06090011),
       .found_by = {"sdo.absent-object"}},
      {.name = "HasAnotherCodeForAbsentSubIndices",
       .what = "It refuses 1000h:01, which does not exist, with 06020000h.",
       .defect = aborts_with(kDeviceType, 1, 0x06090011, 0x06020000),
       .found_by = {"sdo.absent-sub-index"}},
      {.name = "IgnoresUnknownCommands",
       .what = "It does not answer SDO requests with the command bytes E0h and FFh, which do not exist.",
       .defect = {.incoming =
                      [](Slave& slave, canopen::Frame& frame) {
                        return !is_request(slave, frame, 0xE0, kDeviceType) &&
                               !is_request(slave, frame, 0xFF, kDeviceType);
                      }},
       .found_by = {"sdo.command-specifier"}},
      {.name = "ReadsWhatIsWriteOnly",
       .what = "It answers uploads of 2005h, which is write only.",
       .defect = answers(0x40, kWriteOnly, 0, 0x4B),
       .found_by = {"sdo.write-only"}},
      {.name = "TakesConstants",
       .what = "It confirms downloads to 1018h:01, which is a constant, and forgets them.",
       .defect = answers(0x23, 0x1018, 1, 0x60),
       .found_by = {"sdo.read-only"}},
      {.name = "TakesTooMuch",
       .what = "It confirms three bytes for 100Ch, which has two, and forgets them.",
       .defect = answers(0x27, kGuardTime, 0, 0x60),
       .found_by = {"sdo.too-long"}},
      {.name = "TakesTooLittle",
       .what = "It confirms one byte for 100Ch, which has two, and forgets it.",
       .defect = answers(0x2F, kGuardTime, 0, 0x60),
       .found_by = {"sdo.too-short"}},
      {.name = "HasNoHighLimit",
       .what = "It takes values for 2002h that are above the limit of its EDS.",
       .defect = {.table = [](Table& table) { row(table, kLimited).high = std::nullopt; }},
       .found_by = {"sdo.high-limit"}},
      {.name = "HasNoLowLimit",
       .what = "It takes values for 2002h that are below the limit of its EDS.",
       .defect = {.table = [](Table& table) { row(table, kLimited).low = std::nullopt; }},
       .found_by = {"sdo.low-limit"}},
      {.name = "TellsOtherIdentifiers",
       .what = "1200h:01 tells another identifier than it hears requests under.",
       .defect = changes_answer(0x43, 0x1200, 1, [](canopen::Frame& frame) { frame.data[4] = 0x06; }),
       .found_by = {"sdo.server-1"}},
      {.name = "AbortsWithoutTheEntry",
       .what = "Its aborts about 1004h name index 0000h.",
       .defect = changes_answer(kAbortCommand, kReserved, 0,
                                [](canopen::Frame& frame) { frame.data[1] = frame.data[2] = 0; }),
       .found_by = {"sdo.abort-entry"}},
      {.name = "AbortsTwice",
       .what = "It aborts requests about 1004h twice.",
       .defect = {.outgoing =
                      [](Slave& slave, canopen::Frame& frame) {
                        if (is_answer(slave, frame, kAbortCommand, kReserved)) slave.say(frame);
                        return true;
                      }},
       .found_by = {"sdo.one-abort"}},
  };
}

std::vector<WrongSlave> that_transfer_wrongly() {
  return {
      {.name = "HasWrongCommandBytes",
       .what = "Its expedited answer about 2002h has a reserved bit of the command byte set.",
       .defect = changes_answer(0x4B, kLimited, 0, [](canopen::Frame& frame) { frame.data[0] = 0x5B; }),
       .found_by = {"sdo.expedited-upload"}},
      {.name = "LeavesRubbishBehindTheData",
       .what = "The unused bytes of its expedited answer about 2002h are not 0.",
       .defect = changes_answer(0x4B, kLimited, 0, [](canopen::Frame& frame) { frame.data[7] = 0xAA; }),
       .found_by = {"sdo.unused-bytes"}},
      {.name = "AnnouncesAnotherSize",
       .what = "It announces one byte more than it sends of 1008h.",
       .defect = changes_answer(0x41, kDeviceName, 0, [](canopen::Frame& frame) { ++frame.data[4]; }),
       .found_by = {"sdo.announced-size"}},
      {.name = "NeverToggles",
       .what = "The toggle bit stays 0 in its upload of 1008h.",
       .defect = never_toggles(),
       .found_by = {"sdo.toggle-bit"}},
      {.name = "ForgivesToggleBitsOfUploads",
       .what = "It answers upload segments whose toggle bit is wrong.",
       .defect = forgives(0x05030000, 0x60, 0x7F, 0x00),
       .found_by = {"sdo.upload-toggle-error"}},
      {.name = "ForgivesToggleBitsOfDownloads",
       .what = "It confirms download segments whose toggle bit is wrong.",
       .defect = forgives(0x05030000, 0x00, 0x1F, 0x30),
       .found_by = {"sdo.download-toggle-error"}},
      {.name = "ForgivesMoreThanAnnounced",
       .what = "It confirms a download of more bytes than were announced.",
       .defect = forgives(0x06070012, 0x00, 0x1F, 0x20),
       .found_by = {"sdo.more-than-announced"}},
      {.name = "ForgivesLessThanAnnounced",
       .what = "It confirms a download of fewer bytes than were announced.",
       .defect = forgives(0x06070013, 0x00, 0x1F, 0x20),
       .found_by = {"sdo.less-than-announced"}},
      {.name = "ConfirmsAnotherEntry",
       .what = "When 0 is written to 100Ch, it confirms a write to 0000h.",
       .defect = confirms_another_entry(),
       .found_by = {"sdo.expedited-download"}},
      {.name = "NeedsTheNumberOfBytes",
       .what = "It refuses expedited downloads to 1006h that do not tell their number of bytes.",
       .defect = answers(0x22, 0x1006, 0, kAbortCommand, 0x06070010),
       .found_by = {"sdo.unsized-download"}},
      {.name = "TakesNoShortSegments",
       .what = "It refuses segmented downloads to 100Ch, whose value would fit an expedited one.",
       .defect = answers(0x21, kGuardTime, 0, kAbortCommand, 0x06070010),
       .found_by = {"sdo.short-segmented-download"}},
      {.name = "TakesNoTextInSegments",
       .what = "It refuses segmented downloads to 2004h that announce their size.",
       .defect = answers(0x21, kText, 0, kAbortCommand, 0x06070010),
       .found_by = {"sdo.segmented-download"}},
      {.name = "NeedsAnAnnouncedSize",
       .what = "It refuses segmented downloads to 2004h that do not announce their size.",
       .defect = answers(0x20, kText, 0, kAbortCommand, 0x06070010),
       .found_by = {"sdo.unannounced-size"}},
  };
}

std::vector<WrongSlave> that_take_frames_wrongly() {
  return {
      {.name = "RefusesNewTransfers",
       .what = "For a second after an upload of 1008h began it refuses to begin one of 1000h.",
       .defect = refuses_new_transfers(),
       .found_by = {"sdo.new-transfer"}},
      {.name = "AnswersStraySegments",
       .what = "Behind an abort about 1000h it answers a segment of a transfer that does not exist.",
       .defect = answers_stray_segments(),
       .found_by = {"sdo.segment-without-transfer"}},
      {.name = "AnswersAborts",
       .what = "It answers an abort of the client about 1008h with an abort.",
       .defect = answers(kAbortCommand, kDeviceName, 0, kAbortCommand, 0x08000000),
       .found_by = {"sdo.client-abort"}},
      {.name = "TimesOutWithAnotherCode",
       .what = "It ends a transfer whose client is silent with 05040001h instead of 05040000h.",
       .defect = {.policy = [](canopen::Policy& policy) { policy.sdo_timeout = std::chrono::seconds{1}; },
                  .outgoing =
                      [](Slave& slave, canopen::Frame& frame) {
                        if (is_abort(slave, frame, 0x05040000)) frame.data[4] = 1;
                        return true;
                      }},
       .found_by = {"sdo.silent-client"}},
      {.name = "HangsOnShortRequests",
       .what = "After a read request of 1000h in fewer than eight bytes it is silent until a reset.",
       .defect = hangs_on([](const Slave& slave, const canopen::Frame& frame) {
         return frame.id == slave.cob_id(kSdoRequest) && !frame.remote && frame.length < 8 &&
                frame.data[0] == 0x40 && frame.data[2] == 0x10 && frame.data[1] == 0;
       }),
       .found_by = {"sdo.short-request"}},
      {.name = "AnswersRemoteFrames",
       .what = "It answers remote frames under the identifier of its SDO requests.",
       .defect = answers_all([](const Slave& slave, const canopen::Frame& frame) {
         return frame.id == slave.cob_id(kSdoRequest) && frame.remote;
       }),
       .found_by = {"sdo.remote-request"}},
      {.name = "AnswersForAnotherNode",
       .what = "It answers SDO requests to other nodes under its own identifier.",
       .defect = answers_all([](const Slave& slave, const canopen::Frame& frame) {
         return frame.id > kSdoRequest && frame.id <= kSdoRequest + kHighestNodeId &&
                frame.id != slave.cob_id(kSdoRequest);
       }),
       .found_by = {"sdo.other-nodes"}},
  };
}

}  // namespace

std::vector<WrongSlave> wrong_sdo_slaves() {
  std::vector<WrongSlave> all;
  for (const auto slaves : {that_refuse_wrongly, that_transfer_wrongly, that_take_frames_wrongly})
    for (WrongSlave& slave : slaves()) all.push_back(std::move(slave));
  return all;
}

}  // namespace zoo
