#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tests/tools/canopen-check/slave/defects.hpp"
#include "tests/tools/canopen-check/slave/sdo_defects.hpp"

namespace conformance_test {
namespace {

using Table = std::vector<canopen::EntryDescription>;

constexpr std::uint16_t kDeviceType = 0x1000, kReserved = 0x1004, kGuardTime = 0x100C, kDeviceName = 0x1008;

/// Answers frames that @p foolish describes as if they asked for 1000h.
Defect answers_all(std::function<bool(const canopen::Frame&)> foolish) {
  return {.incoming = [=](Slave& slave, canopen::Frame& frame) {
    if (!foolish(frame)) return true;
    slave.say(answer(0x43, kDeviceType));
    return false;
  }};
}

/// Never toggles while it uploads 1008h.
Defect never_toggles() {
  return {.incoming =
              [](Slave& slave, canopen::Frame& frame) {
                if (frame.id == kSdoRequest && (frame.data[0] & 0xE0) == 0x40)
                  slave.memory["upload"] = is_request(frame, 0x40, kDeviceName) ? 1 : 0;
                return true;
              },
          .outgoing =
              [](Slave& slave, canopen::Frame& frame) {
                if (frame.id == kSdoResponse && slave.memory["upload"] == 1 && (frame.data[0] & 0xF0) == 0x10)
                  frame.data[0] &= 0xEF;
                return true;
              }};
}

/// Answers a segment behind an abort about 1000h, though there is no transfer.
Defect answers_stray_segments() {
  return {.incoming = [](Slave& slave, canopen::Frame& frame) {
    if (frame.id != kSdoRequest) return true;
    const bool stray = slave.memory["stray"] == 1 && frame.data[0] == 0x60;
    slave.memory["stray"] = is_request(frame, kAbortCommand, kDeviceType) ? 1 : 0;
    if (stray) slave.say(answer(0x01));
    return !stray;
  }};
}

/// Confirms that 0000h was written to 0000h, not to 100Ch.
Defect confirms_another_entry() {
  return {.incoming =
              [](Slave& slave, canopen::Frame& frame) {
                if (frame.id == kSdoRequest)
                  slave.memory["zero"] = is_request(frame, 0x2B, kGuardTime) && frame.data[4] == 0 ? 1 : 0;
                return true;
              },
          .outgoing =
              [](Slave& slave, canopen::Frame& frame) {
                if (slave.memory["zero"] == 1 && is_answer(frame, 0x60, kGuardTime)) frame = answer(0x60);
                return true;
              }};
}

/// Refuses to begin anew directly behind the initiation of an upload of 1008h.
Defect refuses_new_transfers() {
  return {.incoming = [](Slave& slave, canopen::Frame& frame) {
    if (frame.id != kSdoRequest) return true;
    const std::int64_t now = slave.now().time_since_epoch().count();
    const std::int64_t second = canopen::Duration{std::chrono::seconds{1}}.count();
    const bool busy = slave.memory["until"] > now && is_request(frame, 0x40, kDeviceType);
    slave.memory["until"] = is_request(frame, 0x40, kDeviceName) ? now + second : 0;
    if (busy) slave.say(answer(kAbortCommand, kDeviceType, 0, 0x08000022));
    return !busy;
  }};
}

std::vector<WrongSlave> that_refuse_wrongly() {
  return {
      {.name = "HasAnotherCodeForAbsentObjects",
       .defect = aborts_with(kReserved, 0, 0x06020000, 0x06090011),
       .found_by = {"sdo.absent-object"}},
      {.name = "HasAnotherCodeForAbsentSubIndices",
       .defect = aborts_with(kDeviceType, 1, 0x06090011, 0x06020000),
       .found_by = {"sdo.absent-sub-index"}},
      {.name = "IgnoresUnknownCommands",
       .defect = {.incoming =
                      [](Slave&, canopen::Frame& frame) {
                        return !is_request(frame, 0xE0, kDeviceType) && !is_request(frame, 0xFF, kDeviceType);
                      }},
       .found_by = {"sdo.command-specifier"}},
      {.name = "ReadsWhatIsWriteOnly",
       .defect = answers(0x40, kWriteOnly, 0, 0x4B),
       .found_by = {"sdo.write-only"}},
      {.name = "TakesConstants", .defect = answers(0x23, 0x1018, 1, 0x60), .found_by = {"sdo.read-only"}},
      {.name = "TakesTooMuch", .defect = answers(0x27, kGuardTime, 0, 0x60), .found_by = {"sdo.too-long"}},
      {.name = "TakesTooLittle", .defect = answers(0x2F, kGuardTime, 0, 0x60), .found_by = {"sdo.too-short"}},
      {.name = "HasNoHighLimit",
       .defect = {.table = [](Table& table) { row(table, kLimited).high = std::nullopt; }},
       .found_by = {"sdo.high-limit"}},
      {.name = "HasNoLowLimit",
       .defect = {.table = [](Table& table) { row(table, kLimited).low = std::nullopt; }},
       .found_by = {"sdo.low-limit"}},
      {.name = "TellsOtherIdentifiers",
       .defect = changes_answer(0x43, 0x1200, 1, [](canopen::Frame& frame) { frame.data[4] = 0x06; }),
       .found_by = {"sdo.server-1"}},
      {.name = "AbortsWithoutTheEntry",
       .defect = changes_answer(kAbortCommand, kReserved, 0,
                                [](canopen::Frame& frame) { frame.data[1] = frame.data[2] = 0; }),
       .found_by = {"sdo.abort-entry"}},
      {.name = "AbortsTwice",
       .defect = {.outgoing =
                      [](Slave& slave, canopen::Frame& frame) {
                        if (is_answer(frame, kAbortCommand, kReserved)) slave.say(frame);
                        return true;
                      }},
       .found_by = {"sdo.one-abort"}},
  };
}

std::vector<WrongSlave> that_transfer_wrongly() {
  return {
      {.name = "HasWrongCommandBytes",
       .defect = changes_answer(0x4B, kLimited, 0, [](canopen::Frame& frame) { frame.data[0] = 0x5B; }),
       .found_by = {"sdo.expedited-upload"}},
      {.name = "LeavesRubbishBehindTheData",
       .defect = changes_answer(0x4B, kLimited, 0, [](canopen::Frame& frame) { frame.data[7] = 0xAA; }),
       .found_by = {"sdo.unused-bytes"}},
      {.name = "AnnouncesAnotherSize",
       .defect = changes_answer(0x41, kDeviceName, 0, [](canopen::Frame& frame) { ++frame.data[4]; }),
       .found_by = {"sdo.announced-size"}},
      {.name = "NeverToggles", .defect = never_toggles(), .found_by = {"sdo.toggle-bit"}},
      {.name = "ForgivesToggleBitsOfUploads",
       .defect = forgives(0x05030000, 0x60, 0x7F, 0x00),
       .found_by = {"sdo.upload-toggle-error"}},
      {.name = "ForgivesToggleBitsOfDownloads",
       .defect = forgives(0x05030000, 0x00, 0x1F, 0x30),
       .found_by = {"sdo.download-toggle-error"}},
      {.name = "ForgivesMoreThanAnnounced",
       .defect = forgives(0x06070012, 0x00, 0x1F, 0x20),
       .found_by = {"sdo.more-than-announced"}},
      {.name = "ForgivesLessThanAnnounced",
       .defect = forgives(0x06070013, 0x00, 0x1F, 0x20),
       .found_by = {"sdo.less-than-announced"}},
      {.name = "ConfirmsAnotherEntry", .defect = confirms_another_entry(), .found_by = {"sdo.expedited-download"}},
      {.name = "NeedsTheNumberOfBytes",
       .defect = answers(0x22, 0x1006, 0, kAbortCommand, 0x06070010),
       .found_by = {"sdo.unsized-download"}},
      {.name = "TakesNoShortSegments",
       .defect = answers(0x21, kGuardTime, 0, kAbortCommand, 0x06070010),
       .found_by = {"sdo.short-segmented-download"}},
      {.name = "TakesNoTextInSegments",
       .defect = answers(0x21, kText, 0, kAbortCommand, 0x06070010),
       .found_by = {"sdo.segmented-download"}},
      {.name = "NeedsAnAnnouncedSize",
       .defect = answers(0x20, kText, 0, kAbortCommand, 0x06070010),
       .found_by = {"sdo.unannounced-size"}},
  };
}

std::vector<WrongSlave> that_take_frames_wrongly() {
  return {
      {.name = "RefusesNewTransfers", .defect = refuses_new_transfers(), .found_by = {"sdo.new-transfer"}},
      {.name = "AnswersStraySegments",
       .defect = answers_stray_segments(),
       .found_by = {"sdo.segment-without-transfer"}},
      {.name = "AnswersAborts",
       .defect = answers(kAbortCommand, kDeviceName, 0, kAbortCommand, 0x08000000),
       .found_by = {"sdo.client-abort"}},
      {.name = "TimesOutWithAnotherCode",
       .defect = {.policy = [](canopen::Policy& policy) { policy.sdo_timeout = std::chrono::seconds{1}; },
                  .outgoing =
                      [](Slave&, canopen::Frame& frame) {
                        if (is_abort(frame, 0x05040000)) frame.data[4] = 1;
                        return true;
                      }},
       .found_by = {"sdo.silent-client"}},
      {.name = "HangsOnShortRequests",
       .defect = hangs_on([](const canopen::Frame& frame) {
         return frame.id == kSdoRequest && !frame.remote && frame.length < 8 && frame.data[0] == 0x40 &&
                frame.data[2] == 0x10 && frame.data[1] == 0;
       }),
       .found_by = {"sdo.short-request"}},
      {.name = "AnswersRemoteFrames",
       .defect = answers_all([](const canopen::Frame& frame) { return frame.id == kSdoRequest && frame.remote; }),
       .found_by = {"sdo.remote-request"}},
      {.name = "AnswersForAnotherNode",
       .defect = answers_all([](const canopen::Frame& frame) { return frame.id == 0x606; }),
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

}  // namespace conformance_test
