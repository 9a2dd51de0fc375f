#pragma once

#include "tools/canopen-check/checks/shared/sdo_targets.hpp"

namespace conformance {

/// How a block transfer goes, and what goes wrong in it.
struct BlockOptions {
  std::uint8_t block_size = 127;     ///< segments in a sub-block of an upload
  bool crc = true;                   ///< the client has CRC
  bool announced = true;             ///< a download announces its size
  std::uint8_t lost = 0;             ///< segment of the first sub-block that gets lost; 0: none
  bool wrong_crc = false;            ///< of a download
  std::uint8_t switch_up_to = 0;     ///< protocol switch threshold (pst) of an upload, in bytes; 0: none
  std::uint8_t confirmed_as = 0;     ///< what the first sub-block of an upload is confirmed as; 0: what came
  unsigned stop_after_segments = 0;  ///< the client aborts a download there; 0: it does not
};

/// Reads @p entry by block upload (CiA 301, 7.2.4.3.12 to 15). The CRC is verified where both have it.
[[nodiscard]] SdoAnswer block_upload(Context& context, const Target& entry, const BlockOptions& options = {});
/// Writes the value of @p entry by block download (CiA 301, 7.2.4.3.8 to 11). The entry is not kept for the undo
/// log.
[[nodiscard]] SdoAnswer block_download(Context& context, const Target& entry, const BlockOptions& options = {});

}  // namespace conformance
