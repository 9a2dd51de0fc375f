#include "tools/canopen-check/checks/shared/stored_values.hpp"

#include <algorithm>
#include <array>

#include "tools/canopen-check/core/run/protected_entries.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

/// Communication parameters that no other service needs: heartbeat and inhibit time of EMCY.
constexpr std::array kCommunication{StoredValue{0x1017, 0}, StoredValue{0x1015, 0}, StoredValue{0x100C, 0}};
/// Of CiA 402: following error, position and velocity windows, profile velocity, acceleration.
constexpr std::array kProfile{StoredValue{0x6065, 0}, StoredValue{0x6067, 0}, StoredValue{0x606D, 0},
                              StoredValue{0x606F, 0}, StoredValue{0x6081, 0}, StoredValue{0x6083, 0}};

/// Values beside @p number, the less likely to be the stored or the factory one first.
std::array<std::uint64_t, 2> beside(std::uint64_t number, std::size_t bytes) noexcept {
  constexpr std::uint64_t kStep = 110, kLarge = 0x4000;
  const std::uint64_t far = number < kLarge ? number + kStep : number - kStep;
  return {bytes == 1 ? number ^ 1U : far, number ^ 1U};
}

bool is_writable(Context& context, const StoredValue& value) {
  const eds::EntryFacts* const facts = context.eds().find(value.index, value.sub_index);
  if (facts == nullptr) return context.eds().empty() && context.read(value.index, value.sub_index).done();
  return facts->writable() && facts->readable() && write_refusal(*facts, context.settings()) == nullptr;
}

/// True if @p value takes another value; it has its own again then.
bool takes(Context& context, const StoredValue& value) {
  if (!is_writable(context, value)) return false;
  const SdoAnswer before = context.read(value.index, value.sub_index);
  const SdoAnswer after = alter(context, value);
  if (!before.done() || !after.done() || after.data == before.data) return false;
  return context.write(value.index, value.sub_index, before.data).done();
}

}  // namespace

SdoAnswer order(Context& context, std::uint16_t index, std::uint8_t group, std::uint32_t signature) {
  const canopen::Duration patience =
      std::max<canopen::Duration>(context.settings().patience, std::chrono::seconds{5});
  SdoClient client{context.session(), context.sdo().request_identifier(), context.sdo().response_identifier(),
                   patience};
  return client.download(index, group, eds::little_endian(signature, 4));
}

std::optional<StoredValue> communication_value(Context& context) {
  for (const StoredValue& value : kCommunication)
    if (takes(context, value)) return value;
  return std::nullopt;
}

std::optional<StoredValue> application_value(Context& context) {
  for (const StoredValue& value : kProfile)
    if (takes(context, value)) return value;
  constexpr int kMost = 20;  // tries: most parameters of a manufacturer are none to play with
  int tried = 0;
  for (const eds::EntryFacts& entry : context.eds().entries()) {
    const bool plain = entry.index >= 0x2000 && entry.index < 0x6000 && entry.numeric() && !entry.mappable &&
                       entry.low && entry.high;
    if (!plain || !is_writable(context, {entry.index, entry.sub_index})) continue;
    if (++tried > kMost) break;
    if (const StoredValue value{entry.index, entry.sub_index}; takes(context, value)) return value;
  }
  return std::nullopt;
}

SdoAnswer alter(Context& context, const StoredValue& value) {
  const SdoAnswer before = context.read(value.index, value.sub_index);
  if (!before.done()) return before;
  SdoAnswer written;
  for (const std::uint64_t number : beside(before.number(), before.data.size())) {
    written = context.write(value.index, value.sub_index, eds::little_endian(number, before.data.size()));
    if (written.done()) return context.read(value.index, value.sub_index);
  }
  return written;
}

bool restart(Context& context) {
  return context.restart(canopen::NmtCommand::ResetNode);
}

StorageGuard::StorageGuard(Context& context, std::vector<StoredValue> values) : context_{&context} {
  for (const StoredValue& value : values)
    before_.push_back({value, context.read(value.index, value.sub_index).data});
}

StorageGuard::~StorageGuard() {
  // An interruption must not leave the values of the test in the store.
  context_->session().clean_up(true);
  for (const Before& before : before_)
    (void)context_->sdo().download(before.value.index, before.value.sub_index, before.bytes);
  (void)order(*context_, object::kStoreParameters, 1, kSave);
  context_->session().clean_up(false);
}

}  // namespace conformance
