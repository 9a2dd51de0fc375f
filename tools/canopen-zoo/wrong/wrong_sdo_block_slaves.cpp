#include <utility>

#include "tools/canopen-zoo/slave/sdo_defects.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {
namespace {

constexpr std::uint16_t kDeviceType = 0x1000, kDeviceName = 0x1008;

/// Changes the request of a block upload of @p index before the node sees it.
Defect misreads_upload(std::uint16_t index, const std::function<void(canopen::Frame&)>& change) {
  return {.incoming = [=](Slave& slave, canopen::Frame& frame) {
    if (is_request(slave, frame, 0xA0, index) || is_request(slave, frame, 0xA4, index)) change(frame);
    return true;
  }};
}

/// Tells a wrong CRC at the end of block uploads.
Defect tells_wrong_crcs() {
  return {.incoming =
              [](Slave& slave, canopen::Frame& frame) {
                if (frame.id == slave.cob_id(kSdoRequest)) slave.memory["request"] = frame.data[0];
                return true;
              },
          .outgoing =
              [](Slave& slave, canopen::Frame& frame) {
                const bool end = frame.id == slave.cob_id(kSdoResponse) && slave.memory["request"] == 0xA2 &&
                                 (frame.data[0] & 0xE3) == 0xC1;
                if (end) frame.data[1] ^= 0xFF;
                return true;
              }};
}

/// Confirms every segment of a sub-block of 127, whatever got lost.
Defect confirms_lost_segments() {
  return {.incoming =
              [](Slave& slave, canopen::Frame& frame) {
                if (frame.id == slave.cob_id(kSdoRequest)) ++slave.memory["segments"];
                return true;
              },
          .outgoing =
              [](Slave& slave, canopen::Frame& frame) {
                if (frame.id != slave.cob_id(kSdoResponse)) return true;
                const bool large = std::exchange(slave.memory["segments"], 0) > 100;
                if (large && frame.data[0] == 0xA2) frame.data[1] = 127;
                return true;
              }};
}

/// Refuses block uploads in sub-blocks of one segment.
Defect refuses_small_blocks() {
  return {.incoming = [](Slave& slave, canopen::Frame& frame) {
    if (!is_request(slave, frame, 0xA0, kDeviceName) || frame.data[4] != 1) return true;
    slave.say(answer(slave, kAbortCommand, kDeviceName, 0, 0x05040002));
    return false;
  }};
}

/// Takes every confirmation of a block upload for one of all that it sent.
Defect forgets_lost_segments() {
  return {.incoming = [](Slave& slave, canopen::Frame& frame) {
    if (is_request(slave, frame, 0xA2) && frame.data[1] == 1 && frame.data[2] == 3) frame.data[1] = 3;
    return true;
  }};
}

/// Answers an abort of the client about @p index that comes directly behind a frame that begins with @p before.
Defect answers_aborts_behind(std::uint8_t before, std::uint16_t index) {
  return {.incoming = [=](Slave& slave, canopen::Frame& frame) {
    if (frame.id != slave.cob_id(kSdoRequest)) return true;
    const bool behind = std::exchange(slave.memory["before"], frame.data[0]) == before;
    if (behind && is_request(slave, frame, kAbortCommand, index)) slave.say(answer(slave, kAbortCommand, index));
    return true;
  }};
}

/// Refuses block uploads with a protocol switch threshold.
Defect knows_no_switch() {
  return {.incoming = [](Slave& slave, canopen::Frame& frame) {
    if (!is_request(slave, frame, 0xA0, kDeviceType) || frame.data[5] == 0) return true;
    slave.say(answer(slave, kAbortCommand, kDeviceType, 0, 0x05040001));
    return false;
  }};
}

}  // namespace

std::vector<WrongSlave> wrong_sdo_block_slaves() {
  return {
      {.name = "TakesBlocksOfNoSegments",
       .what = "It begins a block upload of 1000h in sub-blocks of 0 segments.",
       .defect = misreads_upload(kDeviceType,
                                 [](canopen::Frame& frame) {
                                   if (frame.data[4] == 0) frame.data[4] = 1;
                                 }),
       .found_by = {"sdo.block-size-error"}},
      {.name = "RefusesSmallBlocks",
       .what = "It refuses a block upload of 1008h in sub-blocks of one segment.",
       .defect = refuses_small_blocks(),
       .found_by = {"sdo.block-sizes"}},
      {.name = "TellsWrongCrcs",
       .what = "The CRC at the end of its block uploads is wrong.",
       .defect = tells_wrong_crcs(),
       .found_by = {"sdo.block-upload-crc"}},
      {.name = "ForgivesWrongCrcs",
       .what = "It confirms block downloads whose CRC is wrong.",
       .defect = forgives(0x05040004, 0xC1, 0xDD, 0xA1),
       .found_by = {"sdo.block-crc-error"}},
      {.name = "ConfirmsLostSegments",
       .what = "It confirms 127 segments of a long sub-block of a download though one was lost.",
       .defect = confirms_lost_segments(),
       .found_by = {"sdo.block-download-loss"}},
      {.name = "KnowsNoProtocolSwitch",
       .what = "It refuses a block upload of 1000h with a protocol switch threshold.",
       .defect = knows_no_switch(),
       .found_by = {"sdo.block-switch"}},
      {.name = "AnswersAbortsOfBlockUploads",
       .what = "It answers the abort of a block upload of 1000h with an abort.",
       .defect = answers_aborts_behind(0xA0, kDeviceType),
       .found_by = {"sdo.block-abort"}},
      {.name = "AnswersAbortsOfBlockDownloads",
       .what = "It answers the abort of a block download to 2003h with an abort.",
       .defect = answers_aborts_behind(0x02, kDocument),
       .found_by = {"sdo.block-download-abort"}},
      {.name = "ForgetsLostSegments",
       .what = "It does not repeat what is lost of a block upload when one segment of three is confirmed.",
       .defect = forgets_lost_segments(),
       .found_by = {"sdo.block-upload-loss"}},
  };
}

}  // namespace zoo
