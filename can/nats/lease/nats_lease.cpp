#include "can/nats/lease/nats_lease.hpp"

#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <pthread.h>

#include "can/nats/session.hpp"
#include "os/no_signals.hpp"
namespace nats {

namespace {

using std::chrono::milliseconds;
using Json = nlohmann::json;
using KeyValues = std::unique_ptr<kvStore, Destroyer<kvStore_Destroy>>;
using KeyValue = std::unique_ptr<kvEntry, Destroyer<kvEntry_Destroy>>;

constexpr const char* kClient = "canhub lease";
constexpr const char* kKey = "arbiter";
/// For each answer of the server.
constexpr milliseconds kPatience{1000};
/// Between two attempts.
constexpr milliseconds kPause{100};
/// Without a question the connection is given up.
constexpr milliseconds kIdle{5000};

/// The bucket, made if there is none. Two hubs that make it at the same moment collide in the server: the second
/// attempt finds it.
tl::expected<KeyValues, std::string> open_bucket(jsCtx* js, const std::string& name) {
  kvConfig config;
  kvConfig_Init(&config);
  config.Bucket = name.c_str();
  config.History = 1;
  config.StorageType = js_MemoryStorage;
  natsStatus status = NATS_OK;
  for (int attempt = 0; attempt < 2; ++attempt) {
    kvStore* store = nullptr;
    status = js_KeyValue(&store, js, name.c_str());
    if (status == NATS_NOT_FOUND) status = js_CreateKeyValue(&store, js, &config);
    if (status == NATS_OK) return KeyValues{store};
  }
  return tl::unexpected{fmt::format("bucket {}: {}", name, text_of(status))};
}

std::string text_of_entry(const NatsLease::Holder& holder, std::uint32_t term) {
  const Json entry{{"hub", holder.hub}, {"name", holder.name}, {"bit_rate", holder.bit_rate}, {"term", term}};
  return entry.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// More terms than a bus comes to.
constexpr std::uint32_t kHighestTerm = 1'000'000'000;

/// What is no entry of a hub is nobody's.
hub::trunk::Lease::Entry read_entry(kvEntry* entry) {
  hub::trunk::Lease::Entry read{.revision = kvEntry_Revision(entry)};
  const std::string_view text{static_cast<const char*>(kvEntry_Value(entry)),
                              static_cast<std::size_t>(kvEntry_ValueLen(entry))};
  const Json value = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  const auto number = [&](const char* name) {
    const auto found = value.is_object() ? value.find(name) : value.end();
    return found != value.end() && found->is_number_unsigned() ? found->get<std::uint32_t>() : 0U;
  };
  const std::uint32_t term = number("term");
  read.term = term <= kHighestTerm ? term : 0;
  read.hub = number("hub");
  return read;
}

}  // namespace

/// The bucket, and the connection to it.
struct NatsLease::Store {
  Session session;
  KeyValues values;  ///< ends before the connection

  static tl::expected<std::unique_ptr<Store>, std::string> open(const Bus& bus) {
    auto session = open_session(bus.server, kClient, kPatience);
    if (!session) return tl::unexpected{session.error()};
    auto values = open_bucket(session->js.get(), bus.bucket());
    if (!values) return tl::unexpected{values.error()};
    return std::make_unique<Store>(Store{*std::move(session), *std::move(values)});
  }
};

NatsLease::NatsLease(Bus bus, Holder holder) : bus_{std::move(bus)}, holder_{std::move(holder)} {
  const os::NoSignals none;
  thread_ = std::jthread{[this](const std::stop_token& stop) { work(stop); }};
}

NatsLease::~NatsLease() {
  thread_.request_stop();
  asked_.notify_all();
  thread_.join();
}

/// The last question counts.
void NatsLease::ask(std::optional<Take> take) noexcept {
  const std::scoped_lock lock{mutex_};
  question_ = {take, ++questions_};
  answer_.reset();
  asked_.notify_all();
}

std::optional<NatsLease::Entry> NatsLease::take_answer() noexcept {
  const std::scoped_lock lock{mutex_};
  return std::exchange(answer_, std::nullopt);
}

std::string NatsLease::take_problem() {
  const std::scoped_lock lock{mutex_};
  return std::exchange(problem_, {});
}

void NatsLease::work(const std::stop_token& stop) {
  pthread_setname_np(pthread_self(), "nats-lease");
  while (const auto question = next(stop)) {
    const Result result = answer(*question);
    if (!result) store_.reset();
    post(*question, result);
    if (!result) wait(stop, kPause);
  }
  store_.reset();
  nats_ReleaseThreadMemory();
}

/// Waits for a question; nothing at the end.
std::optional<NatsLease::Question> NatsLease::next(const std::stop_token& stop) {
  const auto is_asked = [this] { return question_.has_value(); };
  std::unique_lock lock{mutex_};
  if (store_ && !asked_.wait_for(lock, stop, kIdle, is_asked)) {
    lock.unlock();
    store_.reset();
    lock.lock();
  }
  asked_.wait(lock, stop, is_asked);
  return stop.stop_requested() ? std::nullopt : question_;
}

NatsLease::Result NatsLease::answer(const Question& question) {
  if (!store_) {
    auto store = Store::open(bus_);
    if (!store) return tl::unexpected{"lease: " + store.error()};
    store_ = *std::move(store);
  }
  if (question.take) return change(*question.take);
  kvEntry* entry = nullptr;
  const natsStatus status = kvStore_Get(&entry, store_->values.get(), kKey);
  const KeyValue owner{entry};
  if (status == NATS_NOT_FOUND) return Entry{};
  if (status != NATS_OK) return tl::unexpected{fmt::format("lease: {}", text_of(status))};
  return read_entry(entry);
}

/// Whoever was faster has changed the entry; an answer that was lost has changed it too.
NatsLease::Result NatsLease::change(const Take& take) {
  const std::string text = text_of_entry(holder_, take.term);
  const int size = static_cast<int>(text.size());
  kvStore* const values = store_->values.get();
  const natsStatus status = take.revision == 0
                                ? kvStore_Create(nullptr, values, kKey, text.data(), size)
                                : kvStore_Update(nullptr, values, kKey, text.data(), size, take.revision);
  const std::string problem = status == NATS_OK ? std::string{} : text_of(status);
  auto entry = answer({});
  if (entry && entry->revision == take.revision)
    return tl::unexpected{fmt::format("lease: cannot be taken: {}", problem)};
  return entry;
}

void NatsLease::post(const Question& question, const Result& result) {
  const std::scoped_lock lock{mutex_};
  if (result) told_.clear();
  if (result && question_ && question_->number == question.number) {
    answer_ = *result;
    question_.reset();
  } else if (!result && result.error() != told_) {
    problem_ = result.error();
    told_ = problem_;
  }
}

void NatsLease::wait(const std::stop_token& stop, milliseconds time) {
  std::unique_lock lock{mutex_};
  asked_.wait_for(lock, stop, time, [] { return false; });
}

}  // namespace nats
