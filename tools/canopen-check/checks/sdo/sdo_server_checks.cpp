#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/read_ahead.hpp"
#include "tools/canopen-check/checks/shared/sdo_targets.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

using canopen::AbortCode;

constexpr std::uint16_t kFirst = 0x1201, kLast = 0x127F;
// 680h to 6DFh belong to no service of the predefined connection set and are not restricted.
constexpr std::uint32_t kFreeRequest = 0x6A0, kFreeResponse = 0x6A1;

/// The first further server of the EDS whose COB-IDs can be written; 0, and the check is skipped, without one.
std::uint16_t further_server(Context& context) {
  for (const std::uint16_t index : context.eds().objects_within(kFirst, kLast)) {
    const eds::EntryFacts* const request = context.eds().find(index, 1);
    const eds::EntryFacts* const response = context.eds().find(index, 2);
    if (request != nullptr && response != nullptr && request->writable() && response->writable()) return index;
  }
  context.skip("objects 1201h to 127Fh with COB-IDs that can be written are not in the EDS");
  return 0;
}

void has_the_servers_of_the_eds(Context& context) {
  if (context.eds().empty()) return context.skip("there is no EDS");
  for (const eds::EntryFacts& entry : context.eds().entries()) {
    if (entry.index < kFirst || entry.index > kLast || !entry.readable()) continue;
    (void)context.number(entry.index, entry.sub_index);
  }
  std::vector<Multiplexor> absent;
  for (std::uint16_t index = kFirst; index <= kLast; ++index)
    if (!context.eds().has(index)) absent.push_back({index, 1});
  ReadAhead answers{context, absent};
  for (const auto& [index, sub_index] : absent) {
    if (context.session().ended()) break;
    const SdoAnswer answer = answers.next([](const SdoAnswer& early) {
      return early.aborted() && early.abort_code == number_of(AbortCode::NoObject);
    });
    context.expect_abort(answer, {number_of(AbortCode::NoObject)}, index, sub_index, "reading it");
    if (answer.kind == SdoAnswer::Kind::Silent) break;
  }
}

/// Makes the COB-IDs of a server invalid, which is the way to others; false, and a finding, if they do not become
/// so.
bool disable(Context& context, std::uint16_t server) {
  for (std::uint8_t sub = 1; sub <= 2; ++sub) {
    const std::optional<std::uint64_t> now = context.number(server, sub);
    if (!now) return false;
    if ((*now & kInvalid) == 0 && !context.set(server, sub, *now | kInvalid)) return false;
  }
  return true;
}

/// Identifiers of a server; both 0 where it takes none.
struct Channel {
  std::uint32_t request = 0, response = 0;
};

bool takes(Context& context, std::uint16_t server, const Channel& channel) {
  return context.write_number(server, 1, channel.request).done() &&
         context.write_number(server, 2, channel.response).done();
}

/// Gives the server @p server identifiers that nothing else uses: free ones, else those of another node.
Channel enable(Context& context, std::uint16_t server) {
  if (!disable(context, server)) return {};
  const std::uint32_t other = context.session().node_id() == 127 ? 126 : context.session().node_id() + 1U;
  const Channel free{kFreeRequest, kFreeResponse},
      of_other{function_code::kSdoRequest + other, function_code::kSdoResponse + other};
  for (const Channel& channel : {free, of_other})
    if (takes(context, server, channel)) return channel;
  context.skip("the server takes no identifiers");  // sdo.server-identifiers
  return {};
}

SdoClient client_of(Context& context, const Channel& channel) {
  return {context.session(), channel.request, channel.response, context.settings().patience};
}

void takes_free_identifiers(Context& context) {
  const std::uint16_t server = further_server(context);
  if (server == 0 || !disable(context, server)) return;
  for (std::uint8_t sub = 1; sub <= 2; ++sub)
    (void)context.set(server, sub, sub == 1 ? kFreeRequest : kFreeResponse);
}

void serves_a_second_channel(Context& context) {
  const std::uint16_t server = further_server(context);
  if (server == 0) return;
  const Channel channel = enable(context, server);
  if (channel.request == 0) return;
  SdoClient second = client_of(context, channel);
  context.step();
  const SdoAnswer expected = context.read(object::kDeviceType), found = second.upload(object::kDeviceType, 0);
  if (!found.done() || found.data != expected.data)
    context.fail(server, 1, fmt::format("{} from 1000h under {:03X}h", to_text(expected), channel.response),
                 to_text(found));
}

void keeps_channels_apart(Context& context) {
  const std::uint16_t server = further_server(context);
  if (server == 0) return;
  const std::optional<Target> target = long_entry(context, 4);
  if (!target) return context.skip("no entry that can be read has more than four bytes");
  const Channel channel = enable(context, server);
  if (channel.request == 0) return;
  SdoClient second = client_of(context, channel);
  const SdoAnswer expected = context.read(object::kDeviceType);
  context.step();
  const SdoAnswer begun = ask(context, context.sdo().request(kInitiateUpload, target->index, target->sub_index));
  // 1000h, since a further server may show other objects than the first one.
  const SdoAnswer between = second.upload(object::kDeviceType, 0);
  const SdoAnswer next = ask(context, context.sdo().request(kUploadSegment));
  context.sdo().abort(target->index, target->sub_index, number_of(AbortCode::GeneralError));
  if (between.kind == SdoAnswer::Kind::Silent) return;  // sdo.second-server
  const bool goes_on = next.done() && (next.data[0] & 0xF0U) == 0;
  if (!begun.done() || !goes_on)
    context.fail(server, 1, "the transfer of the first server goes on", to_text(next));
  if (between.data != expected.data)
    context.fail(server, 1, "the second server uploads in the middle of it", to_text(between));
}

