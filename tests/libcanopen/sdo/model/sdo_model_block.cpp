#include <algorithm>

#include "tests/libcanopen/sdo/model/sdo_model.hpp"

namespace model {

namespace {

constexpr std::size_t kSegment = 7;
constexpr std::uint8_t kMostSegments = 127;

bool is_block_size(std::uint8_t size) {
  return size >= 1 && size <= kMostSegments;
}

/// An empty value takes one segment too.
std::size_t segments_for(std::size_t bytes) {
  return std::max<std::size_t>(1, (bytes + kSegment - 1) / kSegment);
}

}  // namespace

std::uint16_t crc_of(const Bytes& bytes) {
  unsigned crc = 0;
  for (const std::uint8_t byte : bytes) {
    crc ^= unsigned{byte} << 8;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 0x8000) != 0 ? crc << 1 ^ 0x1021 : crc << 1;
    crc &= 0xFFFF;
  }
  return static_cast<std::uint16_t>(crc);
}

void Server::block_upload(const Data& request) {
  const unsigned sub_command = request[0] & 3U;
  if (sub_command == 0) return initiate_block_upload(request);
  if (sub_command == 3 && phase_ == Phase::BlockUploadOffered) return send_sub_block();
  if (sub_command == 2 && phase_ == Phase::BlockUploadSent) return confirm_upload(request);
  if (sub_command == 1 && phase_ == Phase::BlockUploadEnded) return end();
  abort(AbortCode::CommandSpecifierInvalid);
}

void Server::initiate_block_upload(const Data& request) {
  if (!find(request)) return;
  if (!is_block_size(request[4])) {
    const bool may_refuse_otherwise = !object_->readable || object_->writer != nullptr;
    abort(AbortCode::InvalidBlockSize);
    if (may_refuse_otherwise)
      answer_.or_abort = !object_->readable ? AbortCode::WriteOnly : AbortCode::DeviceState;
    return;
  }
  if (!begin_read()) return;
  const bool has_size = !object_->streamed || object_->size_is_known;
  const std::uint8_t switch_threshold = request[5];
  if (switch_threshold != 0 && has_size && data_.size() <= switch_threshold) return initiate_upload(request);
  open(Phase::BlockUploadOffered, false);
  crc_ = (request[0] & 4) != 0;
  block_size_ = request[4];
  segments_done_ = 0;
  answer_initiate(has_size ? 0xC6 : 0xC4, has_size ? static_cast<std::uint32_t>(data_.size()) : 0);
}

void Server::send_sub_block() {
  const std::size_t all = segments_for(data_.size());
  sent_segments_ = static_cast<std::uint8_t>(std::min<std::size_t>(block_size_, all - segments_done_));
  for (std::uint8_t number = 1; number <= sent_segments_; ++number) {
    const std::size_t segment = segments_done_ + number - 1;
    Data frame{static_cast<std::uint8_t>(number | (segment + 1 == all ? 0x80 : 0))};
    for (std::size_t i = 0; i < kSegment && segment * kSegment + i < data_.size(); ++i)
      frame[1 + i] = data_[segment * kSegment + i];
    answer(frame);
  }
  phase_ = Phase::BlockUploadSent;
}

void Server::confirm_upload(const Data& request) {
  if (request[1] > sent_segments_) return abort(AbortCode::InvalidSequenceNumber);
  const bool is_complete = segments_done_ + request[1] == segments_for(data_.size());
  if (!is_block_size(request[2])) return abort(AbortCode::InvalidBlockSize);
  segments_done_ += request[1];
  block_size_ = request[2];
  if (!is_complete) return send_sub_block();
  const std::size_t unused = segments_done_ * kSegment - data_.size();
  const std::uint16_t crc = crc_ ? crc_of(data_) : std::uint16_t{0};
  answer({static_cast<std::uint8_t>(0xC1 | unused << 2), static_cast<std::uint8_t>(crc),
          static_cast<std::uint8_t>(crc >> 8)});
  phase_ = Phase::BlockUploadEnded;
}

void Server::block_download(const Data& request) {
  if ((request[0] & 1) == 0) return initiate_block_download(request);
  if (phase_ == Phase::BlockDownloadEnding) return end_block_download(request);
  abort(AbortCode::CommandSpecifierInvalid);
}

void Server::initiate_block_download(const Data& request) {
  if (!find(request) || !begin_write(request, (request[0] & 2) != 0)) return;
  open(Phase::BlockDownload, true);
  crc_ = (request[0] & 4) != 0;
  next_segment_ = 1;
  must_restart_ = is_broken_ = false;
  progress_ = last_;
  answer_initiate(0xA4, 0);
  answer_.any_block_size = true;
}

void Server::block_segment(const Data& request, Milliseconds now) {
  const std::uint8_t number = request[0] & 0x7F;
  const bool is_last = (request[0] & 0x80) != 0;
  if (number == 0 && is_last) return end();  // the client's abort
  if (number == 0) return abort(AbortCode::InvalidSequenceNumber);
  bool is_complete = false;
  is_broken_ = is_broken_ || (must_restart_ && number != 1);
  must_restart_ = false;
  if (!confirmed_early_) last_ = now;
  if (number == next_segment_ && number <= block_size_) {
    data_.insert(data_.end(), request.begin() + 1, request.end());
    ++next_segment_;
    last_ = progress_ = now;
    confirmed_early_ = false;
    is_complete = is_last;
  }
  watch_length(is_complete ? data_.size() - kSegment : data_.size());
  if (number == block_size_ || is_last) confirm_download();
  if (is_complete && phase_ != Phase::Idle) phase_ = Phase::BlockDownloadEnding;
}

/// Confirms the segments that have come in order; the client goes on behind them.
void Server::confirm_download() {
  if (is_broken_) {
    abort(AbortCode::InvalidSequenceNumber);
    answer_.or_abort = doom_;
    return;
  }
  answer({0xA2, static_cast<std::uint8_t>(next_segment_ - 1), 0});
  answer_.any_block_size = true;
  answer_.or_abort = doom_;  // not earlier: segments on their way would pass for requests
  next_segment_ = 1;
}

void Server::end_block_download(const Data& request) {
  const std::size_t unused = request[0] >> 2 & 7U;
  data_.resize(data_.size() - std::min(unused, data_.size()));
  if (crc_ && crc_of(data_) != (request[1] | request[2] << 8)) return abort(AbortCode::CrcError);
  if (!commit()) return;
  end();
  answer({0xA1});
}

bool Server::accepts(const std::vector<Data>& sent) {
  const auto equals = [this](const Data& a, const Data& b) {
    Data masked = b;
    if (answer_.any_multiplexer) std::copy_n(a.begin() + 1, 3, masked.begin() + 1);
    const std::size_t size_at = (b[0] & 3) == 2 ? 2 : 4;
    if (answer_.any_block_size) masked[size_at] = a[size_at];
    if (answer_.any_block_size && !is_block_size(a[size_at])) return false;
    return a == masked;
  };
  if (std::equal(sent.begin(), sent.end(), answer_.frames.begin(), answer_.frames.end(), equals)) {
    if (answer_.any_block_size) block_size_ = sent.front()[(sent.front()[0] & 3) == 2 ? 2 : 4];
    return true;
  }
  if (!answer_.or_abort) return false;
  const AbortCode code = *answer_.or_abort;
  answer_ = {};
  abort(code);
  return sent == answer_.frames;
}

}  // namespace model
