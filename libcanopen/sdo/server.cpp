#include "libcanopen/sdo/server.hpp"

#include <algorithm>

namespace canopen {

using sdo::Address;
using sdo::Command;
using sdo::Request;

namespace {
constexpr std::uint8_t byte_of(sdo::Response response) noexcept {
  return static_cast<std::uint8_t>(response);
}
constexpr std::uint8_t kSizeIndicated = 0x01;
constexpr std::uint8_t kLastSegment = 0x01;
constexpr std::size_t kSegmentBytes = 7;
}  // namespace

SdoServer::SdoServer(Context& context, std::size_t timer)
    : context_{context}, timer_{timer}, buffer_(context.dictionary.longest_value()) {}

void SdoServer::connect(Identifier request, Identifier response) noexcept {
  request_identifier_ = request;
  response_identifier_ = response;
}

void SdoServer::on_frame(const Frame& frame) noexcept {
  if (frame.length != 8) return;
  last_request_ = context_.now;
  const Command command{frame.data[0]};
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
    case Request::BlockDownload:
      break;
  }
  abort(transfer_ == Transfer::None ? sdo::address_in(frame) : address_, AbortCode::CommandSpecifierInvalid);
}

Result<const Entry*> SdoServer::find(Address at) noexcept {
  end();  // an initiate request ends the transfer before it without a word
  address_ = at;
  return context_.dictionary.find(at.index, at.sub_index);
}

void SdoServer::initiate_upload(const Frame& frame) noexcept {
  const Address at = sdo::address_in(frame);
  const auto entry = find(at);
  if (!entry) return abort(at, entry.error());
  if (!(*entry)->readable) return abort(at, AbortCode::WriteOnly);
  std::size_t size = (*entry)->size;
  if (size != 0) {
    const auto value = context_.dictionary.read(**entry);
    if (!value) return abort(at, value.error());
    if (size <= 4) {
      const auto bits = static_cast<std::uint32_t>(static_cast<std::uint64_t>(*value) & byte_mask((*entry)->size));
      return send(sdo::response(response_identifier_, sdo::expedited_upload((*entry)->size), at, bits));
    }
    store(buffer_.data(), *value);
  } else {
    const auto text = context_.dictionary.text(**entry);
    std::copy(text.begin(), text.end(), buffer_.begin());
    size = text.size();
  }
  begin(Transfer::Upload, size);
  send(sdo::response(response_identifier_, byte_of(sdo::Response::InitiateUpload) | kSizeIndicated, at,
                     static_cast<std::uint32_t>(size)));
}

void SdoServer::upload_segment(Command command) noexcept {
  if (!continues(Transfer::Upload, command)) return;
  const std::size_t bytes = std::min(size_ - done_, kSegmentBytes);
  const bool last = done_ + bytes == size_;
  Frame frame = frame_under(response_identifier_, 8);
  frame.data[0] = static_cast<std::uint8_t>(byte_of(sdo::Response::UploadSegment) | command.toggle() |
                                            (kSegmentBytes - bytes) << 1 | (last ? kLastSegment : 0));
  std::copy_n(buffer_.begin() + static_cast<std::ptrdiff_t>(done_), bytes, frame.data.begin() + 1);
  done_ += bytes;
  if (last) end();
  send(frame);
}

void SdoServer::initiate_download(const Frame& frame) noexcept {
  const Command command{frame.data[0]};
  const Address at = sdo::address_in(frame);
  const auto entry = find(at);
  if (!entry) return abort(at, entry.error());
  if (!(*entry)->writable) return abort(at, AbortCode::ReadOnly);
  if (command.is_expedited()) {
    const std::size_t expected = (*entry)->size != 0 ? std::min<std::size_t>((*entry)->size, 4) : 4;
    const std::size_t size = command.has_size() ? command.expedited_size() : expected;
    const auto written = commit(**entry, {&frame.data[4], size}, load<std::uint32_t>(&frame.data[4]));
    return written ? acknowledge_download() : abort(at, written.error());
  }
  const std::size_t announced = load<std::uint32_t>(&frame.data[4]);
  const bool fits =
      (*entry)->size != 0 ? announced == (*entry)->size : announced <= (*entry)->description->capacity;
  if (command.has_size() && !fits) return abort(at, AbortCode::LengthMismatch);
  entry_ = *entry;
  size_announced_ = command.has_size();
  begin(Transfer::Download, size_announced_ ? announced : 0);
  acknowledge_download();
}