void falls_silent(Context& context) {
  const std::uint16_t server = further_server(context);
  if (server == 0) return;
  const Channel channel = enable(context, server);
  if (channel.request == 0 || !context.set(server, 1, channel.request | kInvalid)) return;
  context.step();
  context.session().send(client_of(context, channel).request(kInitiateUpload, object::kDeviceType));
  const auto frames = context.session().collect(under(channel.response), context.quiet(kQuiet));
  if (!frames.empty())
    context.fail(server, 1, "no answer of a server that bit 31 switches off",
                 to_text(answer_of(frames.front().frame)));
}

void loses_identifiers_with_a_reset(Context& context) {
  const std::uint16_t server = further_server(context);
  if (server == 0 || !context.restart(canopen::NmtCommand::ResetCommunication)) return;
  const std::optional<std::uint64_t> request = context.number(server, 1), response = context.number(server, 2);
  if (!request || !response || enable(context, server).request == 0) return;
  if (!context.restart(canopen::NmtCommand::ResetCommunication)) return;
  for (std::uint8_t sub = 1; sub <= 2; ++sub) {
    const std::uint64_t before = sub == 1 ? *request : *response;
    const std::optional<std::uint64_t> now = context.number(server, sub);
    if (now && *now != before)
      context.fail(server, sub, fmt::format("{:08X}h as before, since nothing was saved", before),
                   fmt::format("{:08X}h", *now));
  }
}

void refuses_restricted_identifiers(Context& context) {
  const std::uint16_t server = further_server(context);
  if (server == 0 || !disable(context, server)) return;
  // 581h to 5FFh and 601h to 67Fh are restricted too, but free to servers of many devices.
  for (const std::uint32_t identifier : {0x000U, 0x001U, 0x07FU, 0x101U, 0x180U, 0x6E0U, 0x701U, 0x7FFU}) {
    context.step();
    const SdoAnswer answer = context.write_number(server, 1, identifier);
    context.expect_abort(answer,
                         {number_of(AbortCode::InvalidValue), number_of(AbortCode::ValueTooLow),
                          number_of(AbortCode::ValueTooHigh)},
                         server, 1, fmt::format("the restricted identifier {:03X}h", identifier));
    if (answer.done()) (void)context.write_number(server, 1, identifier | kInvalid);
  }
}

void refuses_identifiers_in_use(Context& context) {
  const std::uint16_t server = further_server(context);
  if (server == 0 || !disable(context, server)) return;
  const std::uint32_t own = context.sdo().request_identifier();
  context.step();
  const SdoAnswer answer = context.write_number(server, 1, own);
  if (answer.done()) (void)context.write_number(server, 1, own | kInvalid);
  if (!answer.aborted())
    context.fail(server, 1, fmt::format("{:03X}h, which the first server has, is refused", own), to_text(answer));
}

constexpr std::array kChecks{
    Check{.id = "sdo.servers",
          .name = "The SDO servers are those of the EDS, others are refused with 06020000h",
          .clause = "CiA 301 7.5.2.33",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = has_the_servers_of_the_eds},
    Check{.id = "sdo.server-identifiers",
          .name = "A further SDO server takes identifiers that are free",
          .clause = "CiA 301 7.5.2.33",
          .group = Group::Sdo,
          .run = takes_free_identifiers},
    Check{.id = "sdo.second-server",
          .name = "A further SDO server works under its identifiers",
          .clause = "CiA 301 7.5.2.33",
          .group = Group::Sdo,
          .run = serves_a_second_channel},
    Check{.id = "sdo.interleaved-servers",
          .name = "Two SDO servers have a transfer each at the same time",
          .clause = "CiA 301 7.5.2.33",
          .group = Group::Sdo,
          .run = keeps_channels_apart},
    Check{.id = "sdo.server-disabled",
          .name = "Bit 31 switches a further SDO server off",
          .clause = "CiA 301 7.5.2.33",
          .group = Group::Sdo,
          .run = falls_silent},
    Check{.id = "sdo.server-reset",
          .name = "A reset of the communication takes back identifiers of a further SDO server",
          .clause = "CiA 301 7.3.2.2",
          .group = Group::Sdo,
          .run = loses_identifiers_with_a_reset},
    Check{.id = "sdo.server-restricted",
          .name = "A further SDO server refuses restricted identifiers with 06090030h",
          .clause = "CiA 301 7.3.5",
          .group = Group::Sdo,
          .run = refuses_restricted_identifiers},
    Check{.id = "sdo.server-collision",
          .name = "A further SDO server refuses an identifier that another one has",
          .clause = "CiA 301 7.5.2.33",
          .group = Group::Sdo,
          .run = refuses_identifiers_in_use},
};

}  // namespace

std::span<const Check> sdo_server_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
