#include "can/port/address.hpp"

#include <array>
#include <cstdlib>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace bus {
namespace {

/// The address that @p text must be.
Address parsed(std::string_view text) {
  const auto address = parse_address(text);
  return address ? *address : Address{"refused: expected " + address.error(), KernelInterface{}};
}

/// What was expected instead of @p text.
std::string refusal(std::string_view text) {
  const auto address = parse_address(text);
  return address ? "accepted" : address.error();
}

/// Gives an environment variable a value, nullptr for none, for as long as it lives.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_{name} {
    if (const char* const before = std::getenv(name)) before_ = before;
    set(value);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() { set(before_.empty() ? nullptr : before_.c_str()); }

 private:
  void set(const char* value) const {
    if (value == nullptr)
      ::unsetenv(name_);
    else
      ::setenv(name_, value, 1);
  }

  const char* name_;
  std::string before_;
};

TEST(Address, TakesAPlainNameForAnInterfaceOfTheKernel) {
  EXPECT_EQ(parsed("vcan0"), (Address{"vcan0", KernelInterface{"vcan0"}}));
  EXPECT_EQ(parsed("fifteen-letters"), (Address{"fifteen-letters", KernelInterface{"fifteen-letters"}}));
}

TEST(Address, TakesAUnixSocket) {
  EXPECT_EQ(parsed("unix:/run/can"), (Address{"unix:/run/can", UserBusPath{"/run/can"}}));
  EXPECT_EQ(parsed("unix:/run/a/../can"), (Address{"unix:/run/a/../can", UserBusPath{"/run/can"}}));
}

TEST(Address, TakesARelativePathFromTheCurrentFolder) {
  std::array<char, 4096> folder{};
  ASSERT_NE(::getcwd(folder.data(), folder.size()), nullptr);

  EXPECT_EQ(parsed("unix:bus"), (Address{"unix:bus", UserBusPath{std::string{folder.data()} + "/bus"}}));
}

TEST(Address, FindsTheDefaultBusOfTheUser) {
  const Variable bus{"CAN_BUS", nullptr};
  const Variable runtime{"XDG_RUNTIME_DIR", "/run/user/1000"};

  EXPECT_EQ(parsed("unix:"), (Address{"unix:/run/user/1000/can-bus", UserBusPath{"/run/user/1000/can-bus"}}));
}

TEST(Address, TakesMulticastGroups) {
  EXPECT_EQ(parsed("udp-multicast://239.74.163.2:43113").place,
            (Place{MulticastGroup{"239.74.163.2", 43113, ""}}));
  EXPECT_EQ(parsed("udp-multicast://239.74.163.2:43113?interface=lo").place,
            (Place{MulticastGroup{"239.74.163.2", 43113, "lo"}}));
  EXPECT_EQ(parsed("udp-multicast://[ff15:0:0::0001]:1").place, (Place{MulticastGroup{"ff15::1", 1, ""}}));
}

TEST(Address, TakesSocketcandServers) {
  EXPECT_EQ(parsed("socketcand://localhost:29536/vcan0").place,
            (Place{SocketcandServer{"localhost", 29536, "vcan0"}}));
  EXPECT_EQ(parsed("socketcand://[::1]:29536/can0").place, (Place{SocketcandServer{"::1", 29536, "can0"}}));
}

struct BadAddress {
  std::string text;
  std::string expected;
};

class AddressRefuses : public testing::TestWithParam<BadAddress> {};

TEST_P(AddressRefuses, SayingWhatWasExpected) {
  EXPECT_EQ(refusal(GetParam().text), GetParam().expected);
}

const std::string kForms =
    "a name of 1 to 15 characters without spaces, unix:PATH, udp-multicast://GROUP:PORT[?interface=NAME] or "
    "socketcand://HOST:PORT/NAME";
const std::string kGroup = "a multicast group, 224.0.0.0 to 239.255.255.255 or [ff00::] to [ffff:...]";
const std::string kGroupPort = "a port 1 to 65535 behind the group";
const std::string kName = "/NAME of the bus, 1 to 64 characters without spaces, behind the port";

