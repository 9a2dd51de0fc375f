#include <random>

#include "tests/fakes/memory_domain.hpp"
#include "tests/libcanopen/fixture/node_fixture.hpp"
#include "tests/libcanopen/fixture/sdo_client.hpp"
#include "tests/libcanopen/fixture/sdo_table.hpp"

namespace {

using canopen::AbortCode;
using Bytes = SdoClient::Bytes;
using Outcome = SdoClient::Outcome;

Bytes some_bytes(std::size_t count) {
  std::mt19937 random{static_cast<std::uint32_t>(count)};
  Bytes bytes(count);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

/// DOMAINs of owners: 2100h rw, 2101h wo, 2102h ro. 2103h has none.
class SdoDomain : public NodeTest {
 protected:
  SdoDomain() : NodeTest{{.extended_identifiers = false}, sdo_table()} {
    dictionary.own_domain(0x2100, 0, domain);
    start();
  }

  static constexpr canopen::sdo::Address kDomain{0x2100, 0};
  static constexpr std::size_t kMuch = 100'000;
  fakes::MemoryDomain domain;
  SdoClient client{*node, bus};
  SdoClient other{*node, bus, 0x680};
};

TEST_F(SdoDomain, IsReadInSegmentsWithItsSizeIndicated) {
  domain.bytes = {'H', 'e', 'l', 'l', 'o', ',', ' ', 'y', 'o'};
  expect_dialogue({
      {"605#4000210000000000", "585#4100210009000000"},
      {"605#6000000000000000", "585#0048656C6C6F2C20"},
      {"605#7000000000000000", "585#1B796F0000000000"},
  });
}

TEST_F(SdoDomain, IsReadInSegmentsWithoutItsSizeIfNobodyKnowsIt) {
  domain.says_size = false;
  domain.bytes = {1, 2, 3, 4, 5, 6, 7};
  expect_dialogue({
      {"605#4000210000000000", "585#4000210000000000"},
      {"605#6000000000000000", "585#0101020304050607"},
  });
}

TEST_F(SdoDomain, IsReadInABlockWithoutItsSizeIfNobodyKnowsIt) {
  domain.says_size = false;
  domain.bytes = {1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(says("605#A4002100027F0000"), (Lines{"585#C400210000000000"}));
  EXPECT_EQ(says("605#A300000000000000"), (Lines{"585#0101020304050607", "585#8208000000000000"}));
  EXPECT_EQ(says("605#A202020000000000"), (Lines{"585#D9AC760000000000"}));
}

TEST_F(SdoDomain, IsWrittenInOneFrame) {
  expect_dialogue({{"605#2700210001020300", "585#6000210000000000"}});
  EXPECT_EQ(domain.bytes, (Bytes{1, 2, 3}));
  EXPECT_EQ(domain.announced, 3U);
}

TEST_F(SdoDomain, PassesDataOfEveryLengthInEveryForm) {
  for (const std::size_t length :
       {0U, 1U, 6U, 7U, 8U, 14U, 888U, 889U, 890U, 1015U, 1023U, 1024U, 1025U, 1778U, 2048U, 5000U}) {
    const Bytes bytes = some_bytes(length);
    for (const bool sized : {true, false}) {
      domain.asked.clear();
      EXPECT_EQ(client.download(kDomain, bytes, sized), Outcome{bytes}) << length;
      EXPECT_TRUE(domain.was_asked_in_order()) << length;
      EXPECT_EQ(domain.bytes, bytes) << length;
      EXPECT_EQ(domain.announced.has_value(), sized);

      domain.asked.clear();
      domain.bytes.clear();
      EXPECT_EQ(client.block_download(kDomain, bytes, {}, sized), Outcome{bytes}) << length;
      EXPECT_TRUE(domain.was_asked_in_order()) << length;
      EXPECT_EQ(domain.bytes, bytes) << length;

      domain.says_size = sized;
      domain.asked.clear();
      EXPECT_EQ(client.upload(kDomain), Outcome{bytes}) << length;
      EXPECT_TRUE(domain.was_asked_in_order()) << length;

      for (const int block_size : {1, 2, 126, 127}) {
        domain.asked.clear();
        EXPECT_EQ(client.block_upload(kDomain, {.block_size = static_cast<std::uint8_t>(block_size)}),
                  Outcome{bytes})
            << length << ' ' << block_size;
        EXPECT_TRUE(domain.was_asked_in_order()) << length;
      }
    }
  }
  EXPECT_EQ(domain.cancelled, 0);
}

TEST_F(SdoDomain, IsReadInBlocksAlthoughSegmentsAreLost) {
  domain.bytes = some_bytes(kMuch);
  std::set<std::size_t> lost{0, 1, 126, 127, 500, 14285};
  for (std::size_t segment = 1000; segment < 14000; segment += 97) lost.insert(segment);

  EXPECT_EQ(client.block_upload(kDomain, {.lost = lost}), Outcome{domain.bytes});

  EXPECT_TRUE(domain.was_asked_in_order());
}

TEST_F(SdoDomain, IsWrittenInBlocksAlthoughSegmentsAreLost) {
  const Bytes bytes = some_bytes(kMuch);
  std::set<std::size_t> lost{0, 126, 127, 500, 14285};
  for (std::size_t segment = 1000; segment < 14000; segment += 97) lost.insert(segment);

  EXPECT_EQ(client.block_download(kDomain, bytes, {.lost = lost}), Outcome{bytes});

  EXPECT_EQ(domain.bytes, bytes);
  EXPECT_TRUE(domain.was_asked_in_order());
  EXPECT_EQ(domain.ended_with, kMuch);
}

TEST_F(SdoDomain, KeepsWhatItWasIfTheCrcIsWrong) {
  domain.bytes = {1, 2, 3};

  EXPECT_EQ(client.block_download(kDomain, some_bytes(kMuch), {.flips_crc_bit = true}),
            Outcome{AbortCode::CrcError});

  EXPECT_EQ(domain.bytes, (Bytes{1, 2, 3}));
  EXPECT_EQ(domain.cancelled, 1);
  EXPECT_EQ(domain.ended_with, std::nullopt);
}

TEST_F(SdoDomain, IsFreeAgainAfterAClientHasGivenUp) {
  const Bytes bytes = some_bytes(kMuch);
  EXPECT_EQ(client.block_download(kDomain, bytes, {.aborts_after = 1000}), Outcome{AbortCode::GeneralError});
  EXPECT_EQ(domain.cancelled, 1);
  EXPECT_EQ(domain.ended_with, std::nullopt);

  EXPECT_EQ(client.block_download(kDomain, bytes), Outcome{bytes});
  EXPECT_EQ(client.block_upload(kDomain, {.aborts_after = 1000}), Outcome{AbortCode::GeneralError});
  EXPECT_EQ(client.block_upload(kDomain), Outcome{bytes});
  EXPECT_EQ(domain.cancelled, 1);
}

TEST_F(SdoDomain, EndsATransferThatItRefuses) {
  domain.bytes = some_bytes(kMuch);
  domain.refuse_from = 50'000;
  EXPECT_EQ(client.upload(kDomain), Outcome{AbortCode::HardwareError});
  EXPECT_EQ(client.block_upload(kDomain), Outcome{AbortCode::HardwareError});
  EXPECT_EQ(client.download(kDomain, some_bytes(kMuch)), Outcome{AbortCode::OutOfMemory});
  EXPECT_EQ(client.block_download(kDomain, some_bytes(kMuch)), Outcome{AbortCode::OutOfMemory});
  EXPECT_EQ(domain.cancelled, 2);

  domain.refuse_from = UINT64_MAX;
  domain.refuse_end = AbortCode::HardwareError;
  EXPECT_EQ(client.download(kDomain, {1, 2, 3}), Outcome{AbortCode::HardwareError});
  EXPECT_EQ(domain.cancelled, 3);

  domain.refuse_begin = AbortCode::NoData;
  EXPECT_EQ(client.upload(kDomain), Outcome{AbortCode::NoData});
  EXPECT_EQ(client.download(kDomain, {1, 2, 3}), Outcome{AbortCode::NoData});
  EXPECT_EQ(client.block_upload(kDomain), Outcome{AbortCode::NoData});
  EXPECT_EQ(client.block_download(kDomain, {1, 2, 3}), Outcome{AbortCode::NoData});
  EXPECT_EQ(domain.cancelled, 3);
}

TEST_F(SdoDomain, IsNotReadToTheEndIfItHasLessThanItSaid) {
  class Short final : public canopen::DomainOwner {
    canopen::Result<std::optional<std::uint32_t>> begin_read(const canopen::Entry&) noexcept override {
      return 10;
    }
    canopen::Result<std::size_t> read(const canopen::Entry&, std::uint64_t,
                                      std::span<std::uint8_t>) noexcept override {
      return 9;
    }
  } owner;
  dictionary.own_domain(0x2100, 0, owner);

  EXPECT_EQ(client.upload(kDomain), Outcome{AbortCode::CannotTransfer});
  EXPECT_EQ(client.block_upload(kDomain), Outcome{AbortCode::CannotTransfer});
}

TEST_F(SdoDomain, RefusesByDefaultWhatAnOwnerDoesNotOffer) {
  canopen::DomainOwner owner;
  dictionary.own_domain(0x2100, 0, owner);

  EXPECT_EQ(client.upload(kDomain), Outcome{AbortCode::UnsupportedAccess});
  EXPECT_EQ(client.download(kDomain, {1}), Outcome{AbortCode::UnsupportedAccess});
}

TEST_F(SdoDomain, ObeysItsAccess) {
  fakes::MemoryDomain more;
  dictionary.own_domain(0x2101, 0, more);
  dictionary.own_domain(0x2102, 0, more);

  EXPECT_EQ(client.upload({0x2101, 0}), Outcome{AbortCode::WriteOnly});
  EXPECT_EQ(client.block_upload({0x2101, 0}), Outcome{AbortCode::WriteOnly});
  EXPECT_EQ(client.download({0x2102, 0}, {1}), Outcome{AbortCode::ReadOnly});
  EXPECT_EQ(client.block_download({0x2102, 0}, {1}), Outcome{AbortCode::ReadOnly});
  EXPECT_EQ(more.reads + more.writes, 0);
}

TEST_F(SdoDomain, WithoutAnOwnerIsKeptInTheDictionary) {
  for (const std::size_t length : {0U, 7U, 20U}) {
    const Bytes bytes = some_bytes(length);
    EXPECT_EQ(client.block_download({0x2103, 0}, bytes), Outcome{bytes});
    EXPECT_EQ(client.upload({0x2103, 0}), Outcome{bytes});
    EXPECT_EQ(client.download({0x2103, 0}, bytes), Outcome{bytes});
    EXPECT_EQ(client.block_upload({0x2103, 0}), Outcome{bytes});
  }
  EXPECT_EQ(client.block_download({0x2103, 0}, some_bytes(21)), Outcome{AbortCode::LengthMismatch});
}

TEST_F(SdoDomain, IsReadByManyClientsAtTheSameTime) {
  domain.bytes = some_bytes(3000);
  client.says(0x0000000000210040);  // initiates an upload and leaves it at that

  EXPECT_EQ(other.upload(kDomain), Outcome{domain.bytes});
  EXPECT_EQ(other.download(kDomain, {1}), Outcome{AbortCode::DeviceState});
}

TEST_F(SdoDomain, IsLeftAloneWhileOneClientWrites) {
  client.says(0x0000000000210020);  // initiates a download
  EXPECT_EQ(other.upload(kDomain), Outcome{AbortCode::DeviceState});
  EXPECT_EQ(other.block_upload(kDomain), Outcome{AbortCode::DeviceState});
  EXPECT_EQ(other.download(kDomain, {1}), Outcome{AbortCode::DeviceState});
  EXPECT_EQ(other.block_download(kDomain, {1}), Outcome{AbortCode::DeviceState});
  EXPECT_EQ(domain.writes, 1);

  client.says(0x0000000000210080);  // gives up
  EXPECT_EQ(domain.cancelled, 1);
  EXPECT_EQ(other.download(kDomain, {1}), Outcome{Bytes{1}});
}

TEST_F(SdoDomain, ForgetsAWriteThatIsSilentRestartedOrReset) {
  says("605#2000210000000000");
  EXPECT_EQ(passes(10s), (Lines{"10000ms 585#8000210000000405"}));
  EXPECT_EQ(domain.cancelled, 1);

  says("605#2000210000000000");
  says("605#2000210000000000");
  EXPECT_EQ(domain.cancelled, 2);
  EXPECT_EQ(domain.writes, 3);

  says("000#8105");
  EXPECT_EQ(domain.cancelled, 3);
  EXPECT_EQ(client.download(kDomain, {1}), Outcome{Bytes{1}});
}

TEST_F(SdoDomain, TellsTheApplicationOnceWhenItIsWritten) {
  client.download(kDomain, some_bytes(3000));
  EXPECT_EQ(application.written, (Lines{"2100:00"}));
  client.block_download(kDomain, some_bytes(3000));
  EXPECT_EQ(says("605#2300210001020304"), (Lines{"585#6000210000000000"}));
  EXPECT_EQ(application.written, (Lines{"2100:00", "2100:00", "2100:00"}));

  domain.refuse_end = AbortCode::HardwareError;
  client.download(kDomain, some_bytes(3000));
  EXPECT_EQ(application.written.size(), 3U) << "refused";
}

}  // namespace
