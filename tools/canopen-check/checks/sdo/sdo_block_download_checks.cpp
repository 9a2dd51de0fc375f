#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/sdo/block_client.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"

namespace conformance {
namespace {

using canopen::AbortCode;

/// The entry with which block downloads are tried, and whether the server has them; nothing, and the check is
/// skipped, otherwise. The entry is kept for the undo log.
std::optional<Target> download_target(Context& context, bool domain) {
  constexpr std::uint8_t kRequest = 0xC0;
  std::optional<Target> target = writable_text(context, true);
  if (!target && !domain) target = writable_text(context, false);
  for (const std::size_t bytes : {std::size_t{4}, std::size_t{2}})
    if (!domain && (!target || target->value.empty())) target = writable_number(context, bytes);
  if (!target) {
    context.skip(domain ? "no DOMAIN that may be written" : "nothing that may be written");
    return std::nullopt;
  }
  const SdoAnswer answer = ask(context, context.sdo().request(kRequest, target->index, target->sub_index));
  if (answer.aborted() && answer.abort_code == number_of(AbortCode::CommandSpecifierInvalid)) {
    context.skip("block transfer is refused with 05040001h");
    return std::nullopt;
  }
  context.sdo().abort(target->index, target->sub_index, number_of(AbortCode::GeneralError));
  context.undo().keep(target->index, target->sub_index);
  context.step();
  return target;
}

/// @p size bytes that differ.
std::vector<std::uint8_t> pattern(std::size_t size) {
  std::vector<std::uint8_t> bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 256);
  return bytes;
}

/// A finding unless the value of @p target is taken by block download and read back in segments.
void expect_download(Context& context, const Target& target, const BlockOptions& options, const std::string& how) {
  context.step();
  const SdoAnswer answer = block_download(context, target, options);
  const std::string what = fmt::format("{} bytes by block download {}", target.value.size(), how);
  if (!answer.done()) return context.fail(target.index, target.sub_index, what + " are taken", to_text(answer));
  if (const SdoAnswer now = context.read(target.index, target.sub_index); now.data != target.value)
    context.fail(target.index, target.sub_index, what + " are read again", to_text(now));
}

void downloads_without_crc(Context& context) {
  if (const auto target = download_target(context, false))
    expect_download(context, *target, {.crc = false}, "without CRC");
}

void downloads_with_crc(Context& context) {
  if (const auto target = download_target(context, false)) expect_download(context, *target, {}, "with CRC");
}

void downloads_data_of_any_length(Context& context) {
  std::optional<Target> target = download_target(context, true);
  if (!target) return;
  for (const std::size_t size : {32U, 900U, 1024U, 1025U, 2048U}) {
    target->value = pattern(size);
    expect_download(context, *target, {.crc = false}, "without CRC");
  }
}

void refuses_a_wrong_crc(Context& context) {
  const std::optional<Target> target = download_target(context, false);
  if (!target) return;
  constexpr std::uint8_t kRequestWithCrc = 0xC4, kCrc = 0x04;
  const SdoAnswer offer = ask(context, context.sdo().request(kRequestWithCrc, target->index, target->sub_index));
  context.sdo().abort(target->index, target->sub_index, number_of(AbortCode::GeneralError));
  if (offer.done() && (offer.data[0] & kCrc) == 0) return context.skip("the server has no CRC");
  context.step();
  context.expect_abort(block_download(context, *target, {.wrong_crc = true}), {number_of(AbortCode::CrcError)},
                       target->index, target->sub_index, "a wrong CRC");
}

void asks_for_lost_segments(Context& context) {
  constexpr std::size_t kTwoSubBlocks = 900;
  std::optional<Target> target = download_target(context, true);
  if (!target) return;
  target->value = pattern(kTwoSubBlocks);
  expect_download(context, *target, {.crc = false, .lost = 3}, "whose segment 3 got lost");
}

void survives_aborts(Context& context) {
  std::optional<Target> target = download_target(context, true);
  if (!target) return;

  target->value = pattern(100);
  (void)block_download(context, *target, {.crc = false, .stop_after_segments = 2});
  const auto frames = context.session().collect(under(context.sdo().response_identifier()), context.quiet(kQuiet));
  if (!frames.empty())
    context.fail(target->index, target->sub_index, "no answer to an abort of the client in a block download",
                 to_text(answer_of(frames.front().frame)));
  expect_service(context, "a block download that the client aborted");
}

void makes_round_trips(Context& context) {
  constexpr int kTrips = 20;
  constexpr std::size_t kBytes = 200;
  std::optional<Target> target = download_target(context, true);
  if (!target) return;
  for (int i = 0; i < kTrips && !context.failed() && !context.session().ended(); ++i) {
    target->value = pattern(kBytes + static_cast<std::size_t>(i));
    context.step();
    const SdoAnswer written = block_download(context, *target, {.crc = false});
    const SdoAnswer read = block_upload(context, *target, {.crc = false});
    if (!written.done() || read.data != target->value)
      context.fail(target->index, target->sub_index, fmt::format("round trip {} gives what was written", i + 1),
                   to_text(written.done() ? read : written));
  }
}

constexpr std::array kChecks{
    Check{.id = "sdo.block-download",
          .name = "Data are downloaded in blocks without CRC",
          .clause = "CiA 301 7.2.4.3.8",
          .group = Group::Sdo,
          .run = downloads_without_crc},
    Check{.id = "sdo.block-download-crc",
          .name = "Data are downloaded in blocks with CRC",
          .clause = "CiA 301 7.2.4.3.16",
          .group = Group::Sdo,
          .run = downloads_with_crc},
    Check{.id = "sdo.block-lengths",
          .name = "32, 900, 1024, 1025 and 2048 bytes are downloaded in blocks",
          .clause = "CiA 301 7.2.4.3.10",
          .group = Group::Sdo,
          .run = downloads_data_of_any_length},
    Check{.id = "sdo.block-crc-error",
          .name = "A wrong CRC is refused with 05040004h",
          .clause = "CiA 301 7.2.4.3.16",
          .group = Group::Sdo,
          .run = refuses_a_wrong_crc},
    Check{.id = "sdo.block-download-loss",
          .name = "The last good segment before a loss is confirmed and the rest taken again",
          .clause = "CiA 301 7.2.4.3.10",
          .group = Group::Sdo,
          .run = asks_for_lost_segments},
    Check{.id = "sdo.block-download-abort",
          .name = "An abort of the client ends a block download and is not answered",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .run = survives_aborts},
    Check{.id = "sdo.block-round-trips",
          .name = "What was downloaded in blocks is uploaded in blocks, twenty times",
          .clause = "CiA 301 7.2.4.3.8",
          .group = Group::Sdo,
          .run = makes_round_trips},
};

}  // namespace

std::span<const Check> sdo_block_download_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
