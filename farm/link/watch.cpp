#include "farm/link/watch.hpp"

#include <charconv>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "can/nats/delivery.hpp"
#include "can/nats/message.hpp"

namespace farm {

namespace {

using nlohmann::json;

constexpr std::int64_t kSecond = 1'000'000'000;  // ns
/// A consumer without messages says so after this time (ns).
constexpr std::int64_t kHeartbeat = kSecond;
/// One that nobody listens to is removed by the server (ns).
constexpr std::int64_t kInactive = 5 * kSecond;
/// Ticks without a message, heartbeats included, after which the consumer counts as gone.
constexpr int kMostSilentTicks = 12;

}  // namespace

Watch::Watch(std::string bucket, std::string pattern, OnEntry on_entry, OnAll on_all)
    : bucket_{std::move(bucket)},
      pattern_{std::move(pattern)},
      on_entry_{std::move(on_entry)},
      on_all_{std::move(on_all)} {}

void Watch::begin() noexcept {
  told_ = 0;
  silent_ticks_ = 0;
  is_complete_ = false;
  is_lost_ = false;
}

std::string Watch::subject() const {
  return fmt::format("$JS.API.CONSUMER.CREATE.KV_{}", bucket_);
}

std::string Watch::body(const std::string& inbox) const {
  return json{{"stream_name", "KV_" + bucket_},
              {"config",
               {{"deliver_subject", inbox},
                {"deliver_policy", "last_per_subject"},
                {"ack_policy", "none"},
                {"replay_policy", "instant"},
                {"filter_subject", fmt::format("$KV.{}.{}", bucket_, pattern_)},
                {"idle_heartbeat", kHeartbeat},
                {"inactive_threshold", kInactive},
                {"mem_storage", true},
                {"num_replicas", 1}}}}
      .dump();
}

/// Entries may have come before the answer: it says what there is to tell only if nothing was told.
void Watch::on_made(std::string_view answer) {
  const json object = json::parse(answer, nullptr, false);
  if (!object.is_object() || object.contains("error")) return lose();
  if (told_ == 0 && object.value("num_pending", json{}) == 0 &&
      object.value("/delivered/consumer_seq"_json_pointer, json{}) == 0)
    tell_all();
}

void Watch::on_message(natsMsg* message) {
  silent_ticks_ = 0;
  const auto status = nats::header_of(message, "Status");
  if (!status) return lose();
  if (nats::data_of(message).empty() && *status != nullptr)
    take_heartbeat(message);
  else
    take_entry(message);
}

void Watch::take_heartbeat(natsMsg* message) {
  const char* const said = nats::header_of(message, "Nats-Last-Consumer").value_or(nullptr);
  const std::string_view last = said != nullptr ? said : "";
  std::uint64_t told = 0;
  std::from_chars(last.data(), last.data() + last.size(), told);
  if (told != told_) lose();
}

void Watch::take_entry(natsMsg* message) {
  const char* const reply = natsMsg_GetReply(message);
  const auto delivery = nats::parse_delivery(reply != nullptr ? reply : "");
  const std::string front = fmt::format("$KV.{}.", bucket_);
  const std::string_view subject = natsMsg_GetSubject(message);
  if (!delivery || !subject.starts_with(front)) return;
  const auto operation = nats::header_of(message, "KV-Operation");
  if (!operation || delivery->consumer_sequence != told_ + 1) return lose();
  ++told_;
  on_entry_({std::string{subject.substr(front.size())}, std::string{nats::data_of(message)}, delivery->sequence,
             *operation != nullptr});
  if (delivery->pending == 0 && !is_complete_) tell_all();
}

void Watch::tell_all() {
  is_complete_ = true;
  on_all_();
}

void Watch::on_tick() noexcept {
  if (++silent_ticks_ > kMostSilentTicks) lose();
}

}  // namespace farm
