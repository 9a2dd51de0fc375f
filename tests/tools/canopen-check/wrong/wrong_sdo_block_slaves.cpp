#include <utility>

#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tests/tools/canopen-check/slave/sdo_defects.hpp"

namespace conformance_test {
namespace {

constexpr std::uint16_t kDeviceType = 0x1000, kDeviceName = 0x1008;

/// Changes the request of a block upload of @p index before the node sees it.
Defect misreads_upload(std::uint16_t index, std::function<void(canopen::Frame&)> change) {
  return {.incoming = [=](Slave&, canopen::Frame& frame) {
    if (is_request(frame, 0xA0, index) || is_request(frame, 0xA4, index)) change(frame);
    return true;
  }};
}

/// Tells a wrong CRC at the end of block uploads.
Defect tells_wrong_crcs() {
  return {.incoming =
              [](Slave& slave, canopen::Frame& frame) {
                if (frame.id == kSdoRequest) slave.memory["request"] = frame.data[0];
                return true;
              },
          .outgoing =
              [](Slave& slave, canopen::Frame& frame) {
                const bool end =
                    frame.id == kSdoResponse && slave.memory["request"] == 0xA2 && (frame.data[0] & 0xE3) == 0xC1;
                if (end) frame.data[1] ^= 0xFF;
                return true;
              }};
}

/// Confirms every segment of a sub-block of 127, whatever got lost.
Defect confirms_lost_segments() {
  return {.incoming =
              [](Slave& slave, canopen::Frame& frame) {
                if (frame.id == kSdoRequest) ++slave.memory["segments"];
                return true;
              },
          .outgoing =
              [](Slave& slave, canopen::Frame& frame) {
                if (frame.id != kSdoResponse) return true;
                const bool large = std::exchange(slave.memory["segments"], 0) > 100;
                if (large && frame.data[0] == 0xA2) frame.data[1] = 127;
                return true;
              }};
}

/// Refuses block uploads in sub-blocks of one segment.
Defect refuses_small_blocks() {
  return {.incoming = [](Slave& slave, canopen::Frame& frame) {
    if (!is_request(frame, 0xA0, kDeviceName) || frame.data[4] != 1) return true;
    slave.say(answer(kAbortCommand, kDeviceName, 0, 0x05040002));
    return false;
  }};
}

/// Takes every confirmation of a block upload for one of all that it sent.
Defect forgets_lost_segments() {
  return {.incoming = [](Slave&, canopen::Frame& frame) {
    if (is_request(frame, 0xA2) && frame.data[1] == 1 && frame.data[2] == 3) frame.data[1] = 3;
    return true;
  }};
}

/// Answers an abort of the client about @p index that comes directly behind a frame that begins with @p before.
Defect answers_aborts_behind(std::uint8_t before, std::uint16_t index) {
  return {.incoming = [=](Slave& slave, canopen::Frame& frame) {
    if (frame.id != kSdoRequest) return true;
    const bool behind = std::exchange(slave.memory["before"], frame.data[0]) == before;
    if (behind && is_request(frame, kAbortCommand, index)) slave.say(answer(kAbortCommand, index));
    return true;
  }};
}

/// Refuses block uploads with a protocol switch threshold.
Defect knows_no_switch() {
  return {.incoming = [](Slave& slave, canopen::Frame& frame) {
    if (!is_request(frame, 0xA0, kDeviceType) || frame.data[5] == 0) return true;
    slave.say(answer(kAbortCommand, kDeviceType, 0, 0x05040001));
    return false;
  }};
}

}  // namespace

std::vector<WrongSlave> wrong_sdo_block_slaves() {
  return {
      {.name = "TakesBlocksOfNoSegments",
       .defect = misreads_upload(kDeviceType,
                                 [](canopen::Frame& frame) {
                                   if (frame.data[4] == 0) frame.data[4] = 1;
                                 }),
       .found_by = {"sdo.block-size-error"}},
      {.name = "RefusesSmallBlocks", .defect = refuses_small_blocks(), .found_by = {"sdo.block-sizes"}},
      {.name = "TellsWrongCrcs", .defect = tells_wrong_crcs(), .found_by = {"sdo.block-upload-crc"}},
      {.name = "ForgivesWrongCrcs",
       .defect = forgives(0x05040004, 0xC1, 0xDD, 0xA1),
       .found_by = {"sdo.block-crc-error"}},
      {.name = "ConfirmsLostSegments",
       .defect = confirms_lost_segments(),
       .found_by = {"sdo.block-download-loss"}},
      {.name = "KnowsNoProtocolSwitch", .defect = knows_no_switch(), .found_by = {"sdo.block-switch"}},
      {.name = "AnswersAbortsOfBlockUploads",
       .defect = answers_aborts_behind(0xA0, kDeviceType),
       .found_by = {"sdo.block-abort"}},
      {.name = "AnswersAbortsOfBlockDownloads",
       .defect = answers_aborts_behind(0x02, kDocument),
       .found_by = {"sdo.block-download-abort"}},
      {.name = "ForgetsLostSegments", .defect = forgets_lost_segments(), .found_by = {"sdo.block-upload-loss"}},
  };
}

}  // namespace conformance_test
