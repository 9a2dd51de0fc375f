#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "libcanopen/od/abort_code.hpp"

/// A second SDO server, written from CiA 301, 7.2.4.3 alone and as plainly as possible, to compare the real one
/// with.
namespace model {

using canopen::AbortCode;
using Bytes = std::vector<std::uint8_t>;
using Data = std::array<std::uint8_t, 8>;  ///< the data of one frame
using Milliseconds = std::int64_t;

class Server;

/// One object, with its value as the bytes that travel.
struct Object {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  bool readable = true, writable = true;
  bool is_number = false;  ///< its length is that of `value`, always
  bool is_signed = false;
  std::optional<std::int64_t> low{}, high{};
  std::size_t capacity = 0;  ///< longest value of what is no number
  Bytes value{};

  bool streamed = false;                      ///< DOMAIN with an owner: the data is passed on while it comes
  bool size_is_known = true;                  ///< the owner tells it
  std::optional<AbortCode> refuses_to_end{};  ///< the owner's answer to the end of a write
  const Server* writer = nullptr;
  int readers = 0;
};
using Objects = std::vector<Object>;

/// What a server may answer to one event.
struct Answer {
  std::vector<Data> frames{};
  bool any_multiplexer = false;         ///< bytes 1..3 are not looked at: there is no transfer to name
  bool any_block_size = false;          ///< the server chooses the block size of its answer
  std::optional<AbortCode> or_abort{};  ///< what must fail in the end may fail now
};

/// One SDO server over objects that others use too.
class Server {
 public:
  Server(Objects& objects, Milliseconds timeout) : objects_{objects}, timeout_{timeout} {}

  /// A request, and what is to be answered.
  const Answer& on_request(const Data& request, Milliseconds now);
  /// Time has come to @p now, and what is to be sent because of it.
  const Answer& on_time(Milliseconds now);
  /// Nothing has happened to this server, and it has nothing to say.
  void on_silence() { answer_ = {}; }
  /// Compares what was sent with the last answer, and goes on with the choice made; false if it is none allowed.
  bool accepts(const std::vector<Data>& sent);
  /// The frames of the last answer.
  const std::vector<Data>& expected() const { return answer_.frames; }
  /// The NMT state has changed: no transfer is left.
  void forget() { end(); }

  /// What a client that follows the protocol needs to know.
  enum class Phase {
    Idle,
    Upload,
    Download,
    BlockUploadOffered,   ///< waits for the start
    BlockUploadSent,      ///< waits for the confirmation of a sub-block
    BlockUploadEnded,     ///< waits for the client's end
    BlockDownload,        ///< waits for segments
    BlockDownloadEnding,  ///< waits for the client's end
  };
  Phase phase() const { return phase_; }
  std::uint8_t toggle() const { return toggle_; }
  std::uint8_t block_size() const { return block_size_; }
  std::uint8_t sent_segments() const { return sent_segments_; }
  /// When on_time() has something to say; nothing while there is no transfer.
  std::optional<Milliseconds> deadline() const;

 private:
  void initiate_upload(const Data& request);
  void upload_segment(const Data& request);
  void initiate_download(const Data& request);
  void download_segment(const Data& request);
  void block_upload(const Data& request);
  void initiate_block_upload(const Data& request);
  void confirm_upload(const Data& request);
  void send_sub_block();
  void block_download(const Data& request);
  void initiate_block_download(const Data& request);
  void block_segment(const Data& request, Milliseconds now);
  void confirm_download();
  void end_block_download(const Data& request);

  bool find(const Data& request);
  bool begin_read();
  bool begin_write(const Data& request, bool has_size);
  std::optional<AbortCode> check(const Bytes& value) const;
  void watch_length(std::size_t sure);
  bool commit();
  void open(Phase phase, bool writes);
  void end();
  void answer(const Data& frame) { answer_.frames.push_back(frame); }
  void answer_initiate(std::uint8_t command, std::uint32_t word);
  void abort(AbortCode code);

  Objects& objects_;
  Milliseconds timeout_;
  Answer answer_;
  Phase phase_ = Phase::Idle;
  Milliseconds last_ = 0;      ///< last request, or what the server said by itself
  Milliseconds progress_ = 0;  ///< block download: last segment in order
  bool must_restart_ = false;  ///< block download: segments were confirmed early, the client must have seen it
  bool is_broken_ = false;     ///< and it has not
  bool confirmed_early_ = false;
  Object* object_ = nullptr;
  std::uint16_t index_ = 0;
  std::uint8_t sub_index_ = 0;
  Bytes data_;                                ///< upload: all of it; download: what has come
  std::size_t done_ = 0;                      ///< bytes of an upload that are sent, for good in a block transfer
  std::optional<std::uint32_t> announced_{};  ///< size of a download
  std::optional<AbortCode> doom_{};           ///< what a download that is too long will be refused with
  std::uint8_t toggle_ = 0;
  bool crc_ = false;
  std::uint8_t block_size_ = 0;
  std::uint8_t next_segment_ = 1;
  std::uint8_t sent_segments_ = 0;
  std::size_t segments_done_ = 0;
};

/// CRC of block transfers (CiA 301, 7.2.4.3.16).
std::uint16_t crc_of(const Bytes& bytes);

}  // namespace model
