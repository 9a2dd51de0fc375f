#pragma once

#include <array>

#include "tests/fuzz/byte_source.hpp"
#include "tests/fuzz/client.hpp"
#include "tests/fuzz/station.hpp"

namespace fuzz {

/// Kinds of events, the lower four bits of the byte that begins one; the upper four are its argument. The numbers
/// are the format of the corpus.
enum class EventKind : std::uint8_t {
  Request = 0,          ///< any eight bytes to a server
  Upload = 1,           ///< an initiate request for an entry: normal, or block with argument bit 2
  Download = 2,         ///< a value for an entry: expedited, or announced if it is longer than four bytes
  UploadSegments = 3,   ///< right requests for the next segments
  DownloadSegment = 4,  ///< the right next segment
  BlockSegments = 5,    ///< a sub-block of segments, with a gap if argument bit 3 is set
  BlockControl = 6,     ///< end of a download with its CRC; start, confirmation, end of an upload
  Known = 7,            ///< a frame under an identifier that the node knows
  Any = 8,              ///< any frame
  Remote = 9,           ///< a remote frame under an identifier that the node knows
  Time = 10,            ///< time passes
  Deadline = 11,        ///< time passes to the next deadline, and to those after it
  Value = 12,           ///< the application changes a value
  Nmt = 13,             ///< an NMT command
  Sync = 14,            ///< SYNC messages with a running counter, or without one
  Owner = 15,           ///< see OwnerEvent
};

/// What the owner of the node and the application behind it do: the argument of EventKind::Owner.
enum class OwnerEvent : std::uint8_t {
  DomainSizes,
  DomainRefusals,
  Answers,
  RaiseError,
  ClearError,
  Report,
  Recovery,
  Restart,
  ErrorBehaviour,
  Emergency,
  Heartbeat,
  TimeOfDay,
};

/// Turns bytes into events at a station.
class Events {
 public:
  explicit Events(Station& station);
  /// Plays @p bytes on the station as it is after Station::reset(), at most kMost events.
  void play(std::span<const std::uint8_t> bytes);

  static constexpr int kMost = 300;

 private:
  using Handler = void (Events::*)(unsigned argument);

  void request(unsigned argument);
  void upload(unsigned argument);
  void download(unsigned argument);
  void upload_segments(unsigned argument);
  void download_segment(unsigned argument);
  void block_segments(unsigned argument);
  void block_control(unsigned argument);
  void known(unsigned argument);
  void any(unsigned argument);
  void remote(unsigned argument);
  void time(unsigned argument);
  void deadline(unsigned argument);
  void value(unsigned argument);
  void nmt(unsigned argument);
  void sync(unsigned argument);
  void owner(unsigned argument);
  void node_event(OwnerEvent event);
  void ask(std::size_t server, canopen::Frame request);
  canopen::Identifier known_identifier(unsigned which) const;
  const canopen::Entry& entry();

  Station& station_;
  ByteSource source_{{}};
  std::array<Client, kServers> clients_{};
  std::uint8_t counter_ = 0;
};

}  // namespace fuzz
