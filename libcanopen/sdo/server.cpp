#include "libcanopen/sdo/server.hpp"

#include <algorithm>
#include <cassert>

namespace canopen {

using sdo::Address;
using sdo::command_byte;
using sdo::CommandByte;
using sdo::Request;
using sdo::Response;

namespace {

/// Bytes of a DOMAIN that are held at a time: a sub-block, which may be sent again, and the byte that tells
/// whether it is the last one.
constexpr std::size_t kWindow = 1024;
static_assert(kWindow > sdo::kLongestBlock * sdo::kSegmentBytes);
/// Bytes behind the window that are read with the last ones in it.
constexpr std::size_t kMargin = 8;

constexpr bool fits_one_frame(const Entry& entry) noexcept {
  return entry.size != 0 && entry.size <= 4;
}

/// Bytes that an expedited download carries to @p entry if it does not say how many.
constexpr unsigned expedited_size(const Entry& entry) noexcept {
  return fits_one_frame(entry) ? entry.size : 4;
}

}  // namespace

SdoServer::SdoServer(Context& context, std::size_t timer, sdo::DomainLocks& locks, std::size_t position,
                     std::uint8_t number)
    : context_{context},
      locks_{locks},
      timer_{timer},
      position_{position},
      number_{number},
      buffer_(std::max(kWindow, context.dictionary.longest_value()) + kMargin),
      source_{std::span{buffer_}.first(buffer_.size() - kMargin)},
      sink_{std::span{buffer_}.first(buffer_.size() - kMargin)} {}

bool SdoServer::connect(Identifier request, Identifier response) noexcept {
  if (request == request_identifier() && response == response_identifier()) return false;
  end();
  request_identifier_ = request;
  answer_ = frame_under(response, 8);
  return true;
}

void SdoServer::on_frame(const Frame& frame) noexcept {
  if (frame.length != 8) return;
  if (phase_ >= Phase::BlockDownload) return on_awaited_frame(frame);
  const CommandByte command{frame.data[0]};
  switch (command.request()) {
    case Request::InitiateUpload:
      return initiate_upload(frame);
    case Request::InitiateDownload:
      return initiate_download(frame);
    case Request::UploadSegment:
      return upload_segment(command);
    case Request::DownloadSegment:
      return download_segment(frame);
    case Request::Abort:
      return end();
    case Request::BlockUpload:
      return on_block_upload(frame);
    case Request::BlockDownload:
      return on_block_download(frame);
  }
  abort(phase_ == Phase::Idle ? sdo::address_in(frame) : address_, AbortCode::CommandSpecifierInvalid);
}

inline void SdoServer::upload_expedited(const Entry& entry, Address at) noexcept {
  auto bits = load<std::uint32_t>(context_.dictionary.image() + entry.offset);  // above its size there is nothing
  if (entry.read_owner != nullptr) {
    const auto value = context_.dictionary.read(entry);
    if (!value) return abort(at, value.error());
    bits = static_cast<std::uint32_t>(static_cast<std::uint64_t>(*value) & byte_mask(entry.size));
  }
  send(sdo::response_bytes(sdo::expedited_upload(entry.size), at, bits));
}

void SdoServer::initiate_upload(const Frame& frame) noexcept {
  const Address at = sdo::address_in(frame);
  const Entry* const entry = find(at);
  if (entry == nullptr) return abort(at, context_.dictionary.absence(at.index));
  if (!entry->readable) return abort(at, AbortCode::WriteOnly);
  if (fits_one_frame(*entry)) return upload_expedited(*entry, at);
  if (auto opened = open_source(*entry); !opened) return abort(at, opened.error());
  begin_segmented_upload(at);
}

void SdoServer::initiate_download(const Frame& frame) noexcept {
  const Address at = sdo::address_in(frame);
  const Entry* const entry = find(at);
  if (entry == nullptr) return abort(at, context_.dictionary.absence(at.index));
  if (!entry->writable) return abort(at, AbortCode::ReadOnly);
  const CommandByte command{frame.data[0]};
  if (!command.is_expedited()) return initiate_segmented_download(*entry, frame);
  const unsigned size = command.has_size() ? command.expedited_size() : expedited_size(*entry);
  if (!sdo::is_plain(*entry) || size != entry->size) return download_expedited(*entry, frame, size);
  Frame answer = answer_;  // as below
  context_.dictionary.set(*entry, load<std::uint32_t>(&frame.data[4]));
  context_.application.on_sdo_written(*entry);
  store(answer.data.data(), sdo::response_bytes(command_byte(Response::InitiateDownload), at, 0));
  deliver(answer);
}

void SdoServer::download_expedited(const Entry& entry, const Frame& frame, std::size_t size) noexcept {
  Frame answer = answer_;  // the write may connect the server anew: the client still waits here
  const Address at = sdo::address_in(frame);
  const std::span bytes{&frame.data[4], size};
  context_.answer_deferred = false;
  const auto written = write_expedited(entry, bytes);
  const std::uint64_t done = sdo::response_bytes(command_byte(Response::InitiateDownload), at, 0);
  if (written && context_.answer_deferred) return defer(at, done, load<std::uint64_t>(frame.data.data()));
  store(answer.data.data(), written ? done : abort_answer(at, written.error()));
  deliver(answer);
}

/// The owner has put off the answer @p bytes to @p request, 0 if that took several frames.
void SdoServer::defer(Address at, std::uint64_t bytes, std::uint64_t request) noexcept {
  phase_ = Phase::Deferred;
  address_ = at;
  deferred_request_ = request;
  store(answer_.data.data(), bytes);
}

void SdoServer::answer_deferred(const Result<void>& result) noexcept {
  if (phase_ != Phase::Deferred) return;
  if (!result) return abort(result.error());
  end();
  deliver(answer_);
}

/// A segment of a block; or a request while an answer is put off. That may be the same request again, from a
/// client that has lost its patience; any other gives the answer up.
void SdoServer::on_awaited_frame(const Frame& frame) noexcept {
  if (phase_ == Phase::BlockDownload) return take_block_segment(frame);
  if (deferred_request_ != 0 && load<std::uint64_t>(frame.data.data()) == deferred_request_) return;
  end();
  return context_.view != nullptr ? on_viewed_frame(frame) : on_frame(frame);
}

Result<void> SdoServer::write_expedited(const Entry& entry, std::span<const std::uint8_t> bytes) noexcept {
  if (entry.domain == nullptr) return sdo::write_value(context_, entry, bytes);
  if (auto opened = open_sink(entry, static_cast<std::uint32_t>(bytes.size())); !opened) return opened;
  auto written = sink_.append(bytes);
  if (written) written = sink_.commit(context_);
  sink_.cancel();
  locks_.release(position_);
  return written;
}

Result<void> SdoServer::open_source(const Entry& entry) noexcept {
  if (entry.domain == nullptr) return source_.open(context_.dictionary, entry);
  if (!locks_.allow(entry, false)) return refuse(AbortCode::DeviceState);
  auto opened = source_.open(context_.dictionary, entry);
  if (opened) locks_.take(position_, entry, false);
  return opened;
}

Result<void> SdoServer::open_sink(const Entry& entry, std::optional<std::uint32_t> size) noexcept {
  if (entry.domain == nullptr) return sink_.open(entry, size);
  if (!locks_.allow(entry, true)) return refuse(AbortCode::DeviceState);
  auto opened = sink_.open(entry, size);
  if (opened) locks_.take(position_, entry, true);
  return opened;
}

void SdoServer::begin(Phase phase, Address at) noexcept {
  assert(phase_ == Phase::Idle && phase != Phase::Idle);
  phase_ = phase;
  address_ = at;
  toggle_ = 0;
  confirmed_early_ = false;
  last_request_ = last_progress_ = context_.now;
  context_.timers.arm(timer_, due());
}

void SdoServer::end() noexcept {
  if (phase_ == Phase::Idle) return;
  phase_ = Phase::Idle;
  context_.timers.cancel(timer_);
  sink_.cancel();
  locks_.release(position_);
}

/// All of a download is there: writes it, and answers with @p answer if that succeeds.
void SdoServer::finish_download(std::uint64_t answer) noexcept {
  Frame frame = answer_;  // the write may connect the server anew: the client still waits here
  const Address at = address_;
  context_.answer_deferred = false;
  const auto written = sink_.commit(context_);
  end();
  if (written && context_.answer_deferred) return defer(at, answer, 0);
  store(frame.data.data(), written ? answer : abort_answer(at, written.error()));
  deliver(frame);
}

/// When on_timer() acts if the client stays silent.
TimePoint SdoServer::due() const noexcept {
  const Duration timeout = context_.policy.sdo_timeout;
  if (phase_ != Phase::BlockDownload) return last_request_ + timeout;
  if (confirmed_early_) return last_request_ + timeout / 2;
  return std::min(last_request_ + timeout / 2, last_progress_ + timeout);
}

void SdoServer::on_timer() noexcept {
  if (phase_ == Phase::Idle) return;
  if (due() > context_.now) {  // the timer is not moved with every segment
    context_.timers.arm(timer_, due());
  } else if (may_confirm_early() && context_.now < last_progress_ + context_.policy.sdo_timeout) {
    confirm_early();
  } else {
    abort(AbortCode::ProtocolTimedOut);
  }
}

void SdoServer::abort(Address at, AbortCode code) noexcept {
  end();
  send(abort_answer(at, code));
}

/// Aborts: the request, which has no multiplexer, is not what the server waits for.
void SdoServer::refuse_command() noexcept {
  abort(phase_ == Phase::Idle ? Address{} : address_, AbortCode::CommandSpecifierInvalid);
}

}  // namespace canopen
