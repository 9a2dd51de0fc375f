#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libcanopen/od/abort_code.hpp"
#include "tools/canopen-check/core/run/context.hpp"

namespace conformance {

/// An entry that a check works with, and what it holds.
struct Target {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  std::vector<std::uint8_t> value{};
};

/// A writable number of @p bytes that it does no harm to write again; the first of the EDS that can be read, no
/// COB-ID and no PDO parameter. Without an EDS 1017h, for two bytes.
[[nodiscard]] std::optional<Target> writable_number(Context& context, std::size_t bytes);
/// A writable string or DOMAIN; DOMAIN only with @p domain. Nothing without an EDS.
[[nodiscard]] std::optional<Target> writable_text(Context& context, bool domain);
/// A readable entry with more than @p bytes bytes; the first of the EDS.
/// Without an EDS one of 1008h to 100Ah.
[[nodiscard]] std::optional<Target> long_entry(Context& context, std::size_t bytes);

/// True where @p entry may be written with its own value in any state: no order, no COB-ID, no PDO parameter,
/// nothing that is stored by it or that moves a drive.
[[nodiscard]] bool harmless(const eds::EntryFacts& entry, const Settings& settings) noexcept;

/// A frame of the server as an answer: an abort, silence, or the eight bytes as they are.
[[nodiscard]] SdoAnswer answer_of(const std::optional<canopen::Frame>& frame);
/// Sends @p request and judges the next frame of the server.
[[nodiscard]] SdoAnswer ask(Context& context, const canopen::Frame& request);
/// A segment of a download: command byte and up to seven bytes.
[[nodiscard]] canopen::Frame segment(Context& context, std::uint8_t command, std::span<const std::uint8_t> bytes);

/// A finding unless the node still answers an upload of 1000h, after what @p after says.
void expect_service(Context& context, const std::string& after);
/// A finding unless @p answer, to an upload of 1000h, is one.
void expect_service(Context& context, const SdoAnswer& answer, const std::string& after);

/// How long a second or unwanted answer is waited for, at most.
inline constexpr canopen::Duration kQuiet = std::chrono::milliseconds{50};

// Command bytes of the client (CiA 301, 7.2.4.3).
inline constexpr std::uint8_t kInitiateUpload = 0x40, kUploadSegment = 0x60, kInitiateDownload = 0x20,
                              kInitiateDownloadSized = 0x21, kDownloadSegment = 0x00, kToggleBit = 0x10,
                              kLastSegmentBit = 0x01;
/// What the server answers to the initiation of a download.
inline constexpr std::uint8_t kDownloadInitiated = 0x60;

/// True if @p answer is a frame of the server that begins with @p command.
[[nodiscard]] inline bool begins_with(const SdoAnswer& answer, std::uint8_t command) noexcept {
  return answer.done() && !answer.data.empty() && answer.data.front() == command;
}

}  // namespace conformance
