#include <algorithm>

#include "tools/canopen-check/core/sdo_client.hpp"

// Uploads that are asked for several at a time: an answer that has to be waited for costs the way there and back.
namespace conformance {
namespace {

constexpr std::uint8_t kInitiateUpload = 0x40;
/// Requests that are under way at a time, at most: as many as the queues of small controllers hold.
constexpr std::size_t kMostTogether = 16;
/// After the first of two answers the second one is waited for that long, and for that many times as long as the
/// first one took, whatever is more.
constexpr canopen::Duration kSoon = std::chrono::milliseconds{50};
constexpr int kTimesAsLong = 10;
/// Frames beside the answers, after which a server is taken for one that never falls silent.
constexpr std::size_t kMostStrays = 16;

}  // namespace

std::optional<SdoAnswer> whole_answer(const canopen::Frame& frame) {
  if (const auto code = abort_code(frame)) return SdoAnswer{.kind = SdoAnswer::Kind::Aborted, .abort_code = *code};
  const bool expedited = frame.length == frame.data.size() && (frame.data[0] & 0xF2U) == 0x42;
  if (!expedited) return std::nullopt;
  const std::ptrdiff_t unused = (frame.data[0] & 0x01U) != 0 ? frame.data[0] >> 2U & 3U : 0;
  return SdoAnswer{.kind = SdoAnswer::Kind::Done,
                   .data = {frame.data.begin() + 4, frame.data.end() - unused},
                   .expedited = true};
}

std::vector<std::optional<canopen::Frame>> SdoClient::burst(std::span<const Multiplexor> entries,
                                                            canopen::Duration patience) {
  std::vector<std::optional<canopen::Frame>> answers(entries.size());
  std::vector<SdoMatch> awaited;
  session_->drain();
  for (const Multiplexor& entry : entries) {
    last_ = request(kInitiateUpload, entry.index, entry.sub_index);
    awaited.emplace_back(last_, std::nullopt);
    if (!session_->send(last_)) return answers;
  }
  forget_transfer();
  std::size_t answered = 0, strays = 0;
  while (answered < entries.size() && strays < kMostStrays) {
    const std::optional<canopen::Frame> frame = listen(answered == 0 ? patience_ : patience);
    if (!frame) break;
    std::size_t at = 0;
    while (at < entries.size() && (answers[at] || !awaited[at].fits(*frame))) ++at;
    if (at == entries.size()) {
      ++strays;
      continue;
    }
    answers[at] = frame;
    ++answered;
  }
  if (answered < entries.size() && !session_->ended()) {
    together_ = 1;
    late_ = true;
  }
  // What disturbs is a matter of each transfer by itself.
  if (strays != 0) std::ranges::fill(answers, std::nullopt);
  return answers;
}

void SdoClient::learn_to_ask_together() {
  // The same entry each time: an answer that comes late does not harm what is asked next.
  constexpr Multiplexor kDeviceType{0x1000, 0};
  const canopen::TimePoint begin = session_->now();
  const bool answers = aborts_are_named_ && exchange(request(kInitiateUpload, kDeviceType.index)).has_value();
  const canopen::Duration patience =
      std::min(patience_, std::max<canopen::Duration>(kSoon, kTimesAsLong * (session_->now() - begin)));
  together_ = 1;
  if (!answers) return;
  for (std::size_t count = 2; count <= kMostTogether; count *= 2) {
    const std::vector<Multiplexor> same(count, kDeviceType);
    const auto found = burst(same, patience);
    if (!std::ranges::all_of(found, [](const auto& answer) { return answer.has_value(); })) return;
    together_ = count;
  }
}

std::vector<std::optional<canopen::Frame>> SdoClient::ask_together(std::span<const Multiplexor> entries) {
  std::vector<std::optional<canopen::Frame>> answers(entries.size());
  if (entries.empty() || silent_ != 0) return answers;
  if (together_ == 0) learn_to_ask_together();
  std::size_t at = 0;
  while (at < entries.size() && together_ > 1) {
    const std::size_t count = std::min(together_, entries.size() - at);
    std::ranges::move(burst(entries.subspan(at, count), patience_),
                      answers.begin() + static_cast<std::ptrdiff_t>(at));
    at += count;
  }
  return answers;
}

}  // namespace conformance
