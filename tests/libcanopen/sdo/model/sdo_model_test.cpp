#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>

#include "tests/libcanopen/fixture/node_fixture.hpp"
#include "tests/libcanopen/sdo/model/sdo_random_client.hpp"

namespace {

using canopen::Access;
using canopen::EntryDescription;
using canopen::Frame;
using enum canopen::DataType;

constexpr std::size_t kServers = 3;
constexpr std::array<std::uint32_t, kServers> kRequests{0x605, 0x6A5, 0x6B5};
constexpr std::array<std::uint32_t, kServers> kResponses{0x585, 0x6C5, 0x6D5};
constexpr auto kRw = Access::ReadWrite;
constexpr std::uint8_t kAbort = 0x80;
/// Answers that show that the clients get everywhere: ends of transfers of each kind, and abort codes.
constexpr std::array<std::uint32_t, 22> kSeldom{
    0x4F,       0x41,       0x60,       0x20,       0x30,       0x1D,       0xA1,       0xC1,
    0xC4,       0xDD,       0x7F,       0x05030000, 0x05040000, 0x05040001, 0x05040002, 0x05040003,
    0x05040004, 0x06010001, 0x06070012, 0x06070013, 0x06090031, 0x08000022};

/// Numbers of every size, texts, DOMAINs with and without an owner, what must not be read or written.
constexpr std::array kTable{
    EntryDescription{.index = 0x1201, .sub_index = 0, .access = Access::Constant, .initial = 2},
    EntryDescription{.index = 0x1201, .sub_index = 1, .type = Unsigned32, .initial = kRequests[1]},
    EntryDescription{.index = 0x1201, .sub_index = 2, .type = Unsigned32, .initial = kResponses[1]},
    EntryDescription{.index = 0x1202, .sub_index = 0, .access = Access::Constant, .initial = 2},
    EntryDescription{.index = 0x1202, .sub_index = 1, .type = Unsigned32, .initial = kRequests[2]},
    EntryDescription{.index = 0x1202, .sub_index = 2, .type = Unsigned32, .initial = kResponses[2]},
    EntryDescription{.index = 0x2000, .type = Boolean, .access = kRw},
    EntryDescription{.index = 0x2001, .type = Integer8, .access = kRw, .initial = -9, .low = -10, .high = 10},
    EntryDescription{.index = 0x2002, .type = Unsigned16, .access = kRw, .initial = 2, .low = 1, .high = 0xFFF0},
    EntryDescription{.index = 0x2003, .type = Integer24, .access = kRw, .low = -70000, .high = 70000},
    EntryDescription{.index = 0x2004, .type = Unsigned32, .access = kRw},
    EntryDescription{.index = 0x2005, .type = Integer40, .access = kRw},
    EntryDescription{.index = 0x2006, .type = Unsigned48, .access = kRw},
    EntryDescription{.index = 0x2007, .type = Unsigned56, .access = kRw},
    EntryDescription{.index = 0x2008, .type = Integer64, .access = kRw, .low = -(1LL << 40), .high = 1LL << 40},
    EntryDescription{.index = 0x2009, .type = Integer16, .access = Access::WriteOnly},
    EntryDescription{
        .index = 0x200A, .type = Unsigned64, .access = Access::ReadOnly, .initial = 0x0123456789ABCDEF},
    EntryDescription{.index = 0x2010, .type = VisibleString, .access = kRw, .text = "abc", .capacity = 20},
    EntryDescription{.index = 0x2011, .type = OctetString, .access = kRw, .capacity = 3000},
    EntryDescription{.index = 0x2012, .type = Domain, .access = kRw, .capacity = 64},
    EntryDescription{.index = 0x2013, .type = VisibleString, .access = Access::Constant, .text = "as it was made"},
    EntryDescription{.index = 0x2020, .sub_index = 1, .type = Domain, .access = kRw},
    EntryDescription{.index = 0x2020, .sub_index = 2, .type = Domain, .access = kRw},
    EntryDescription{.index = 0x2020, .sub_index = 3, .type = Domain, .access = Access::WriteOnly},
    EntryDescription{.index = 0x2020, .sub_index = 4, .type = Domain, .access = Access::ReadOnly},
};
constexpr std::size_t kStreamCapacity = 5000;

/// Data behind a DOMAIN: they count when their end has come.
class Storage final : public canopen::DomainOwner {
 public:
  Storage(model::Bytes value, bool tells_size, std::optional<canopen::AbortCode> refusal)
      : value_{std::move(value)}, tells_size_{tells_size}, refusal_{refusal} {}
  const model::Bytes& value() const { return value_; }
  bool tells_size() const { return tells_size_; }
  std::optional<canopen::AbortCode> refusal() const { return refusal_; }