void SdoServer::download_segment(const Frame& frame) noexcept {
  const Command command{frame.data[0]};
  if (!continues(Transfer::Download, command)) return;
  const std::size_t bytes = command.segment_size();
  if (size_announced_ && done_ + bytes > size_) return abort(address_, AbortCode::LengthTooHigh);
  if (done_ + bytes > buffer_.size()) return abort(address_, AbortCode::LengthMismatch);
  std::copy_n(frame.data.begin() + 1, bytes, buffer_.begin() + static_cast<std::ptrdiff_t>(done_));
  done_ += bytes;
  if (command.is_last()) {
    if (size_announced_ && done_ < size_) return abort(address_, AbortCode::LengthTooLow);
    const auto written = commit(*entry_, {buffer_.data(), done_}, load<std::uint64_t>(buffer_.data()));
    if (!written) return abort(address_, written.error());
    end();
  }
  send(sdo::response(response_identifier_,
                     static_cast<std::uint8_t>(byte_of(sdo::Response::DownloadSegment) | command.toggle()), {},
                     0));
}

/// True if @p command is the segment that the transfer waits for; otherwise the transfer is aborted.
bool SdoServer::continues(Transfer transfer, Command command) noexcept {
  if (transfer_ != transfer) {
    abort(transfer_ == Transfer::None ? Address{} : address_, AbortCode::CommandSpecifierInvalid);
    return false;
  }
  if (command.toggle() != toggle_) {
    abort(address_, AbortCode::ToggleBitNotAlternated);
    return false;
  }
  toggle_ ^= 0x10;
  return true;
}

/// Writes @p data, whose first bytes are also in @p word with anything behind them.
Result<void> SdoServer::commit(const Entry& entry, std::span<const std::uint8_t> data,
                               std::uint64_t word) noexcept {
  if (entry.size == 0) return context_.dictionary.write_text(entry, data);
  if (data.size() != entry.size) return refuse(AbortCode::LengthMismatch);
  const std::uint64_t bits = word & byte_mask(entry.size);
  const std::int64_t value = entry.is_signed ? sign_extend(bits, entry.size) : static_cast<std::int64_t>(bits);
  return context_.dictionary.write(entry, value);
}

void SdoServer::begin(Transfer transfer, std::size_t size) noexcept {
  transfer_ = transfer;
  toggle_ = 0;
  size_ = size;
  done_ = 0;
  context_.timers.arm(timer_, context_.now + context_.policy.sdo_timeout);
}

void SdoServer::end() noexcept {
  if (transfer_ == Transfer::None) return;
  transfer_ = Transfer::None;
  context_.timers.cancel(timer_);
}

void SdoServer::forget() noexcept {
  end();
}

void SdoServer::on_timer() noexcept {
  if (transfer_ == Transfer::None) return;
  const TimePoint due = last_request_ + context_.policy.sdo_timeout;
  if (due > context_.now) {  // the timer is not moved with every segment
    context_.timers.arm(timer_, due);
  } else {
    abort(address_, AbortCode::ProtocolTimedOut);
  }
}

void SdoServer::acknowledge_download() noexcept {
  send(sdo::response(response_identifier_, byte_of(sdo::Response::InitiateDownload), address_, 0));
}

void SdoServer::abort(Address at, AbortCode code) noexcept {
  end();
  send(sdo::response(response_identifier_, byte_of(sdo::Response::Abort), at, static_cast<std::uint32_t>(code)));
}

}  // namespace canopen
