#include "can/port/multicast/multicast_message.hpp"

#include <cstdlib>
#include <cstring>
#include <iostream>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "can/port/wire.hpp"
#include "tests/fakes/candump.hpp"

namespace bus::multicast {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Map = nlohmann::ordered_json;

/// The bytes that the hexadecimal @p digits spell.
Bytes bytes_of(std::string_view digits) {
  Bytes bytes;
  for (; !digits.empty(); digits.remove_prefix(2))
    bytes.push_back(static_cast<std::uint8_t>(fakes::hexadecimal(digits.substr(0, 2))));
  return bytes;
}

/// What datagram @p bytes holds, as candump prints it; "error" and the class for an error frame, "" for none.
std::string seen(const Bytes& bytes) {
  const auto frame = unpack(bytes);
  if (!frame) return "";
  if ((frame->can_id & CAN_ERR_FLAG) != 0) return "error " + std::to_string(frame->can_id & CAN_ERR_MASK);
  return fakes::candump(from_wire(*frame));
}

Bytes packed(const char* frame) {
  return pack(to_wire(fakes::frame_of(frame)));
}

/// The map of a data frame.
Map map_of_frame() {
  return Map::from_msgpack(packed("605#4000100000000000"));
}

std::string seen(const Map& map) {
  return seen(Map::to_msgpack(map));
}

// Made by python-can 4.1, pack_message(): the time stamp, the identifier, three flags, channel, length, data,
// three flags of CAN FD.
constexpr std::string_view kDataFrame =
    "8ba974696d657374616d70cb0000000000000000ae6172626974726174696f6e5f6964cd0605ae69735f657874656e6465645f6964c2"
    "af69735f72656d6f74655f6672616d65c2ae69735f6572726f725f6672616d65c2a76368616e6e656cc0a3646c6308a464617461c408"
    "4000100000000000a569735f6664c2ae626974726174655f737769746368c2b56572726f725f73746174655f696e64696361746f72"
    "c2";
constexpr std::string_view kExtendedFrame =
    "8ba974696d657374616d70cb0000000000000000ae6172626974726174696f6e5f6964ce18da00f1ae69735f657874656e6465645f69"
    "64c3af69735f72656d6f74655f6672616d65c2ae69735f6572726f725f6672616d65c2a76368616e6e656cc0a3646c6301a464617461"
    "c40101a569735f6664c2ae626974726174655f737769746368c2b56572726f725f73746174655f696e64696361746f72c2";
constexpr std::string_view kRemoteFrame =
    "8ba974696d657374616d70cb0000000000000000ae6172626974726174696f6e5f6964cd0705ae69735f657874656e6465645f6964c2"
    "af69735f72656d6f74655f6672616d65c3ae69735f6572726f725f6672616d65c2a76368616e6e656cc0a3646c6304a464617461c400"
    "a569735f6664c2ae626974726174655f737769746368c2b56572726f725f73746174655f696e64696361746f72c2";
constexpr std::string_view kErrorFrame =
    "8ba974696d657374616d70cb0000000000000000ae6172626974726174696f6e5f696440ae69735f657874656e6465645f6964c3af69"
    "735f72656d6f74655f6672616d65c2ae69735f6572726f725f6672616d65c3a76368616e6e656cc0a3646c6308a464617461c4080000"
    "000000000000a569735f6664c2ae626974726174655f737769746368c2b56572726f725f73746174655f696e64696361746f72c2";
constexpr std::string_view kFdFrame =
    "8ba974696d657374616d70cb0000000000000000ae6172626974726174696f6e5f696401ae69735f657874656e6465645f6964c2af69"
    "735f72656d6f74655f6672616d65c2ae69735f6572726f725f6672616d65c2a76368616e6e656ca57663616e30a3646c630ca4646174"
    "61c40c000000000000000000000000a569735f6664c3ae626974726174655f737769746368c2b56572726f725f73746174655f696e64"
    "696361746f72c2";

TEST(MulticastMessage, OfPythonCanIsUnderstood) {
  EXPECT_EQ(seen(bytes_of(kDataFrame)), "605#4000100000000000");
  EXPECT_EQ(seen(bytes_of(kExtendedFrame)), "18DA00F1#01");
  EXPECT_EQ(seen(bytes_of(kRemoteFrame)), "705#R4");
  EXPECT_EQ(seen(bytes_of(kErrorFrame)), "error 64");
}

TEST(MulticastMessage, OfCanFdIsNoFrameOfThisBus) {
  EXPECT_EQ(seen(bytes_of(kFdFrame)), "");
}

TEST(MulticastMessage, HasTheKeysAndValuesOfPythonCanInItsOrder) {
  EXPECT_EQ(Map::from_msgpack(packed("605#4000100000000000")), Map::from_msgpack(bytes_of(kDataFrame)));
  EXPECT_EQ(Map::from_msgpack(packed("18DA00F1#01")), Map::from_msgpack(bytes_of(kExtendedFrame)));
  EXPECT_EQ(Map::from_msgpack(packed("705#R4")), Map::from_msgpack(bytes_of(kRemoteFrame)));
}

TEST(MulticastMessage, ComesBackAsItWas) {
  for (const char* const frame : {"000#8105", "7FF#", "00000000#0102030405060708", "1FFFFFFF#R8", "080#R"})
    EXPECT_EQ(seen(packed(frame)), frame);
}

TEST(MulticastMessage, MayHaveTheKeysInAnyOrderAndOthersToo) {
  Map map = map_of_frame();
  Map other{{"sender", "test"}};
  for (auto item = map.rbegin(); item != map.rend(); ++item) other[item.key()] = item.value();

  EXPECT_EQ(seen(other), "605#4000100000000000");
}

struct Malformed {
  const char* key;
  Map value;
};
class MulticastMessageRefuses : public testing::TestWithParam<Malformed> {};

TEST_P(MulticastMessageRefuses, AWrongValue) {
  Map map = map_of_frame();
  map[GetParam().key] = GetParam().value;

  EXPECT_EQ(seen(map), "");
}

INSTANTIATE_TEST_SUITE_P(Values, MulticastMessageRefuses,
                         testing::Values(Malformed{"arbitration_id", 0x800}, Malformed{"arbitration_id", -1},
                                         Malformed{"arbitration_id", "605"}, Malformed{"arbitration_id", 1e3},
                                         Malformed{"arbitration_id", nullptr}, Malformed{"is_extended_id", 1},
                                         Malformed{"is_remote_frame", nullptr}, Malformed{"is_error_frame", "no"},
                                         Malformed{"dlc", 9}, Malformed{"dlc", 7}, Malformed{"dlc", -8},
                                         Malformed{"dlc", 1ULL << 40}, Malformed{"data", nullptr},
                                         Malformed{"data", "12345678"}, Malformed{"data", Map::array()},
                                         Malformed{"data", Map::binary(Bytes(9))}, Malformed{"is_fd", true},
                                         Malformed{"is_fd", 0}, Malformed{"is_remote_frame", true}));

TEST(MulticastMessage, NeedsWhatMakesUpAFrame) {
  for (const char* const key :
       {"arbitration_id", "is_extended_id", "is_remote_frame", "is_error_frame", "dlc", "data"}) {
    Map map = map_of_frame();
    map.erase(key);

    EXPECT_EQ(seen(map), "") << key;
  }
}

TEST(MulticastMessage, IsRefusedWhereverItIsCutAndWithBytesBehind) {
  const Bytes whole = bytes_of(kDataFrame);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_EQ(seen(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))), "") << size;
  Bytes longer = whole;
  longer.push_back(0xC0);

  EXPECT_EQ(seen(longer), "");
}