INSTANTIATE_TEST_SUITE_P(
    Texts, AddressRefuses,
    testing::Values(
        BadAddress{"", kForms}, BadAddress{"a-rather-long-name", kForms}, BadAddress{"a b", kForms},
        BadAddress{"../x", kForms}, BadAddress{"..", kForms}, BadAddress{"tcp://host:1", kForms},
        BadAddress{"unix", "accepted"}, BadAddress{"UNIX:/x", kForms},
        BadAddress{"unix:/", "the path of a socket behind unix:"},
        BadAddress{"unix:/tmp/", "the path of a socket behind unix:"},
        BadAddress{"unix:/" + std::string(106, 'x'), "accepted"},
        BadAddress{"unix:/" + std::string(107, 'x'), "an absolute path of at most 107 bytes"},
        BadAddress{std::string{"unix:/a\0b", 9}, "a path without a zero byte behind unix:"},
        BadAddress{"udp-multicast://", kGroupPort}, BadAddress{"udp-multicast://239.1.1.1", kGroupPort},
        BadAddress{"udp-multicast://239.1.1.1:0", kGroupPort},
        BadAddress{"udp-multicast://239.1.1.1:65536", kGroupPort},
        BadAddress{"udp-multicast://239.1.1.1:1x", kGroupPort},
        BadAddress{"udp-multicast://:43113", "a group before the port"},
        BadAddress{"udp-multicast://10.0.0.1:43113", kGroup}, BadAddress{"udp-multicast://group:43113", kGroup},
        BadAddress{"udp-multicast://[fe80::1]:43113", kGroup},
        BadAddress{"udp-multicast://[ff15::1:43113", "a ] behind the group"},
        BadAddress{"udp-multicast://[ff15::1]43113", kGroupPort},
        BadAddress{"udp-multicast://239.1.1.1:1?lo", "interface=NAME behind the question mark"},
        BadAddress{"udp-multicast://239.1.1.1:1?interface=", "interface=NAME behind the question mark"},
        BadAddress{"socketcand://host/vcan0", "a port 1 to 65535 behind the host"},
        BadAddress{"socketcand://:1/vcan0", "a host before the port"}, BadAddress{"socketcand://host:1", kName},
        BadAddress{"socketcand://host:1/", kName}, BadAddress{"socketcand://host:1/a b", kName},
        BadAddress{"socketcand://host:1/a>", kName}));

TEST(AddressLabel, IsThePlainNameItself) {
  EXPECT_EQ(label(parsed("vcan0")), "vcan0");
}

TEST(AddressLabel, NamesWhatTheUrlIsAndKeepsAPartOfItToRead) {
  EXPECT_EQ(label(parsed("unix:/run/user/1000/can-bus")), "unix-can-bus-a15685e3");
  EXPECT_EQ(label(parsed("udp-multicast://239.74.163.2:43113")), "udp-multicast-239.74.163.2-6315c4f0");
  EXPECT_EQ(label(parsed("socketcand://localhost:29536/vcan0")), "socketcand-vcan0-e5fb731f");
}

TEST(AddressLabel, IsTheSameForEveryWayToWriteTheSameAddress) {
  EXPECT_EQ(label(parsed("unix:/run/can")), label(parsed("unix:/run/x/../can")));
  EXPECT_EQ(label(parsed("udp-multicast://[FF15:0::1]:7")), label(parsed("udp-multicast://[ff15::1]:7")));
}

TEST(AddressLabel, TellsAddressesApart) {
  const std::array texts{"unix:/a/bus",
                         "unix:/b/bus",
                         "udp-multicast://239.1.1.1:1",
                         "udp-multicast://239.1.1.1:2",
                         "udp-multicast://239.1.1.1:1?interface=lo",
                         "socketcand://a:1/vcan0",
                         "socketcand://b:1/vcan0",
                         "socketcand://a:1/vcan1"};
  std::set<std::string> labels;

  for (const char* const text : texts) labels.insert(label(parsed(text)));

  EXPECT_EQ(labels.size(), texts.size());
}

TEST(AddressLabel, FitsIntoFileNamesAndSocketNames) {
  for (const std::string& text : {"unix:/tmp/a b:c?d/" + std::string(80, '\xC3'),
                                  std::string{"udp-multicast://[ff15:7079:7468:6f6e::1]:65535"},
                                  "socketcand://host:1/" + std::string(64, '/')}) {
    const std::string name = label(parsed(text));

    EXPECT_LE(name.size(), 40u) << name;
    EXPECT_EQ(name.find_first_of("/: ?\xC3"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace bus
