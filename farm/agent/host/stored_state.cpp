#include "farm/agent/host/stored_state.hpp"

#include <utility>

#include <fmt/format.h>

namespace farm::agent {
namespace {

/// Before what has failed is tried again.
constexpr std::chrono::seconds kPause{1};

}  // namespace

StoredState::StoredState(axisd::ServiceEvents& events, Link& link, const std::string& farm, const Folders& folders,
                         Outcomes& outcomes)
    : events_{events},
      link_{link},
      folders_{folders},
      outcomes_{outcomes},
      transfer_{farm, folders},
      files_{events, folders, [this](const UnitName& unit) { look_at(unit); }} {
  again_ = events_.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        static_cast<StoredState*>(self)->try_again();
        return 0;
      },
      this);
}

/// One that cannot be read now may be there the next time: what lies here may be newer than what lies on the
/// server.
tl::expected<UnitNote*, std::string> StoredState::note_of(const UnitName& unit) {
  if (const auto known = notes_.find(unit); known != notes_.end()) return &known->second;
  auto note = read_note(folders_, unit);
  if (!note) return tl::unexpected{std::move(note.error())};
  return &(notes_[unit] = *std::move(note));
}

void StoredState::keep_note(const UnitName& unit) {
  if (const auto written = replace_file(folders_.note(unit), text_of(notes_[unit])); !written)
    outcomes_.on_warning(written.error());
}

void StoredState::prepare(const UnitStart& start, std::function<void(tl::expected<void, std::string>)> then) {
  const auto known = note_of(start.unit);
  if (!known) return then(tl::unexpected{known.error()});
  if ((*known)->kept.is_newest_for(start)) {
    note(start);
    return then({});
  }
  using Fetched = std::optional<std::uint32_t>;
  link_.run<Fetched>(
      [transfer = transfer_, unit = start.unit](Storage& storage) { return transfer.fetch(storage, unit); },
      [this, start, then = std::move(then)](const tl::expected<Fetched, std::string>& fetched) {
        if (!fetched)
          return then(tl::unexpected{fmt::format("what it has saved cannot be fetched: {}", fetched.error())});
        notes_[start.unit].uploaded = *fetched;
        note(start);
        then({});
      });
}

void StoredState::note(const UnitStart& start) {
  const auto known = note_of(start.unit);
  UnitNote& note = known ? **known : notes_[start.unit];
  note.kept = {start.term, start.generation};
  note.configuration = start.configuration;
  keep_note(start.unit);
}

tl::expected<std::optional<UnitStart>, std::string> StoredState::noted(const UnitName& unit) {
  const auto note = note_of(unit);
  if (!note) return tl::unexpected{note.error()};
  const UnitNote& known = **note;
  if (known.kept.term == 0) return std::nullopt;
  return UnitStart{unit, known.configuration, known.kept.term, known.kept.generation};
}

void StoredState::begin(const UnitName& unit) {
  running_.insert(unit);
  if (const auto watched = files_.watch(unit); !watched) {
    outcomes_.on_warning(watched.error());
    unwatched_.insert(unit);
    axisd::ServiceEvents::start(again_, kPause);
  }
  look_at(unit);
}

void StoredState::end(const UnitName& unit) {
  running_.erase(unit);
  unwatched_.erase(unit);
  files_.leave(unit);
  look_at(unit);
}

void StoredState::look_at(const UnitName& unit) {
  const auto checksum = checksum_of_parameters(folders_, unit);
  const auto note = note_of(unit);
  if (!checksum || !note) {
    outcomes_.on_saved(unit, false);
    return try_later(unit, checksum ? note.error() : checksum.error());
  }
  const bool is_saved = !*checksum || *checksum == (*note)->uploaded;
  outcomes_.on_saved(unit, is_saved && !under_way_.contains(unit));
  if (!is_saved) upload(unit);
}

void StoredState::upload(const UnitName& unit) {
  const auto note = note_of(unit);
  if (!note) return try_later(unit, note.error());
  if (!under_way_.insert(unit).second) return;
  waiting_.erase(unit);
  link_.run<StateTransfer::Upload>([transfer = transfer_, unit, term = (*note)->kept.term](
                                       Storage& storage) { return transfer.upload(storage, unit, term); },
                                   [this, unit](const auto& outcome) { finish(unit, outcome); });
}

void StoredState::try_later(const UnitName& unit, const std::string& why) {
  waiting_.insert(unit);
  outcomes_.on_warning(fmt::format("{}: what it has saved is not on the server yet: {}", unit.text(), why));
  axisd::ServiceEvents::start(again_, kPause);
}

void StoredState::finish(const UnitName& unit, const tl::expected<StateTransfer::Upload, std::string>& outcome) {
  under_way_.erase(unit);
  if (!outcome) {
    if (link_.is_up()) return try_later(unit, outcome.error());
    waiting_.insert(unit);
    return;
  }
  if (outcome->is_others) return outcomes_.on_saved(unit, true);
  notes_[unit].uploaded = outcome->checksum;
  keep_note(unit);
  look_at(unit);
}

void StoredState::upload_again() {
  for (const UnitName& unit : running_) {
    if (const auto note = note_of(unit)) (*note)->uploaded.reset();
    look_at(unit);
  }
}

void StoredState::on_up() {
  for (const UnitName& unit : std::exchange(waiting_, {})) upload(unit);
}

void StoredState::try_again() {
  for (const UnitName& unit : std::exchange(unwatched_, {})) begin(unit);
  on_up();
}

}  // namespace farm::agent