TEST(MulticastMessage, IsRefusedIfItIsNestedOrPretendsToBeLarge) {
  EXPECT_EQ(seen(Bytes(kLongestDatagram, 0x91)), "");  // arrays in arrays
  EXPECT_EQ(seen(Bytes(65507, 0x91)), "");             // and in more arrays
  EXPECT_EQ(seen(bytes_of("DDFFFFFFFF")), "");         // an array of 2^32 - 1 values
  EXPECT_EQ(seen(bytes_of("DFFFFFFFFF")), "");         // a map of as many
  EXPECT_EQ(seen(bytes_of("C6FFFFFFFF00")), "");       // as many bytes
  EXPECT_EQ(seen(bytes_of("C1")), "");                 // no MessagePack
}

TEST(MulticastMessage, MayBeAnythingWithoutHarm) {
  const char* const given = std::getenv("AXISD_TEST_SEED");
  const unsigned seed = given != nullptr ? static_cast<unsigned>(std::atoi(given)) : std::random_device{}();
  SCOPED_TRACE("AXISD_TEST_SEED=" + std::to_string(seed));
  std::cout << "AXISD_TEST_SEED=" << seed << '\n';
  std::mt19937 random{seed};
  const Bytes frame = bytes_of(kDataFrame);
  for (int round = 0; round < 20000; ++round) {
    Bytes bytes = round % 2 == 0 ? frame : Bytes(random() % kLongestDatagram);
    if (round % 2 == 0) {
      for (unsigned changes = random() % 4 + 1; changes > 0; --changes)
        bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    } else {
      for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    }

    const auto found = unpack(bytes);

    if (found) {
      ASSERT_LE(found->len, CAN_MAX_DLEN);
      ASSERT_LE(found->can_id & CAN_EFF_MASK,
                (found->can_id & (CAN_EFF_FLAG | CAN_ERR_FLAG)) != 0 ? 0x1FFFFFFFu : 0x7FFu);
    }
  }
}

}  // namespace
}  // namespace bus::multicast
