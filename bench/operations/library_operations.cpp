#include "bench/operations/library_node.hpp"
#include "bench/operations/operation.hpp"

namespace bench {
namespace {

using canopen::Frame;

struct SameUpload {
  SameUpload() {
    step();
    check(answers(unit.sink.last, request, 0x12345678), "SDO upload of 2000h");
  }
  void step() { unit.node.on_frame(request, unit.now); }

  LibraryNode unit;
  Frame request = sdo_request(LibraryNode::kNodeId, kUpload, {LibraryNode::kNumber, 0});
};

struct RandomUpload {
  RandomUpload() {
    for (const Frame& request : requests) {
      const canopen::sdo::Address at = canopen::sdo::address_in(request);
      const std::int64_t stored = unit.dictionary.stored(**unit.dictionary.find(at.index, at.sub_index));
      unit.node.on_frame(request, unit.now);
      check(answers(unit.sink.last, request, static_cast<std::uint32_t>(stored)), "SDO upload of a random object");
    }
  }
  void step() { unit.node.on_frame(requests[next++ % requests.size()], unit.now); }

  LibraryNode unit;
  std::vector<Frame> requests = random_uploads(unit.dictionary);
  std::size_t next = 0;
};

struct Download {
  Download() {
    step();
    check(unit.sink.last.data[0] == kDownloadDone, "SDO download of 2000h");
    check(unit.dictionary.stored(**unit.dictionary.find(LibraryNode::kNumber, 0)) == 1, "value after a download");
  }
  void step() {
    canopen::store(&request.data[4], ++value);
    unit.node.on_frame(request, unit.now);
  }

  LibraryNode unit;
  Frame request = sdo_request(LibraryNode::kNodeId, expedited_download(4), {LibraryNode::kNumber, 0});
  std::uint32_t value = 0;
};

/// One request of a segmented upload: 147 segments after every initiation.
struct SegmentedUpload {
  SegmentedUpload() {
    for (std::size_t frame = 0; frame <= kSegments; ++frame) step();
    check((unit.sink.last.data[0] & 0xE1) == 0x01, "last segment of an upload");
    check(unit.sink.last.data[2] == 'd' && unit.sink.last.data[3] == 0, "bytes of the last segment");
  }
  void step() {
    constexpr std::uint8_t kUploadSegment = 0x60;
    const bool initiates = position == 0;
    Frame& request = initiates ? initiation : segment;
    if (!initiates) request.data[0] = static_cast<std::uint8_t>(kUploadSegment | ((position - 1) % 2) << 4);
    unit.node.on_frame(request, unit.now);
    position = position == kSegments ? 0 : position + 1;
  }

  static constexpr std::size_t kSegments = (LibraryNode::kDomainBytes + 6) / 7;
  LibraryNode unit;
  Frame initiation = sdo_request(LibraryNode::kNodeId, kUpload, {LibraryNode::kDomain, 0});
  Frame segment = sdo_request(LibraryNode::kNodeId, 0, {});
  std::size_t position = 0;
};

/// Finds objects in a random order; with kFinds false only what picks them, to be taken off.
template <bool kFinds>
struct Lookup {
  Lookup() {
    std::uint32_t expected = 0;
    for (const Frame& request : requests) {
      const canopen::sdo::Address at = canopen::sdo::address_in(request);
      expected += at.index + at.sub_index;
      step();
    }
    check(sum == expected, "random lookup");
  }
  void step() {
    const canopen::sdo::Address at = canopen::sdo::address_in(requests[next++ % requests.size()]);
    if constexpr (kFinds) {
      const canopen::Entry* const entry = unit.dictionary.lookup(at.index, at.sub_index);
      sum += entry->index + entry->sub_index;
    } else {
      sum += at.index + at.sub_index;
    }
  }

  LibraryNode unit;
  std::vector<Frame> requests = random_uploads(unit.dictionary);
  std::size_t next = 0;
  std::uint32_t sum = 0;
};

}  // namespace

std::vector<OperationRow> library_operations() {
  return {
      {"library/sdo_upload", "SDO expedited upload, the same object", make<SameUpload>},
      {"library/sdo_upload_random", "SDO expedited upload, random object of 1,500", make<RandomUpload>},
      {"library/sdo_download", "SDO expedited download", make<Download>},
      {"library/sdo_segment", "SDO segmented upload of 1 kB, one of its frames", make<SegmentedUpload>},
      {"library/lookup", "dictionary lookup, random object of 1,500, with the picking", make<Lookup<true>>},
      {"library/pick", "the picking alone", make<Lookup<false>>},
  };
}

}  // namespace bench
