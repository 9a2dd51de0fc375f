#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/sdo/block_client.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

using canopen::AbortCode;

constexpr std::uint8_t kRequest = 0xA0;

/// False, and the check is skipped, where the server has no block transfer.
bool has_block_transfer(Context& context) {
  const SdoAnswer answer = ask(context, context.sdo().request(kRequest, object::kDeviceType, 0, 1));
  if (answer.aborted() && answer.abort_code == number_of(AbortCode::CommandSpecifierInvalid)) {
    context.skip("block transfer is refused with 05040001h");
    return false;
  }
  context.sdo().abort(object::kDeviceType, 0, number_of(AbortCode::GeneralError));
  return true;
}

Target device_type(Context& context) {
  return {object::kDeviceType, 0, context.read(object::kDeviceType).data};
}

/// A finding unless a block upload of @p target gives its value.
void expect_upload(Context& context, const Target& target, const BlockOptions& options, const std::string& how) {
  context.step();
  const SdoAnswer answer = block_upload(context, target, options);
  if (!answer.done() || answer.data != target.value)
    context.fail(target.index, target.sub_index, hexadecimal(target.value) + " by block upload " + how,
                 to_text(answer));
}

/// Uploads 1000h and a longer entry with @p options.
void expect_uploads(Context& context, const BlockOptions& options, const std::string& how) {
  if (!has_block_transfer(context)) return;
  expect_upload(context, device_type(context), options, how);
  if (const std::optional<Target> target = long_entry(context, 4)) expect_upload(context, *target, options, how);
}

void uploads_without_crc(Context& context) {
  expect_uploads(context, {.crc = false}, "without CRC");
}

void uploads_with_crc(Context& context) {
  expect_uploads(context, {}, "with CRC");
}

void uploads_in_blocks_of_any_size(Context& context) {
  if (!has_block_transfer(context)) return;
  const std::optional<Target> target = long_entry(context, 7);
  if (!target) return context.skip("no entry that can be read has more than seven bytes");
  for (const int size : {1, 2, 127})
    expect_upload(context, *target, {.block_size = static_cast<std::uint8_t>(size), .crc = false},
                  fmt::format("in sub-blocks of {}", size));
}

void refuses_block_sizes(Context& context) {
  if (!has_block_transfer(context)) return;
  for (const int size : {0, 128}) {
    context.step();
    const SdoAnswer answer =
        ask(context, context.sdo().request(kRequest, object::kDeviceType, 0, static_cast<std::uint32_t>(size)));
    context.expect_abort(answer,
                         {number_of(AbortCode::InvalidBlockSize), number_of(AbortCode::CommandSpecifierInvalid)},
                         object::kDeviceType, 0, fmt::format("a block upload in sub-blocks of {}", size));
    if (!answer.aborted()) context.sdo().abort(object::kDeviceType, 0, number_of(AbortCode::InvalidBlockSize));
  }
}

void refuses_confirmations(Context& context) {
  if (!has_block_transfer(context)) return;
  constexpr std::uint8_t kTooMany = 128;
  const SdoAnswer answer = block_upload(context, device_type(context), {.confirmed_as = kTooMany});
  context.expect_abort(
      answer, {number_of(AbortCode::InvalidSequenceNumber), number_of(AbortCode::CommandSpecifierInvalid)},
      object::kDeviceType, 0, "a confirmation of segment 128");
}

void repeats_lost_segments(Context& context) {
  if (!has_block_transfer(context)) return;
  const std::optional<Target> target = long_entry(context, 14);
  if (!target) return context.skip("no entry that can be read has more than fourteen bytes");
  expect_upload(context, *target, {.block_size = 3, .crc = false, .lost = 2}, "whose segment 2 got lost");
}

void switches_protocols(Context& context) {
  if (!has_block_transfer(context)) return;
  constexpr std::uint8_t kThreshold = 4;
  // The server may switch to a normal upload or not.
  expect_upload(context, device_type(context), {.crc = false, .switch_up_to = kThreshold},
                "with a protocol switch threshold of 4");
}

void survives_aborts(Context& context) {
  if (!has_block_transfer(context)) return;
  context.step();
  (void)ask(context, context.sdo().request(kRequest, object::kDeviceType, 0, 1));
  context.sdo().abort(object::kDeviceType, 0, number_of(AbortCode::GeneralError));
  const auto frames = context.session().collect(under(context.sdo().response_identifier()), context.quiet(kQuiet));
  if (!frames.empty())
    context.fail(object::kDeviceType, 0, "no answer to an abort of the client in a block upload",
                 to_text(answer_of(frames.front().frame)));
  expect_service(context, "a block upload that the client aborted");
}

constexpr std::array kChecks{
    Check{.id = "sdo.block-upload",
          .name = "A block upload without CRC gives the same data as a normal one",
          .clause = "CiA 301 7.2.4.3.12",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = uploads_without_crc},
    Check{.id = "sdo.block-upload-crc",
          .name = "A block upload with CRC gives the same data and their CRC",
          .clause = "CiA 301 7.2.4.3.16",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = uploads_with_crc},
    Check{.id = "sdo.block-sizes",
          .name = "Sub-blocks of 1, 2 and 127 segments are sent",
          .clause = "CiA 301 7.2.4.3.14",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = uploads_in_blocks_of_any_size},
    Check{.id = "sdo.block-size-error",
          .name = "Sub-blocks of 0 and 128 segments are refused with 05040002h",
          .clause = "CiA 301 7.2.4.3.13",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = refuses_block_sizes},
    Check{.id = "sdo.block-sequence-error",
          .name = "The confirmation of segment 128 is refused with 05040003h",
          .clause = "CiA 301 7.2.4.3.14",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = refuses_confirmations},
    Check{.id = "sdo.block-upload-loss",
          .name = "A segment that was lost in a block upload is sent again, from sequence number 1 on",
          .clause = "CiA 301 7.2.4.3.14",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = repeats_lost_segments},
    Check{.id = "sdo.block-switch",
          .name = "A protocol switch threshold allows a normal upload and asks for nothing else",
          .clause = "CiA 301 7.2.4.3.13",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = switches_protocols},
    Check{.id = "sdo.block-abort",
          .name = "An abort of the client ends a block upload and is not answered",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = survives_aborts},
};

}  // namespace

std::span<const Check> sdo_block_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
