#include "can/hub/trunk/arbiter.hpp"

#include <algorithm>
#include <utility>

#include "can/hub/medium/bit_time.hpp"
#include "can/hub/trunk/lateness.hpp"

namespace hub::trunk {

using canopen::TimePoint;

Arbiter::Arbiter(std::uint32_t bit_rate) : line_{bit_rate}, places_(kMostStations) {
  stations_.reserve(kMostStations);
  free_.reserve(kMostStations);
  begin(0);
}

void Arbiter::begin(std::uint32_t term) noexcept {
  term_ = term;
  on_wire_ = false;
  clients_.fill({});
  stations_.clear();
  free_.clear();
  for (Station& station : places_) {
    station.frames.clear();
    free_.push_back(&station);
  }
}

void Arbiter::take(const Reader& request, std::int64_t seen, TimePoint now) noexcept {
  const Header& header = request.header();
  Client* const client = header.term == term_ ? client_of(header) : nullptr;
  if (client == nullptr) return;
  client->seen = std::max(client->seen, header.seen);
  if (client->state != State::Heard) return;
  if (header.counter != client->asked || seen - header.seen > kMostLateness.count()) return lose(*client);
  take_frames(*client, request, now);
}

/// Of the hub in the epoch of @p header; nullptr if it is in a later one, or if there are too many hubs.
Arbiter::Client* Arbiter::client_of(const Header& header) noexcept {
  Client* const place = place_of(header.hub);
  if (place == nullptr) without_place_ = header;
  if (place == nullptr || (place->hub == header.hub && header.epoch < place->epoch)) return nullptr;
  if (place->hub != header.hub || header.epoch > place->epoch || place->asked == 0) register_anew(*place, header);
  return place;
}

Arbiter::Client* Arbiter::place_of(std::uint32_t hub) noexcept {
  if (const auto known = std::ranges::find(clients_, hub, &Client::hub); known != clients_.end()) return &*known;
  Client& place = *std::ranges::min_element(clients_, {}, [](const Client& client) {
    return std::pair{client.hub != 0 && client.state != State::Told, client.seen};
  });
  return place.hub != 0 && place.state != State::Told ? nullptr : &place;
}

void Arbiter::register_anew(Client& client, const Header& header) noexcept {
  forget_frames(client);
  client = {.hub = header.hub,
            .epoch = header.epoch,
            .asked = header.counter,
            .passed = header.counter,
            .seen = header.seen};
}

void Arbiter::take_frames(Client& client, const Reader& request, TimePoint now) noexcept {
  for (std::size_t i = 0; i < request.frames(); ++i) {
    Station* const station = station_of(client, request.header().station());
    if (station == nullptr || station->frames.full()) return lose(client);
    const MarkedFrame frame = request.frame(i);
    station->frames.push({{frame, request.header().origin}, now, handed_over_++, arbitration_field(frame.frame)});
    ++client.asked;
  }
}

/// Where frames of station @p number of @p client wait; nullptr if too many stations have some.
Arbiter::Station* Arbiter::station_of(Client& client, std::uint32_t number) noexcept {
  const auto known = std::ranges::find_if(
      stations_, [&](const Station* station) { return station->client == &client && station->number == number; });
  if (known != stations_.end()) return *known;
  if (free_.empty()) return nullptr;
  Station* const station = free_.back();
  free_.pop_back();
  station->client = &client;
  station->number = number;
  stations_.push_back(station);
  return station;
}

void Arbiter::on_epoch(std::uint32_t hub, std::uint32_t epoch) noexcept {
  const auto client = std::ranges::find(clients_, hub, &Client::hub);
  if (client == clients_.end() || epoch <= client->epoch) return;
  register_anew(*client, {.hub = hub, .epoch = epoch});
}

void Arbiter::look(std::int64_t seen) noexcept {
  for (Client& client : clients_)
    if (client.asked != 0 && client.state == State::Heard && seen - client.seen > kMostLateness.count())
      lose(client);
}

void Arbiter::lose(Client& client) noexcept {
  client.state = State::Lost;
  forget_frames(client);
}

void Arbiter::forget_frames(const Client& client) noexcept {
  if (current_.client == &client) current_.client = nullptr;
  std::erase_if(stations_, [&](Station* station) {
    if (station->client != &client) return false;
    station->frames.clear();
    free_.push_back(station);
    return true;
  });
}

std::optional<Header> Arbiter::take_lost() noexcept {
  const auto told = [](const auto& hub) { return Header{.kind = Kind::Lost, .hub = hub.hub, .epoch = hub.epoch}; };
  if (const auto one_too_many = std::exchange(without_place_, {})) return told(*one_too_many);
  const auto lost = std::ranges::find(clients_, State::Lost, &Client::state);
  if (lost == clients_.end()) return std::nullopt;
  lost->state = State::Told;
  return told(*lost);
}

std::optional<Arbiter::Granted> Arbiter::pass(TimePoint now) noexcept {
  for (;;) {
    if (on_wire_) {
      if (line_.end() > now) return std::nullopt;
      on_wire_ = false;
      if (current_.client != nullptr) return granted();
    }
    if (stations_.empty()) return std::nullopt;
    begin_frame(std::max(line_.end(), earliest_of(stations_)->frames.first().arrival));
  }
}

/// Puts the frame that wins the arbitration at @p start on the bus.
void Arbiter::begin_frame(TimePoint start) noexcept {
  Station* const station = winner_of(stations_, start);
  on_wire_ = true;
  current_ = {station->client, station->number, station->frames.first().content};
  line_.begin(current_.asked.frame.frame, start);
  station->frames.pop();
  if (!station->frames.empty()) return;
  std::erase(stations_, station);
  free_.push_back(station);
}

Arbiter::Granted Arbiter::granted() noexcept {
  Client& client = *current_.client;
  return {.header = {.kind = Kind::Granted,
                     .hub = client.hub,
                     .epoch = client.epoch,
                     .origin = current_.asked.origin,
                     .counter = client.passed++,
                     .detail = current_.station},
          .frame = current_.asked.frame,
          .end = line_.real_end()};
}

TimePoint Arbiter::next_deadline() const noexcept {
  if (on_wire_) return line_.end();
  return stations_.empty() ? canopen::kNever : TimePoint::min();
}

std::size_t Arbiter::waiting() const noexcept {
  std::size_t count = 0;
  for (const Station* const station : stations_) count += station->frames.count();
  return count;
}

}  // namespace hub::trunk