  canopen::Result<std::optional<std::uint32_t>> begin_read(const canopen::Entry&) noexcept override {
    if (!tells_size_) return std::nullopt;
    return static_cast<std::uint32_t>(value_.size());
  }
  canopen::Result<std::size_t> read(const canopen::Entry&, std::uint64_t offset,
                                    std::span<std::uint8_t> into) noexcept override {
    const std::size_t count = std::min<std::size_t>(into.size(), value_.size() - offset);
    std::copy_n(value_.begin() + static_cast<std::ptrdiff_t>(offset), count, into.begin());
    return count;
  }
  canopen::Result<void> begin_write(const canopen::Entry&, std::optional<std::uint32_t> size) noexcept override {
    staged_.clear();
    return size.value_or(0) > kStreamCapacity ? canopen::refuse(canopen::AbortCode::OutOfMemory)
                                              : canopen::Result<void>{};
  }
  canopen::Result<void> write(const canopen::Entry&, std::uint64_t offset,
                              std::span<const std::uint8_t> bytes) noexcept override {
    EXPECT_EQ(offset, staged_.size());
    staged_.insert(staged_.end(), bytes.begin(), bytes.end());
    return staged_.size() > kStreamCapacity ? canopen::refuse(canopen::AbortCode::OutOfMemory)
                                            : canopen::Result<void>{};
  }
  canopen::Result<void> end_write(const canopen::Entry&, std::uint64_t size) noexcept override {
    EXPECT_EQ(size, staged_.size());
    if (refusal_) return canopen::refuse(*refusal_);
    value_ = staged_;
    return {};
  }

 private:
  model::Bytes value_, staged_;
  bool tells_size_;
  std::optional<canopen::AbortCode> refusal_;
};

/// A node and the model of its servers side by side, over the same objects.
class SdoModel : public testing::Test {
 protected:
  SdoModel() {
    for (unsigned sub = 1; sub <= 4; ++sub) {
      const auto refusal = sub == 3 ? std::optional{canopen::AbortCode::GeneralError} : std::nullopt;
      storage_.push_back(std::make_unique<Storage>(model::Bytes(sub * 500U, 0x5A), sub % 2 == 1, refusal));
      dictionary_.own_domain(0x2020, static_cast<std::uint8_t>(sub), *storage_.back());
    }
    for (const canopen::Entry& entry : dictionary_.entries()) objects_.push_back(object_of(entry));
    for (std::size_t i = 0; i < kServers; ++i) {
      servers_.emplace_back(objects_, policy_.sdo_timeout / std::chrono::milliseconds{1});
      clients_.emplace_back(random_, objects_);
    }
    node_.start(at());
    bus_.take();
  }

  model::Object object_of(const canopen::Entry& entry) const {
    model::Object object{.index = entry.index, .sub_index = entry.sub_index};
    object.readable = entry.readable;
    object.writable = entry.writable;
    object.is_number = entry.size != 0;
    object.is_signed = entry.is_signed;
    object.low = entry.description->low;
    object.high = entry.description->high;
    if (entry.description->type == Boolean) object.high = 1;
    object.capacity = entry.domain != nullptr ? kStreamCapacity : entry.description->capacity;
    object.streamed = entry.domain != nullptr;
    if (object.streamed) {
      object.size_is_known = storage_[entry.sub_index - 1U]->tells_size();
      object.refuses_to_end = storage_[entry.sub_index - 1U]->refusal();
    }
    object.value = value_in_node(entry);
    return object;
  }
  model::Bytes value_in_node(const canopen::Entry& entry) const {
    if (entry.domain != nullptr) return storage_[entry.sub_index - 1U]->value();
    const auto text = dictionary_.text(entry);
    if (entry.size == 0) return {text.begin(), text.end()};
    std::array<std::uint8_t, 8> bytes{};
    canopen::store(bytes.data(), dictionary_.stored(entry));
    return {bytes.begin(), bytes.begin() + entry.size};
  }

  canopen::TimePoint at() const { return canopen::TimePoint{std::chrono::milliseconds{now_}}; }

