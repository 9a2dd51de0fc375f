#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/canopen-check/core/session.hpp"

namespace conformance {

/// What came of an SDO transfer.
struct SdoAnswer {
  enum class Kind : std::uint8_t {
    Done,
    Aborted,    ///< by the server, with `abort_code`
    Silent,     ///< no answer in time
    Malformed,  ///< an answer that is none of the protocol: `problem`; the client has aborted the transfer
  };
  Kind kind = Kind::Silent;
  std::uint32_t abort_code = 0;
  std::vector<std::uint8_t> data{};  ///< of an upload
  std::string problem{};
  bool expedited = false;                    ///< of an upload
  std::optional<std::uint32_t> announced{};  ///< size that an upload announced

  [[nodiscard]] bool done() const noexcept { return kind == Kind::Done; }
  [[nodiscard]] bool aborted() const noexcept { return kind == Kind::Aborted; }
  /// The data as a number, least significant byte first; of at most eight bytes.
  [[nodiscard]] std::uint64_t number() const noexcept;
};

/// "done", "abort 06090011h (no such sub-index)", "no answer", or the problem.
[[nodiscard]] std::string to_text(const SdoAnswer& answer);
/// "06090011h (no such sub-index)".
[[nodiscard]] std::string abort_text(std::uint32_t code);
/// Bytes as candump prints them: "0102FF".
[[nodiscard]] std::string hexadecimal(std::span<const std::uint8_t> bytes);

/// The client of an SDO server (CiA 301, 7.2.4): expedited and segmented transfers, and single frames.
class SdoClient {
 public:
  /// Requests go under @p request, answers come under @p response, within @p patience.
  SdoClient(Session& session, std::uint32_t request, std::uint32_t response, canopen::Duration patience)
      : session_{&session}, request_{request}, response_{response}, patience_{patience} {}

  /// Reads an entry, in segments if the server chooses so.
  SdoAnswer upload(std::uint16_t index, std::uint8_t sub_index);
  /// Writes an entry: expedited up to four bytes, else in segments with its size announced.
  SdoAnswer download(std::uint16_t index, std::uint8_t sub_index, std::span<const std::uint8_t> bytes);
  /// Writes an entry in segments, whatever its size is.
  SdoAnswer download_in_segments(std::uint16_t index, std::uint8_t sub_index, std::span<const std::uint8_t> bytes);

  /// A request of eight bytes: command byte, index, sub-index, four bytes of @p value.
  [[nodiscard]] canopen::Frame request(std::uint8_t command, std::uint16_t index = 0, std::uint8_t sub_index = 0,
                                       std::uint32_t value = 0) const;
  /// Sends @p request and gives the next frame of the server; nothing if none comes in time.
  std::optional<canopen::Frame> exchange(const canopen::Frame& request);
  /// Asks again after a silence so long that requests were not sent any more: see kMostSilent.
  void ask_again() noexcept { silent_ = 0; }
  /// Ends a transfer from the client's side.
  void abort(std::uint16_t index, std::uint8_t sub_index, std::uint32_t code);
  /// Sends nothing and gives the next frame of the server within @p patience.
  std::optional<canopen::Frame> listen(canopen::Duration patience);

  [[nodiscard]] std::uint32_t request_identifier() const noexcept { return request_; }
  [[nodiscard]] std::uint32_t response_identifier() const noexcept { return response_; }
  [[nodiscard]] canopen::Duration patience() const noexcept { return patience_; }
  /// Times between request and answer, of every exchange so far.
  [[nodiscard]] const std::vector<canopen::Duration>& response_times() const noexcept { return times_; }

 private:
  /// After so many requests in a row without an answer the node has gone: further ones are not sent, so that a
  /// check of thousands of entries ends.
  static constexpr unsigned kMostSilent = 20;

  SdoAnswer upload_segments(std::uint16_t index, std::uint8_t sub_index, std::optional<std::uint32_t> announced);
  SdoAnswer malformed(std::uint16_t index, std::uint8_t sub_index, std::string problem);

  Session* session_;
  std::uint32_t request_, response_;
  canopen::Duration patience_;
  unsigned silent_ = 0;  ///< requests in a row without an answer
  std::vector<canopen::Duration> times_;
};

/// The abort code of @p frame, if it is an abort of the server.
[[nodiscard]] std::optional<std::uint32_t> abort_code(const canopen::Frame& frame) noexcept;

}  // namespace conformance
