#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "sim/master/station.hpp"
#include "sim/master/task.hpp"

namespace sim {

/// A transfer has come to nothing: the server has aborted it, or did not answer as it has to.
struct SdoFailure {};

/// The object of a transfer.
struct SdoObject {
  std::uint16_t index;
  std::uint8_t sub_index = 0;
};

/// A client of the default SDO server of one node: one transfer at a time, expedited and segmented (CiA 301
/// 7.2.4.3).
class SdoClient {
 public:
  using Bytes = std::vector<std::uint8_t>;
  using Read = tl::expected<Bytes, SdoFailure>;
  using Written = tl::expected<Done, SdoFailure>;

  /// Of node @p node_id, by @p station, which outlives this.
  SdoClient(Station& station, std::uint8_t node_id) noexcept : station_{station}, node_id_{node_id} {}

  Task<Read> read(SdoObject object, canopen::Duration longest = kPatience);
  Task<Written> write(SdoObject object, Bytes value, canopen::Duration longest = kPatience);
  /// A number of @p size bytes (1..4), little endian.
  Task<Written> write(SdoObject object, std::uint32_t value, std::size_t size,
                      canopen::Duration longest = kPatience);

  /// How long an answer is waited for, unless told otherwise.
  static constexpr canopen::Duration kPatience = std::chrono::seconds{1};

 private:
  using Data = std::array<std::uint8_t, 8>;
  using Answer = tl::expected<Data, SdoFailure>;

  Task<Answer> exchange(Data request, canopen::Duration longest);
  void abort(SdoObject object) noexcept;

  Station& station_;
  std::uint8_t node_id_;
};

}  // namespace sim
