#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libcanopen/od/abort_code.hpp"
#include "tools/canopen-check/core/sdo_match.hpp"
#include "tools/canopen-check/core/session.hpp"

namespace conformance {

/// What came of an SDO transfer.
struct SdoAnswer {
  enum class Kind : std::uint8_t {
    Done,
    Aborted,    ///< by the server, with `abort_code`
    Silent,     ///< no answer in time
    Malformed,  ///< an answer that is none of the protocol: `problem`; the client has aborted the transfer
    Endless,    ///< data beyond those announced, or segments without any: `problem`; the client has aborted it
    Cut,        ///< more than the tester takes: `problem`; the client has aborted the transfer
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

/// What a transfer may cost in bytes and time.
inline constexpr std::size_t kLongestTransfer = std::size_t{1024} * 1024;
inline constexpr canopen::Duration kLongestTransferTime = std::chrono::seconds{10};
/// Bytes that a server may send beyond the size that it announced until the transfer is ended.
inline constexpr std::size_t kMostUnannounced = 64;

/// "done", the first bytes of the data, "abort 06090011h (no such sub-index)", "no answer", or the problem.
[[nodiscard]] std::string to_text(const SdoAnswer& answer);
/// @p code as a number.
[[nodiscard]] constexpr std::uint32_t number_of(canopen::AbortCode code) noexcept {
  return static_cast<std::uint32_t>(code);
}
/// Bytes as candump prints them: "0102FF"; the first ones of many, "0102FF... (1000 bytes)".
[[nodiscard]] std::string hexadecimal(std::span<const std::uint8_t> bytes);
/// A frame as candump prints it: "585#4300100000000000".
[[nodiscard]] std::string to_text(const canopen::Frame& frame);

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
  /// Sends @p request and gives the answer of the server that fits it (SdoMatch); if none comes in time, a frame
  /// that stands in for it, or nothing.
  std::optional<canopen::Frame> exchange(const canopen::Frame& request);
  /// Asks for uploads of @p entries, several at a time of a server that is seen to answer requests which come
  /// together: the answer to each. Nothing for an entry that has to be asked for alone, because the server does
  /// not answer that way, or because of a frame that fits none of the requests.
  [[nodiscard]] std::vector<std::optional<canopen::Frame>> ask_together(std::span<const Multiplexor> entries);
  /// Sends @p request and gives the next frame of the server, whether it fits or not.
  std::optional<canopen::Frame> exchange_any(const canopen::Frame& request);
  /// The next frame that answers the last request; for the segments of a block upload.
  std::optional<canopen::Frame> next_answer();
  /// The confirmation of a sub-block that was sent.
  std::optional<canopen::Frame> confirmation();
  /// Asks again after a silence so long that requests were not sent any more: see kMostSilent.
  void ask_again() noexcept {
    silent_ = 0;
    absent_ = false;
  }
  /// Ends a transfer from the client's side.
  void abort(std::uint16_t index, std::uint8_t sub_index, std::uint32_t code);
  /// Sends nothing and gives the next frame of the server within @p patience.
  std::optional<canopen::Frame> listen(canopen::Duration patience);

  /// No transfer is going on: aborts of what is none fit whatever they name.
  void forget_transfer() noexcept { transfer_.reset(); }
  /// Finds out whether the aborts of the server name the entry; where they do not, every abort fits.
  void learn_aborts();
  /// Lets answers pass that may still come to requests which were given up.
  void settle();
  /// What came of a request that was not answered: "no answer", with the abort of another entry that came instead.
  [[nodiscard]] SdoAnswer silence() const;
  /// The first request since the last answer, if the last one was not answered.
  [[nodiscard]] const std::optional<canopen::Frame>& unanswered() const noexcept { return unanswered_; }
  /// Requests so far beside which the server sent what fitted none, and the first of these frames with its
  /// request.
  [[nodiscard]] std::size_t strays() const noexcept { return strays_; }
  [[nodiscard]] const std::string& first_stray() const noexcept { return first_stray_; }

  [[nodiscard]] std::uint32_t request_identifier() const noexcept { return request_; }
  [[nodiscard]] std::uint32_t response_identifier() const noexcept { return response_; }
  [[nodiscard]] canopen::Duration patience() const noexcept { return patience_; }
  /// Times between request and answer, of every exchange so far.
  [[nodiscard]] const std::vector<canopen::Duration>& response_times() const noexcept { return times_; }

 private:
  /// After so many requests in a row without an answer the node is asked for 1000h:00; without an answer to that
  /// it has gone, and further requests are not sent, so that a check of thousands of entries ends.
  static constexpr unsigned kMostSilent = 3;

  bool is_present();
  std::optional<TimedFrame> await();
  void learn_to_ask_together();
  std::vector<std::optional<canopen::Frame>> burst(std::span<const Multiplexor> entries,
                                                   canopen::Duration patience);
  SdoAnswer upload_segments(std::uint16_t index, std::uint8_t sub_index, std::optional<std::uint32_t> announced);
  SdoAnswer malformed(std::uint16_t index, std::uint8_t sub_index, std::string problem);
  SdoAnswer endless(std::uint16_t index, std::uint8_t sub_index, std::string problem);
  SdoAnswer cut(std::uint16_t index, std::uint8_t sub_index, std::string problem);

  Session* session_;
  std::uint32_t request_, response_;
  canopen::Duration patience_;
  unsigned silent_ = 0;  ///< requests in a row without an answer
  bool absent_ = false;  ///< it did not even answer an upload of 1000h:00
  bool late_ = false;    ///< an answer to a request that was given up may still come
  bool aborts_are_named_ = true;
  std::size_t together_ = 0;               ///< requests at a time that the server answers; 0: not known yet
  canopen::Frame last_{};                  ///< request
  std::optional<SdoMatch> awaited_{};      ///< what answers the last request
  std::optional<Multiplexor> transfer_{};  ///< that was initiated last
  std::optional<canopen::Frame> stray_{};  ///< the first one since the last request
  std::optional<canopen::Frame> unanswered_{};
  std::size_t strays_ = 0;
  std::string first_stray_;
  std::vector<canopen::Duration> times_;
};

/// The answer to an upload that @p frame is as a whole: an abort, or data in one frame; nothing if segments
/// follow, and for what is none.
[[nodiscard]] std::optional<SdoAnswer> whole_answer(const canopen::Frame& frame);
/// The abort code of @p frame, if it is an abort of the server.
[[nodiscard]] std::optional<std::uint32_t> abort_code(const canopen::Frame& frame) noexcept;

}  // namespace conformance
