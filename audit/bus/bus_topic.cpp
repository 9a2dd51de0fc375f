#include "audit/bus/bus_topic.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "audit/bus/bus_rules.hpp"
#include "audit/network/pdo_record.hpp"

namespace audit {

namespace rules = bus_rules;
namespace object = canopen::object;

using meaning::Role;

namespace {

constexpr std::uint8_t kTimeBytes = 6;
constexpr double kMostLoad = 0.8;
constexpr canopen::Duration kSecond = std::chrono::seconds{1};
/// A burst that holds up what comes behind it for so long is too long.
constexpr canopen::Duration kLongestBurst = std::chrono::milliseconds{50};
/// Time without a frame that ends a burst.
constexpr canopen::Duration kGap = std::chrono::milliseconds{1};
constexpr std::size_t kMostGiven = 1000;
constexpr std::uint16_t kLastRecord = 0x1FF;
constexpr std::uint16_t kServers = 0x1200, kLastServer = 0x127F;
constexpr std::uint8_t kToClientSub = 2;

/// Identifiers of services beside CiA 301: GFC and SRDO (CiA 304), flying master (CiA 302-2).
struct Identifiers {
  canopen::Identifier first, last;
};
constexpr std::array kOfOtherServices{Identifiers{0x001, 0x001}, Identifiers{0x071, 0x076},
                                      Identifiers{0x101, 0x180}};
bool is_of_other_service(canopen::Identifier identifier) noexcept {
  return std::ranges::any_of(kOfOtherServices, [identifier](const Identifiers& row) {
    return identifier >= row.first && identifier <= row.last;
  });
}

/// Bits of @p frame on the line with stuff bits in the middle of what is possible (ISO 11898-1).
std::uint64_t bits_of(const canopen::Frame& frame) noexcept {
  const std::uint64_t data = frame.remote ? 0 : std::uint64_t{8} * frame.length;
  const std::uint64_t head = frame.extended ? 67 : 47;
  return head + data + (head - 13 + data) / 10;
}

/// An entry by which nodes get identifiers to send with.
bool is_sending_entry(const canopen::sdo::Address& at) noexcept {
  if (at.index == object::kCobIdEmcy) return at.sub_index == 0;
  if (at.index >= kServers && at.index <= kLastServer) return at.sub_index == kToClientSub;
  return at.index >= object::kTpdoParameter && at.index <= object::kTpdoParameter + kLastRecord &&
         at.sub_index == kCobIdSub;
}

/// The identifier that @p transfer gives a service; 0: none.
canopen::Identifier identifier_in(const Transfer& transfer) noexcept {
  return canopen::valid_identifier(static_cast<std::uint32_t>(transfer.value));
}

/// Calls @p take(identifier, entry) with each identifier that @p node sends with, and the entry that has it.
template <class Take>
void for_each_sender(const Node& node, Take take) {
  const auto take_known = [&](const canopen::sdo::Address& at) {
    const auto cob_id = node.value(at.index, at.sub_index);
    if (cob_id) take(canopen::valid_identifier(static_cast<std::uint32_t>(*cob_id)), at);
    return cob_id.has_value();
  };
  for (std::uint16_t number = 1; number <= kLastRecord + 1; ++number) {
    const PdoRecord record{.is_receive = false, .number = number};
    const canopen::sdo::Address at{.index = record.communication(), .sub_index = kCobIdSub};
    const auto by_default = meaning::predefined_tpdo(node.id, number);
    if (!take_known(at) && by_default != 0 && node.has_sent_tpdo(number)) take(by_default, at);
  }
  for (std::uint16_t server = kServers + 1; server <= kLastServer; ++server)
    (void)take_known({.index = server, .sub_index = kToClientSub});
  const canopen::sdo::Address emcy{.index = object::kCobIdEmcy, .sub_index = 0};
  if (!take_known(emcy) && node.has_sent_emcy) take(canopen::function_code::kEmcy + node.id, emcy);
}

}  // namespace

void BusTopic::on_frame(const Passage& passage, const Scene& scene) {
  const canopen::Frame& frame = passage.frame();
  Findings& findings = scene.findings;
  if (passage.heard.is_error)
    return findings.add(rules::kErrors, 0, {passage.heard},
                        [&] { return fmt::format("class {:08X}h", frame.id); });
  if (bit_rate_ != 0) take_bits(passage, scene);
  if (passage.is_start()) judge_given(scene);
  if (passage.meaning.role == Role::Time && frame.length != kTimeBytes)
    return findings.add(rules::kTimeLength, 0, {passage.heard},
                        [&] { return fmt::format("{} bytes", frame.length); });
  if (passage.meaning.role != Role::Unknown) return;
  if (frame.extended)
    return findings.add(rules::kExtended, 0, {passage.heard}, [&] { return fmt::format("{:08X}h", frame.id); });
  const bool may_be_of_pdo = canopen::is_assignable(frame.id, false);  // that has got it before the log begins
  if (may_be_of_pdo || is_of_other_service(frame.id)) return;
  findings.add(rules::kUnknown, 0, {passage.heard}, [&] { return fmt::format("{:03X}h", frame.id); });
}

void BusTopic::take_bits(const Passage& passage, const Scene& scene) {
  const std::uint64_t bits = bits_of(passage.frame());
  take_load(passage.heard, bits, scene);
  const bool gives_way = passage.meaning.role == Role::SdoRequest || passage.meaning.role == Role::SdoResponse;
  if (!gives_way) take_burst(passage.heard, bits, scene);
}

/// Frames that follow each other without a gap; those of SDO let others through.
void BusTopic::take_burst(const Heard& heard, std::uint64_t bits, const Scene& scene) {
  const auto time = [this](std::uint64_t of) {
    return canopen::Duration{static_cast<std::int64_t>(of * 1'000'000'000 / bit_rate_)};
  };
  const bool is_behind_gap = !burst_ || heard.at - burst_->at > time(burst_bits_ + bits) + kGap;
  if (is_behind_gap) {
    burst_ = heard;
    burst_bits_ = 0;
    is_burst_said_ = false;
  }
  burst_bits_ += bits;
  if (is_burst_said_ || time(burst_bits_) < kLongestBurst) return;
  is_burst_said_ = true;
  scene.findings.add(rules::kBurst, 0, {*burst_, heard}, [&] {
    return fmt::format("no gap for {} ms",
                       std::chrono::duration_cast<std::chrono::milliseconds>(time(burst_bits_)).count());
  });
}

void BusTopic::take_load(const Heard& heard, std::uint64_t bits, const Scene& scene) {
  bits_ += bits;
  if (!begin_) begin_ = heard;
  const canopen::Duration passed = heard.at - begin_->at;
  if (passed < kSecond) return;
  const double load = static_cast<double>(bits_) / bit_rate_ / std::chrono::duration<double>{passed}.count();
  if (load > kMostLoad)
    scene.findings.add(rules::kLoad, 0, {*begin_, heard}, [&] { return fmt::format("{:.0f} %", load * 100); });
  begin_ = heard;
  bits_ = 0;
}

void BusTopic::on_transfer(const Transfer& transfer, const Scene& scene) {
  if (!transfer.is_write || !is_sending_entry(transfer.at)) return;
  const auto cob_id = static_cast<std::uint32_t>(transfer.value);
  const canopen::Identifier identifier = canopen::valid_identifier(cob_id);
  const bool is_of_pdo = transfer.at.index >= object::kTpdoParameter;
  if (identifier == 0) return;
  if (!is_of_pdo && !canopen::is_assignable(cob_id, true))  // of PDOs: pdo.restricted
    return scene.findings.add(rules::kRestricted, transfer.channel.node, {transfer.request, transfer.last},
                              [&] { return fmt::format("{:04X}h = {:03X}h", transfer.at.index, identifier); });
  if (transfer.is_done()) given_.push_back(transfer);
  if (given_.size() > kMostGiven) given_.erase(given_.begin());
}

/// Identifiers are given and taken in any order: they are judged when nodes are started, and at the end.
void BusTopic::judge_given(const Scene& scene) {
  std::erase_if(given_, [&scene](const Transfer& transfer) {
    const Node& node = scene.network.node(transfer.channel.node);
    return node.values.find(transfer.at.index, transfer.at.sub_index) != transfer.value;
  });
  if (given_.empty()) return;
  for (const Node& node : scene.network.nodes())
    if (node.is_there) judge_given(node, scene);
  given_.clear();
}

/// Identifiers that others were given, and @p other sends with, too.
void BusTopic::judge_given(const Node& other, const Scene& scene) const {
  for_each_sender(other, [&](canopen::Identifier identifier, const canopen::sdo::Address& at) {
    for (const Transfer& transfer : given_)
      if (transfer.channel.node != other.id && identifier_in(transfer) == identifier)
        report_twice(transfer, other, at, scene);
  });
}

/// @p at of @p other has the identifier that @p transfer has given.
void BusTopic::report_twice(const Transfer& transfer, const Node& other, const canopen::sdo::Address& at,
                            const Scene& scene) {
  scene.findings.add(rules::kIdentifierTwice, transfer.channel.node, {transfer.request, transfer.last}, [&] {
    return fmt::format("{:03X}h is that of {:04X}h of node {}, too", identifier_in(transfer), at.index, other.id);
  });
}

void BusTopic::on_end(canopen::Duration, const Scene& scene) {
  judge_given(scene);
}

}  // namespace audit