  /// What the node has sent under each response identifier.
  std::array<std::vector<model::Data>, kServers> sent() {
    std::array<std::vector<model::Data>, kServers> sorted;
    for (const Frame& frame : bus_.take())
      for (std::size_t i = 0; i < kServers; ++i)
        if (frame.id == kResponses[i]) sorted[i].push_back(frame.data);
    return sorted;
  }
  /// The node has been told what the models have been told: all of them say the same.
  void compare(const std::string& event) {
    const auto answers = sent();
    for (std::size_t i = 0; i < kServers; ++i) {
      ASSERT_TRUE(servers_[i].accepts(answers[i])) << event << ": " << differences(i, answers[i]);
      for (const model::Data& answer : answers[i]) {
        clients_[i].on_answer(answer);
        ++tally_[answer[0] == kAbort ? canopen::load<std::uint32_t>(&answer[4]) : answer[0]];
      }
    }
  }
  std::string differences(std::size_t server, const std::vector<model::Data>& answers) const {
    std::string text = "server " + std::to_string(server) + " sent";
    const auto add = [&](const model::Data& data) {
      text += ' ' + fakes::candump(Frame{.id = kResponses[server], .length = 8, .data = data});
    };
    std::ranges::for_each(answers, add);
    text += "; expected";
    std::ranges::for_each(servers_[server].expected(), add);
    return text;
  }

  void ask(std::size_t server) {
    Frame frame{.id = kRequests[server], .length = 8, .data = clients_[server].next(servers_[server])};
    if (clients_[server].below(100) == 0) frame.length = static_cast<std::uint8_t>(clients_[server].below(8));
    node_.on_frame(frame, at());
    for (std::size_t i = 0; i < kServers; ++i) servers_[i].on_silence();
    if (frame.length == 8) servers_[server].on_request(frame.data, now_);
    compare(fakes::candump(frame));
  }
  /// Time passes, deadline by deadline.
  void pass(model::Milliseconds time) {
    const model::Milliseconds end = now_ + time;
    while (now_ < end) {
      now_ = end;
      for (const model::Server& server : servers_) now_ = std::min(now_, server.deadline().value_or(end));
      node_.on_time(at());
      for (model::Server& server : servers_) server.on_time(now_);
      ASSERT_NO_FATAL_FAILURE(compare("at " + std::to_string(now_) + " ms"));
    }
  }
  void compare_values() const {
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      const canopen::Entry& entry = dictionary_.entries()[i];
      ASSERT_EQ(value_in_node(entry), objects_[i].value) << std::hex << entry.index << ':' << +entry.sub_index;
    }
  }
  /// Stopped and back: no transfer outlives it.
  void interrupt() {
    for (const std::uint8_t command : {std::uint8_t{2}, std::uint8_t{128}})
      node_.on_frame({.length = 2, .data = {command, 0}}, at());
    for (model::Server& server : servers_) server.forget();
  }

  /// A request to one server, and now and then some time, a stop, a look at all values.
  void step() {
    ASSERT_NO_FATAL_FAILURE(ask(random_() % kServers));
    ASSERT_NO_FATAL_FAILURE(pass(one_in(500) ? below(12'000) : one_in(8) ? below(4) : 0));
    if (one_in(2000)) interrupt();
    if (one_in(64)) compare_values();
  }
  model::Milliseconds below(std::uint64_t limit) { return static_cast<model::Milliseconds>(random_() % limit); }
  bool one_in(std::uint64_t chances) { return random_() % chances == 0; }

  std::map<std::uint32_t, int> tally_;  ///< of answers, by abort code or command byte
  canopen::Policy policy_{};
  fakes::VectorBus bus_;
  canopen::Application application_;
  canopen::Dictionary dictionary_{kTable, 5};
  std::vector<std::unique_ptr<Storage>> storage_;
  canopen::Node node_{dictionary_, policy_, bus_, application_};
  std::mt19937_64 random_;
  model::Objects objects_;
  std::vector<model::Server> servers_;
  std::vector<SdoRandomClient> clients_;
  model::Milliseconds now_ = 1000;
};

std::uint64_t seed() {
  const char* const given = std::getenv("AXISD_TEST_SEED");
  return given != nullptr ? std::strtoull(given, nullptr, 0) : std::random_device{}();
}

TEST_F(SdoModel, AnswersAsTheNodeDoesWhateverTheClientsSend) {
  const std::uint64_t seed_used = seed();
  SCOPED_TRACE("AXISD_TEST_SEED=" + std::to_string(seed_used));
  std::cout << "AXISD_TEST_SEED=" << seed_used << '\n';
  random_.seed(seed_used);

  for (int i = 0; i < 300'000; ++i) ASSERT_NO_FATAL_FAILURE(step()) << "frame " << i;

  for (const std::uint32_t answer : kSeldom) EXPECT_GT(tally_[answer], 0) << std::hex << answer << " never came";
}

}  // namespace
