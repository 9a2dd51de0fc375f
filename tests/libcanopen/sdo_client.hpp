#pragma once

#include <set>
#include <variant>
#include <vector>

#include "libcanopen/node/node.hpp"
#include "libcanopen/sdo/command.hpp"
#include "tests/fakes/vector_bus.hpp"

/// What a client does to a transfer.
struct Disturbance {
  std::set<std::size_t> lost{};         ///< segments that are lost on the way, counted from 0 as they are sent
  bool flips_crc_bit = false;           ///< of a download
  std::size_t aborts_after = SIZE_MAX;  ///< segments
  std::uint8_t block_size = 127;        ///< of an upload
};

/// A client of one SDO server of a node, for whole transfers.
class SdoClient {
 public:
  using Bytes = std::vector<std::uint8_t>;
  /// Bytes of an upload or of a download, or the abort code. An abort of its own is GeneralError.
  using Outcome = std::variant<Bytes, canopen::AbortCode>;

  SdoClient(canopen::Node& node, fakes::VectorBus& bus, canopen::Identifier request = 0x605)
      : node_{node}, bus_{bus}, request_{request} {}

  Outcome upload(canopen::sdo::Address at);
  Outcome download(canopen::sdo::Address at, const Bytes& bytes, bool says_size = true);
  Outcome block_upload(canopen::sdo::Address at, const Disturbance& disturbance = {});
  Outcome block_download(canopen::sdo::Address at, const Bytes& bytes, const Disturbance& disturbance = {},
                         bool says_size = true);

  /// Sends the eight bytes of @p word and returns the answers.
  std::vector<canopen::Frame> says(std::uint64_t word);
  canopen::TimePoint now{std::chrono::hours{1}};

 private:
  bool take_sub_block(const std::vector<canopen::Frame>& segments, const Disturbance& disturbance);

  canopen::Node& node_;
  fakes::VectorBus& bus_;
  canopen::Identifier request_;
  Bytes taken_;               ///< of a block upload
  std::size_t segments_ = 0;  ///< of a block transfer, those that were lost too
  std::uint8_t in_order_ = 0;
  bool complete_ = false;
};
