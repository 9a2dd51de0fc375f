#pragma once

#include <cstdint>

#include "libcanopen/base/frame.hpp"
#include "libcanopen/sdo/command.hpp"

namespace injection {

/// The first byte of an abort.
inline constexpr std::uint8_t kAbortCommand = 0x80;

/// What a frame of an SDO transfer is.
enum class Part : std::uint8_t {
  Initiate,
  Segment,       ///< of a segmented transfer, or its answer
  Block,         ///< a segment of a block
  BlockConfirm,  ///< of a block; of an upload also its start
  BlockEnd,
  Abort,
};

/// A transfer of one SDO server, followed by its frames.
class Transfer {
 public:
  /// A request that has come, or a response that goes out.
  void on_request(const canopen::Frame& frame) noexcept;
  void on_response(const canopen::Frame& frame) noexcept;

  /// What is transferred.
  canopen::sdo::Address at() const noexcept { return at_; }
  bool is_upload() const noexcept { return is_upload_; }
  /// What the frame that came or went last is, and its number of that direction, from 1.
  Part part() const noexcept { return part_; }
  std::uint32_t step() const noexcept { return step_; }
  /// Whether the server has begun with it.
  bool has_begun() const noexcept { return responses_ != 0; }

 private:
  void begin(const canopen::Frame& frame, bool is_upload) noexcept;

  canopen::sdo::Address at_{};
  Part part_ = Part::Abort;
  bool is_upload_ = false;
  bool in_block_ = false;  ///< segments of a block are on their way
  bool block_is_last_ = false;
  std::uint8_t last_sequence_ = 0;
  std::uint32_t step_ = 0;
  std::uint32_t requests_ = 0;
  std::uint32_t responses_ = 0;
};

}  // namespace injection
