#include <array>

#include "bench/operations/library_node.hpp"
#include "bench/operations/operation.hpp"

namespace bench {
namespace {

using canopen::Frame;

constexpr std::uint8_t kEventDriven = 255;

template <std::uint16_t kPdos>
struct Rpdo {
  Rpdo() {
    step();
    check(stored(0x6040) == 0x000F && stored(0x607A) == 0x03020101 && stored(0x6060) == 8, "values of an RPDO");
  }
  void step() {
    ++frame.data[2];
    unit.node.on_frame(frame, unit.now);
  }
  std::int64_t stored(std::uint16_t object) {
    return unit.dictionary.stored(**unit.dictionary.find(LibraryNode::axis_object(object, kPdos - 1), 0));
  }

  LibraryNode unit{{.pdos = kPdos}};
  Frame frame{
      .id = LibraryNode::kFirstRpdo + kPdos - 1, .length = 7, .data = {0x0F, 0x00, 0x00, 0x01, 0x02, 0x03, 0x08}};
};

template <std::uint16_t kPdos>
struct Sync {
  Sync() {
    unit.position(kPdos - 1).set(0x04030201);
    const std::uint64_t before = unit.sink.count;
    step();
    check(unit.sink.count - before == kPdos, "number of TPDOs after SYNC");
    check(unit.sink.last == Frame{.id = LibraryNode::kFirstTpdo + kPdos - 1,
                                  .length = 6,
                                  .data = {0x37, 0x02, 0x01, 0x02, 0x03, 0x04}},
          "last TPDO after SYNC");
  }
  void step() { unit.node.on_frame(frame, unit.now); }

  LibraryNode unit{{.pdos = kPdos}};
  Frame frame{.id = 0x080};
};

/// Event-driven TPDOs are compared with what they sent last; with kChanges every one has news.
template <bool kChanges>
struct Judgement {
  static constexpr std::uint16_t kPdos = 4;
  Judgement() {
    const std::uint64_t before = unit.sink.count;
    step();
    check(unit.sink.count - before == (kChanges ? kPdos : 0), "number of event-driven TPDOs");
  }
  void step() {
    if constexpr (kChanges) {
      ++value;
      for (auto& position : positions) position.set(value);
    }
    unit.node.on_values_changed(unit.now);
  }

  LibraryNode unit{{.pdos = kPdos, .transmission_type = kEventDriven}};
  std::array<canopen::Cell<std::int32_t>, kPdos> positions{unit.position(0), unit.position(1), unit.position(2),
                                                           unit.position(3)};
  std::int32_t value = 0;
};

struct IdleTick {
  IdleTick() {
    const std::uint64_t before = unit.sink.count;
    step();
    check(unit.sink.count == before && earliest > unit.now, "an idle tick");
  }
  void step() {
    unit.node.on_time(unit.now);
    earliest = unit.node.next_deadline();
  }

  LibraryNode unit{{.pdos = 64}};
  canopen::TimePoint earliest{};
};

}  // namespace

std::vector<OperationRow> library_pdo_operations() {
  return {
      {"library/rpdo", "RPDO with 3 objects applied", make<Rpdo<4>>},
      {"library/rpdo_64", "the same, last of 64", make<Rpdo<64>>},
      {"library/sync_4", "SYNC to 4 TPDOs of 2 objects", make<Sync<4>>},
      {"library/sync_64", "SYNC to 64 TPDOs of 2 objects", make<Sync<64>>},
      {"library/judge_quiet", "4 event-driven TPDOs judged, nothing new", make<Judgement<false>>},
      {"library/judge_news", "4 event-driven TPDOs judged and sent", make<Judgement<true>>},
      {"library/idle_tick", "tick with nothing due, 64 + 64 PDOs", make<IdleTick>},
  };
}

}  // namespace bench
