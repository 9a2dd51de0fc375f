#include "audit/storage/storage_topic.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "audit/base/transfer.hpp"
#include "audit/storage/storage_rules.hpp"
#include "libcanopen/base/object_index.hpp"

namespace audit {

namespace rules = storage_rules;
namespace object = canopen::object;

namespace {

constexpr std::uint64_t kSave = 0x65766173, kLoad = 0x64616F6C;
constexpr canopen::Duration kWhile = std::chrono::minutes{1};

}  // namespace

void StorageTopic::on_transfer(const Transfer& transfer, const Scene& scene) {
  const bool saves = transfer.at.index == object::kStoreParameters;
  const bool loads = transfer.at.index == object::kRestoreParameters;
  if (!transfer.is_write || transfer.at.sub_index == 0 || (!saves && !loads)) return;
  if (transfer.value != (saves ? kSave : kLoad))
    return scene.findings.add(rules::kSignature, transfer.channel.node, {transfer.request, transfer.last},
                              [&] { return fmt::format("{:08X}h", transfer.value); });
  if (saves && transfer.is_done()) take_save(transfer, scene);
}

void StorageTopic::take_save(const Transfer& transfer, const Scene& scene) {
  const Node& node = scene.network.node(transfer.channel.node);
  if (node.state == canopen::NmtState::Operational)
    scene.findings.add(rules::kOperational, node.id, {transfer.request},
                       [&] { return fmt::format("1010h:{:02X}", transfer.at.sub_index); });
  Stores& stores = stores_[{node.id, transfer.at.sub_index}];
  std::rotate(stores.times.begin(), stores.times.begin() + 1, stores.times.end());
  stores.times.back() = transfer.request.at;
  const bool is_often =
      judges_times_ && ++stores.count >= kMostStores && stores.times.back() - stores.times.front() <= kWhile;
  if (is_often)
    scene.findings.add(rules::kOften, node.id, {transfer.request},
                       [&] { return fmt::format("{} times within a minute", kMostStores); });
}

}  // namespace audit
