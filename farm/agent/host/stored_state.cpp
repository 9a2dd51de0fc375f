#include "farm/agent/host/stored_state.hpp"

#include <utility>

#include <fmt/format.h>

#include "os/regular_file.hpp"

namespace farm::agent {
namespace {

/// Of a note (bytes): a configuration and little more.
constexpr std::size_t kLongestNote = std::size_t{1} << 20;
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
        static_cast<StoredState*>(self)->on_up();
        return 0;
      },
      this);
}

UnitNote& StoredState::note_of(const UnitName& unit) {
  if (const auto known = notes_.find(unit); known != notes_.end()) return known->second;
  const auto text = os::read_regular_file(folders_.note(unit), kLongestNote);
  return notes_[unit] = text ? parse_unit_note(*text).value_or(UnitNote{}) : UnitNote{};
}

void StoredState::keep_note(const UnitName& unit) {
  if (const auto written = replace_file(folders_.note(unit), text_of(note_of(unit))); !written)
    outcomes_.on_warning(written.error());
}

void StoredState::prepare(const UnitStart& start, std::function<void(tl::expected<void, std::string>)> then) {
  if (note_of(start.unit).kept.is_newest_for(start)) {
    note(start);
    return then({});
  }
  using Fetched = std::optional<std::uint32_t>;
  link_.run<Fetched>(
      [transfer = transfer_, unit = start.unit](Storage& storage) { return transfer.fetch(storage, unit); },
      [this, start, then = std::move(then)](const tl::expected<Fetched, std::string>& fetched) {
        if (!fetched)
          return then(tl::unexpected{fmt::format("what it has saved cannot be fetched: {}", fetched.error())});
        note_of(start.unit).uploaded = *fetched;
        note(start);
        then({});
      });
}

void StoredState::note(const UnitStart& start) {
  UnitNote& note = note_of(start.unit);
  note.kept = {start.term, start.generation};
  note.configuration = start.configuration;
  keep_note(start.unit);
}

std::optional<UnitStart> StoredState::noted(const UnitName& unit) {
  const UnitNote& note = note_of(unit);
  if (note.kept.term == 0) return std::nullopt;
  return UnitStart{unit, note.configuration, note.kept.term, note.kept.generation};
}

void StoredState::begin(const UnitName& unit) {
  running_.insert(unit);
  if (const auto watched = files_.watch(unit); !watched) outcomes_.on_warning(watched.error());
  look_at(unit);
}

void StoredState::end(const UnitName& unit) {
  running_.erase(unit);
  files_.leave(unit);
  look_at(unit);
}

void StoredState::look_at(const UnitName& unit) {
  const auto checksum = checksum_of_parameters(folders_, unit);
  const bool is_saved = !checksum || checksum == note_of(unit).uploaded;
  outcomes_.on_saved(unit, is_saved && !under_way_.contains(unit));
  if (!is_saved) upload(unit);
}

void StoredState::upload(const UnitName& unit) {
  if (!under_way_.insert(unit).second) return;
  waiting_.erase(unit);
  link_.run<StateTransfer::Upload>([transfer = transfer_, unit, term = note_of(unit).kept.term](
                                       Storage& storage) { return transfer.upload(storage, unit, term); },
                                   [this, unit](const auto& outcome) { finish(unit, outcome); });
}

void StoredState::finish(const UnitName& unit, const tl::expected<StateTransfer::Upload, std::string>& outcome) {
  under_way_.erase(unit);
  if (!outcome) {
    waiting_.insert(unit);
    if (!link_.is_up()) return;
    outcomes_.on_warning(
        fmt::format("{}: what it has saved is not on the server yet: {}", unit.text(), outcome.error()));
    return axisd::ServiceEvents::start(again_, kPause);
  }
  if (outcome->is_others) return outcomes_.on_saved(unit, true);
  note_of(unit).uploaded = outcome->checksum;
  keep_note(unit);
  look_at(unit);
}

void StoredState::upload_again() {
  for (const UnitName& unit : running_) {
    note_of(unit).uploaded.reset();
    look_at(unit);
  }
}

void StoredState::on_up() {
  for (const UnitName& unit : std::exchange(waiting_, {})) upload(unit);
}

}  // namespace farm::agent
