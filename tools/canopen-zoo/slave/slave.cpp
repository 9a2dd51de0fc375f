#include "tools/canopen-zoo/slave/slave.hpp"

#include "tools/canopen-zoo/drive/drive_objects.hpp"

namespace zoo {
namespace {

constexpr std::size_t kDocumentSize = 100;
constexpr std::uint8_t kDocumentByte = 0xA5;

canopen::Policy policy_of(const Defect& defect) {
  canopen::Policy policy{.extended_identifiers = false};
  defect.policy(policy);
  return policy;
}

void map(std::vector<canopen::EntryDescription>& table, std::uint16_t first, const std::vector<DrivePdo>& pdos) {
  for (const DrivePdo& pdo : pdos) {
    row(table, first, 0).initial = pdo.second != 0 ? 2 : 1;
    row(table, first, 1).initial = pdo.first;
    row(table, first, 2).initial = pdo.second;
    ++first;
  }
}

std::vector<canopen::EntryDescription> table_of(const Defect& defect) {
  std::vector<canopen::EntryDescription> table = objects_of(defect);
  defect.table(table);
  return table;
}

/// True for objects of the communication profile.
bool communication(std::uint16_t index) {
  return index < 0x2000;
}

/// True if group @p sub_index of 1010h or 1011h covers @p index: 1 all, 2 communication, 3 application.
bool covers(std::uint8_t sub_index, std::uint16_t index) {
  return sub_index == 1 || (sub_index == 2) == communication(index);
}

/// True for what a master commands, which is not kept.
bool is_command(std::uint16_t index) {
  return index == 0x1003 || index == 0x1010 || index == 0x1011 || index == 0x6040;
}

}  // namespace

std::vector<canopen::EntryDescription> objects_of(const Defect& defect) {
  std::vector<canopen::EntryDescription> table = right_objects();
  if (!defect.drive) return table;
  row(table, 0x1000).initial = kDriveType;
  map(table, 0x1600, drive_pdos(false));
  map(table, 0x1A00, drive_pdos(true));
  const std::vector<canopen::EntryDescription> more = drive_objects();
  table.insert(table.end(), more.begin(), more.end());
  return table;
}

Slave::Slave(const Defect& defect, std::uint8_t node_id, canopen::TimePoint now)
    : defect_{defect},
      table_{table_of(defect)},
      dictionary_{table_, node_id},
      document_{std::vector<std::uint8_t>(kDocumentSize, kDocumentByte)},
      node_{dictionary_, policy_of(defect), *this, *this},
      now_{now} {
  if (defect.drive) drive_.emplace(dictionary_, *defect.drive, now);
  if (dictionary_.contains(kDocument)) dictionary_.own_domain(kDocument, 0, document_);
  node_.start(now_);
}

void Slave::on_frame(const canopen::Frame& frame, canopen::TimePoint now) {
  now_ = now;
  canopen::Frame seen = frame;
  if (drive_) drive_->advance(now);
  if (!defect_.incoming(*this, seen)) return;
  node_.on_frame(seen, now);
  if (drive_) drive_->act();
  node_.on_values_changed(now);
}

void Slave::on_time(canopen::TimePoint now) {
  now_ = now;
  node_.on_time(now);
}

void Slave::send(const canopen::Frame& frame, canopen::Delivery) {
  canopen::Frame said = frame;
  if (defect_.outgoing(*this, said)) frames_.push_back(said);
}

void Slave::on_rpdo(std::uint16_t) noexcept {
  const auto step = dictionary_.cell<std::uint16_t>(kStep, 0).get();
  auto counter = dictionary_.cell<std::uint32_t>(kCounter, 0);
  counter.set(counter.get() + step);
  dictionary_.cell<std::uint16_t>(kMirror, 0).set(step);
}

void Slave::on_reset(canopen::NmtCommand command) noexcept {
  for (const auto& [entry, value] : stored_)
    if (communication(entry.first) || command == canopen::NmtCommand::ResetNode)
      dictionary_.set(*dictionary_.lookup(entry.first, entry.second), value);
  if (drive_) drive_->boot();
  defect_.after_reset(*this);
}

void Slave::on_nmt_state(canopen::NmtState from, canopen::NmtState) noexcept {
  if (drive_ && from == canopen::NmtState::Operational) drive_->lose_connection();
}

canopen::Result<void> Slave::on_store(std::uint8_t sub_index) noexcept {
  if (defect_.forgets_to_store) return {};
  for (const canopen::Entry& entry : dictionary_.entries()) {
    const bool stores = entry.size != 0 && entry.readable && entry.writable && !is_command(entry.index) &&
                        covers(sub_index, entry.index);
    if (!stores) continue;
    if (const auto value = dictionary_.read(entry)) stored_[{entry.index, entry.sub_index}] = *value;
  }
  return {};
}

canopen::Result<void> Slave::on_restore(std::uint8_t sub_index) noexcept {
  if (defect_.forgets_to_restore) return {};
  std::erase_if(stored_, [&](const auto& each) { return covers(sub_index, each.first.first); });
  return {};
}

}  // namespace zoo
