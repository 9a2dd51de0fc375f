#include "tests/libcanopen/sdo/model/sdo_model.hpp"

#include <algorithm>
#include <limits>

namespace model {

namespace {

constexpr std::size_t kSegment = 7;

std::uint32_t word_in(const Data& frame) {
  return static_cast<std::uint32_t>(frame[4] | frame[5] << 8 | frame[6] << 16) | std::uint32_t{frame[7]} << 24;
}

std::int64_t number_in(const Bytes& bytes, bool is_signed) {
  std::uint64_t bits = is_signed && (bytes.back() & 0x80) != 0 ? ~std::uint64_t{0} : 0;
  for (auto byte = bytes.rbegin(); byte != bytes.rend(); ++byte) bits = bits << 8 | *byte;
  return static_cast<std::int64_t>(bits);
}

}  // namespace

const Answer& Server::on_request(const Data& request, Milliseconds now) {
  answer_ = {};
  if (phase_ == Phase::BlockDownload) {
    block_segment(request, now);
    return answer_;
  }
  last_ = now;
  confirmed_early_ = false;
  switch (request[0] >> 5) {
    case 0:
      download_segment(request);
      break;
    case 1:
      initiate_download(request);
      break;
    case 2:
      initiate_upload(request);
      break;
    case 3:
      upload_segment(request);
      break;
    case 4:
      end();
      break;
    case 5:
      block_upload(request);
      break;
    case 6:
      block_download(request);
      break;
    default:
      abort(AbortCode::CommandSpecifierInvalid);
  }
  return answer_;
}

bool Server::find(const Data& request) {
  end();
  index_ = static_cast<std::uint16_t>(request[1] | request[2] << 8);
  sub_index_ = request[3];
  object_ = nullptr;
  bool index_exists = false;
  for (Object& object : objects_) {
    if (object.index != index_) continue;
    index_exists = true;
    if (object.sub_index == sub_index_) object_ = &object;
  }
  if (object_ != nullptr) return true;
  abort(index_exists ? AbortCode::NoSubIndex : AbortCode::NoObject);
  return false;
}

bool Server::begin_read() {
  if (!object_->readable) {
    abort(AbortCode::WriteOnly);
    return false;
  }
  if (object_->writer != nullptr) {
    abort(AbortCode::DeviceState);
    return false;
  }
  data_ = object_->value;
  done_ = 0;
  return true;
}

void Server::initiate_upload(const Data& request) {
  if (!find(request) || !begin_read()) return;
  const auto size = static_cast<std::uint32_t>(data_.size());
  if (object_->is_number && size <= 4) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < size; ++i) word |= std::uint32_t{data_[i]} << 8 * i;
    answer_initiate(static_cast<std::uint8_t>(0x43 | (4 - size) << 2), word);
    return;
  }
  open(Phase::Upload, false);
  const bool has_size = !object_->streamed || object_->size_is_known;
  answer_initiate(has_size ? 0x41 : 0x40, has_size ? size : 0);
}

void Server::upload_segment(const Data& request) {
  if (phase_ != Phase::Upload) return abort(AbortCode::CommandSpecifierInvalid);
  if ((request[0] & 0x10) != toggle_) return abort(AbortCode::ToggleBitNotAlternated);
  const std::size_t bytes = std::min(kSegment, data_.size() - done_);
  const bool is_last = done_ + bytes == data_.size();
  Data frame{static_cast<std::uint8_t>(toggle_ | (kSegment - bytes) << 1 | (is_last ? 1 : 0))};
  for (std::size_t i = 0; i < bytes; ++i) frame[1 + i] = data_[done_ + i];
  answer(frame);
  done_ += bytes;
  toggle_ ^= 0x10;
  if (is_last) end();
}

/// The checks before a download that is not expedited.
bool Server::begin_write(const Data& request, bool has_size) {
  std::optional<AbortCode> refusal;
  announced_ = has_size ? std::optional{word_in(request)} : std::nullopt;
  const std::size_t size = announced_.value_or(0);
  if (!object_->writable) {
    refusal = AbortCode::ReadOnly;
  } else if (object_->streamed) {
    if (object_->writer != nullptr || object_->readers != 0)
      refusal = AbortCode::DeviceState;
    else if (size > object_->capacity)
      refusal = AbortCode::OutOfMemory;
  } else if (announced_ && (object_->is_number ? size != object_->value.size() : size > object_->capacity)) {
    refusal = AbortCode::LengthMismatch;
  }
  if (refusal) {
    abort(*refusal);
    return false;
  }
  data_.clear();
  return true;
}

void Server::initiate_download(const Data& request) {
  if (!find(request)) return;
  const bool has_size = (request[0] & 1) != 0;
  if ((request[0] & 2) == 0) {
    if (!begin_write(request, has_size)) return;
    open(Phase::Download, true);
    return answer_initiate(0x60, 0);
  }
  if (!object_->writable) return abort(AbortCode::ReadOnly);
  if (object_->streamed && (object_->writer != nullptr || object_->readers != 0))
    return abort(AbortCode::DeviceState);
  const std::size_t assumed = object_->is_number ? std::min<std::size_t>(4, object_->value.size()) : 4;
  const std::size_t size = has_size ? 4U - (request[0] >> 2 & 3U) : assumed;
  announced_ = std::nullopt;
  data_.assign(request.begin() + 4, request.begin() + 4 + static_cast<std::ptrdiff_t>(size));
  if (commit()) answer_initiate(0x60, 0);
}

