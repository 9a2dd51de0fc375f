#include <array>

#include <fmt/format.h>

#include "meaning/words.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/sdo_targets.hpp"
#include "tools/canopen-check/checks/shared/silence.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

using canopen::AbortCode;

/// A finding if a frame of the server comes; @p request tells what went before.
void expect_quiet(Context& context, const std::string& request) {
  const auto frames = context.session().collect(under(context.sdo().response_identifier()), context.quiet(kQuiet));
  if (!frames.empty()) context.fail("no answer to " + request, to_text(answer_of(frames.front().frame)));
}

void refuses_segments_of_no_transfer(Context& context) {
  for (const std::uint8_t command : {kUploadSegment, kDownloadSegment}) {
    context.step();
    context.sdo().abort(object::kDeviceType, 0, number_of(AbortCode::GeneralError));
    context.session().pass(context.quiet(kQuiet));  // that an abort is answered is a matter of sdo.client-abort
    const SdoAnswer answer = ask(context, context.sdo().request(command));
    const bool refused = answer.aborted() && answer.abort_code == number_of(AbortCode::CommandSpecifierInvalid);
    if (!refused)
      context.fail(fmt::format("abort {} for a segment {:02X}h without initiation",
                               meaning::abort_text(number_of(AbortCode::CommandSpecifierInvalid)), command),
                   to_text(answer));
  }
}

/// Begins a transfer in segments that the server waits to be continued; false where there is none.
bool begin(Context& context, Target& target) {
  const std::optional<Target> found = long_entry(context, 4);
  if (!found) return context.skip("no entry that can be read has more than four bytes"), false;
  target = *found;
  context.step();
  const SdoAnswer answer = ask(context, context.sdo().request(kInitiateUpload, target.index, target.sub_index));
  if (begins_with(answer, 0x40) || begins_with(answer, 0x41)) return true;
  context.skip("no upload in segments: " + to_text(answer));
  return false;
}

void begins_anew(Context& context) {
  Target target;
  if (!begin(context, target)) return;
  const SdoAnswer answer = context.read(object::kDeviceType);
  if (!answer.done())
    context.fail(object::kDeviceType, 0, "a new transfer in the middle of another one", to_text(answer));
}

void is_silent_to_aborts(Context& context) {
  context.step();
  context.sdo().abort(object::kDeviceType, 0, number_of(AbortCode::GeneralError));
  expect_quiet(context, "an abort of the client");
  Target target;
  if (!begin(context, target)) return;
  context.sdo().abort(target.index, target.sub_index, number_of(AbortCode::GeneralError));
  expect_quiet(context, "an abort of the client in a transfer");
  const SdoAnswer answer = ask(context, context.sdo().request(kUploadSegment));
  if (!answer.aborted())
    context.fail(target.index, target.sub_index, "no segment after an abort of the client", to_text(answer));
}

/// A finding unless @p frame is an abort that names the entry.
void expect_named(Context& context, const std::optional<canopen::Frame>& frame, std::uint16_t index,
                  std::uint8_t sub_index) {
  if (!frame || !abort_code(*frame)) return;  // other checks judge it
  const auto found_index = static_cast<std::uint16_t>(frame->data[1] | frame->data[2] << 8U);
  if (found_index != index || frame->data[3] != sub_index)
    context.fail(index, sub_index, "an abort that names it",
                 "one that names " + to_text(Subject{found_index, frame->data[3]}));
}

void names_the_entry_in_aborts(Context& context) {
  context.step();
  expect_named(context, context.sdo().exchange_any(context.sdo().request(kInitiateUpload, object::kDeviceType, 1)),
               object::kDeviceType, 1);
  context.step();
  expect_named(context, context.sdo().exchange_any(context.sdo().request(kInitiateUpload, object::kReserved)),
               object::kReserved, 0);
  Target target;
  if (!begin(context, target)) return;
  expect_named(context, context.sdo().exchange_any(context.sdo().request(kUploadSegment | kToggleBit)),
               target.index, target.sub_index);
}

void aborts_once(Context& context) {
  struct Error {
    canopen::Frame request;
    const char* text;
  };
  for (const Error& error :
       {Error{context.sdo().request(kInitiateUpload, object::kReserved), "a request for 1004h"},
        Error{context.sdo().request(kInitiateUpload, object::kDeviceType, 1), "a request for 1000h:01"}}) {
    context.step();
    (void)context.sdo().exchange(error.request);
    expect_quiet(context, fmt::format("{} beyond the first one", error.text));
  }
}

