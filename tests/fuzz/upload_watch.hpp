#pragma once

#include <array>
#include <span>

#include "libcanopen/base/time.hpp"
#include "tests/fuzz/check.hpp"
#include "tests/fuzz/legal_frames.hpp"

namespace fuzz {

/// Watches segmented uploads of plain values: whatever else happens on the bus, the next right request of the
/// client must get the next segment, until the transfer times out or its server or the node changes.
class UploadWatch {
 public:
  /// Server @p server was asked @p request under @p legal and has answered @p answers.
  void note(std::size_t server, const canopen::Frame& request, std::span<const canopen::Frame> answers,
            canopen::TimePoint now, canopen::Duration timeout) noexcept {
    Upload& upload = uploads_[server];
    const bool answered = answers.size() == 1;
    const std::uint8_t answer = answered ? answers.front().data[0] : std::uint8_t{0xFF};
    if (is_due(upload, request, now, timeout)) {
      require(answered && (answer & 0xF0) == upload.toggle, "an upload goes on whatever happens elsewhere");
      upload.toggle ^= 0x10;
      upload.since = now;
      if ((answer & 1) != 0) upload.is_open = false;
      return;
    }
    upload.is_open = answered && (request.data[0] & 0xE0) == 0x40 && answer == 0x41 && !is_streamed(request);
    upload.toggle = 0;
    upload.since = now;
  }
  /// Server parameters or the NMT state have changed, or may have.
  void forget() noexcept { uploads_ = {}; }

 private:
  struct Upload {
    bool is_open = false;
    std::uint8_t toggle = 0;
    canopen::TimePoint since{};
  };
  static bool is_due(const Upload& upload, const canopen::Frame& request, canopen::TimePoint now,
                     canopen::Duration timeout) noexcept {
    return upload.is_open && (request.data[0] & 0xF0) == (0x60 | upload.toggle) && now - upload.since < timeout;
  }
  static bool is_streamed(const canopen::Frame& request) noexcept {
    const unsigned index = unsigned{request.data[1]} | unsigned{request.data[2]} << 8;
    return index >= kFirstDomain && index < kFirstDomain + kDomains;
  }

  std::array<Upload, kServers> uploads_{};
};

}  // namespace fuzz