/// If the @p sure bytes of data are more than will ever be accepted, the refusal may come with the next answer
/// already, or at the end.
void Server::watch_length(std::size_t sure) {
  const std::size_t most = object_->is_number ? object_->value.size() : object_->capacity;
  if (sure <= announced_.value_or(static_cast<std::uint32_t>(most))) return;
  if (announced_)
    doom_ = AbortCode::LengthTooHigh;
  else
    doom_ = object_->streamed ? AbortCode::OutOfMemory : AbortCode::LengthMismatch;
}

void Server::download_segment(const Data& request) {
  if (phase_ != Phase::Download) return abort(AbortCode::CommandSpecifierInvalid);
  if ((request[0] & 0x10) != toggle_) return abort(AbortCode::ToggleBitNotAlternated);
  const std::size_t bytes = kSegment - (request[0] >> 1 & 7U);
  data_.insert(data_.end(), request.begin() + 1, request.begin() + 1 + static_cast<std::ptrdiff_t>(bytes));
  if (announced_ && data_.size() > *announced_) return abort(AbortCode::LengthTooHigh);
  watch_length(data_.size());
  answer_.or_abort = doom_;
  if ((request[0] & 1) != 0) {
    if (!commit()) return;
    end();
  }
  answer({static_cast<std::uint8_t>(0x20 | toggle_)});
  toggle_ ^= 0x10;
}

/// What the dictionary says of @p value.
std::optional<AbortCode> Server::check(const Bytes& value) const {
  if (object_->streamed) {
    if (value.size() > object_->capacity) return AbortCode::OutOfMemory;
    return object_->refuses_to_end;
  }
  if (!object_->is_number) {
    return value.size() > object_->capacity ? std::optional{AbortCode::LengthMismatch} : std::nullopt;
  }
  if (value.size() != object_->value.size()) return AbortCode::LengthMismatch;
  const std::int64_t number = number_in(value, object_->is_signed);
  if (number > object_->high.value_or(std::numeric_limits<std::int64_t>::max())) return AbortCode::ValueTooHigh;
  if (number < object_->low.value_or(std::numeric_limits<std::int64_t>::min())) return AbortCode::ValueTooLow;
  return std::nullopt;
}

/// All of a download is there: it counts, or the transfer is aborted.
bool Server::commit() {
  std::optional<AbortCode> refusal;
  if (announced_ && data_.size() < *announced_) refusal = AbortCode::LengthTooLow;
  if (announced_ && data_.size() > *announced_) refusal = AbortCode::LengthTooHigh;
  if (!refusal) refusal = check(data_);
  if (refusal) {
    answer_ = {};
    abort(*refusal);
    return false;
  }
  object_->value = data_;
  return true;
}

void Server::open(Phase phase, bool writes) {
  phase_ = phase;
  toggle_ = 0;
  doom_ = std::nullopt;
  if (!object_->streamed) return;
  if (writes)
    object_->writer = this;
  else
    ++object_->readers;
}

void Server::end() {
  if (phase_ != Phase::Idle && object_->streamed) {
    if (object_->writer == this)
      object_->writer = nullptr;
    else
      --object_->readers;
  }
  phase_ = Phase::Idle;
}

void Server::answer_initiate(std::uint8_t command, std::uint32_t word) {
  Data frame{command, static_cast<std::uint8_t>(index_), static_cast<std::uint8_t>(index_ >> 8), sub_index_};
  for (std::size_t i = 0; i < 4; ++i) frame[4 + i] = static_cast<std::uint8_t>(word >> 8 * i);
  answer(frame);
}

void Server::abort(AbortCode code) {
  if (phase_ == Phase::Idle && code == AbortCode::CommandSpecifierInvalid) answer_.any_multiplexer = true;
  end();
  answer_initiate(0x80, static_cast<std::uint32_t>(code));
}

std::optional<Milliseconds> Server::deadline() const {
  if (phase_ == Phase::Idle) return std::nullopt;
  if (phase_ != Phase::BlockDownload) return last_ + timeout_;
  if (confirmed_early_) return last_ + timeout_ / 2;
  return std::min(last_ + timeout_ / 2, progress_ + timeout_);
}

const Answer& Server::on_time(Milliseconds now) {
  answer_ = {};
  const auto due = deadline();
  if (!due || now < *due) return answer_;
  if (phase_ == Phase::BlockDownload && !confirmed_early_ && now < progress_ + timeout_) {
    confirmed_early_ = true;
    must_restart_ = next_segment_ != 1;
    last_ = now;
    watch_length(data_.size());
    confirm_download();
  } else {
    abort(AbortCode::ProtocolTimedOut);
  }
  return answer_;
}

}  // namespace model