void survives_a_silent_client(Context& context) {
  const Silence& silence = silence_of_client(context);
  if (!silence.without_transfer.empty()) return context.skip(silence.without_transfer);
  if (!silence.answer)  // there is no need for it to abort at all
    context.note("the server does not abort within " + milliseconds(kSilence));
  else
    context.expect_abort(answer_of(silence.answer), {number_of(AbortCode::ProtocolTimedOut)},
                         silence.transfer.index, silence.transfer.sub_index, "silence of the client");
  expect_service(context, silence.service, "a transfer that was not ended");
}

/// True if a request of one of the lengths from @p first to @p last is answered; they go out at once.
bool answers_requests_of(Context& context, std::uint8_t first, std::uint8_t last) {
  context.step();
  canopen::Frame frame = context.sdo().request(kInitiateUpload, object::kDeviceType);
  for (frame.length = first; frame.length <= last; ++frame.length) context.session().send(frame);
  const auto frames = context.session().collect(under(context.sdo().response_identifier()), context.quiet(kQuiet));
  return !frames.empty();
}

void bears_short_requests(Context& context) {
  constexpr std::uint8_t kLongest = 7;
  std::string answered;
  // Most servers are silent to all of them.
  if (answers_requests_of(context, 0, kLongest))
    for (std::uint8_t length = 0; length <= kLongest; ++length)
      if (answers_requests_of(context, length, length))
        answered += fmt::format("{}{}", answered.empty() ? "" : ", ", length);
  // What a server does with a request that is none is its own affair.
  if (!answered.empty()) context.note(fmt::format("requests of {} bytes are answered", answered));
  expect_service(context, "short requests");
}

void ignores_remote_frames(Context& context) {
  if (!context.session().carries_remote_frames()) return context.skip("the bus carries no remote frames");
  context.step();
  context.session().send({.id = context.sdo().request_identifier(), .length = 8, .remote = true});
  expect_quiet(context, "a remote frame under the identifier of requests");
  expect_service(context, "a remote frame");
}

void ignores_requests_to_others(Context& context) {
  constexpr std::uint8_t kHighestNode = 127;
  context.step();
  canopen::Frame frame = context.sdo().request(kInitiateUpload, object::kDeviceType);
  for (std::uint8_t node = 1; node <= kHighestNode; ++node) {
    if (node == context.session().node_id()) continue;
    frame.id = function_code::kSdoRequest + node;
    context.session().send(frame);
  }
  expect_quiet(context, "requests to all other nodes");
}

void bears_two_requests_at_once(Context& context) {
  context.session().drain();
  context.step();
  const canopen::Frame request = context.sdo().request(kInitiateUpload, object::kDeviceType);
  context.session().send(request);
  context.session().send(request);
  int answers = 0;
  while (answers < 2 && context.sdo().listen(answers == 0 ? context.sdo().patience() : context.quiet(kQuiet)))
    ++answers;
  if (answers == 0)
    context.fail(object::kDeviceType, 0, "an answer to the first or the second of two requests", "none");
  context.note(fmt::format("{} of two requests at once are answered", answers));
  expect_service(context, "two requests at once");
}

constexpr std::array kChecks{
    Check{.id = "sdo.segment-without-transfer",
          .name = "A segment without initiation is refused with 05040001h",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .run = refuses_segments_of_no_transfer},
    Check{.id = "sdo.new-transfer",
          .name = "An initiation in the middle of a transfer begins a new one",
          .clause = "CiA 301 7.2.4.3.6",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = begins_anew},
    Check{.id = "sdo.client-abort",
          .name = "An abort of the client ends the transfer and is not answered",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = is_silent_to_aborts},
    Check{.id = "sdo.abort-entry",
          .name = "An abort names the object and sub-index of the transfer",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = names_the_entry_in_aborts},
    Check{.id = "sdo.one-abort",
          .name = "An error is answered with one abort",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = aborts_once},
    Check{.id = "sdo.silent-client",
          .name = "A client that falls silent gets 05040000h or nothing, and the next transfer works",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = survives_a_silent_client},
    Check{.id = "sdo.short-request",
          .name = "Requests of fewer than eight bytes are ignored or answered, and do no harm",
          .clause = "CiA 301 7.2.4.3.1",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = bears_short_requests},
    Check{.id = "sdo.remote-request",
          .name = "Remote frames under the identifier of requests are ignored",
          .clause = "CiA 301 7.2.4.3.1",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = ignores_remote_frames},
    Check{.id = "sdo.other-nodes",
          .name = "Requests to other nodes are not answered",
          .clause = "CiA 301 7.3.5",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = ignores_requests_to_others},
    Check{.id = "sdo.two-requests",
          .name = "A request that comes before the answer to another one does no harm",
          .clause = "CiA 301 7.2.4.1",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = bears_two_requests_at_once},
};

}  // namespace

std::span<const Check> sdo_frame_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
