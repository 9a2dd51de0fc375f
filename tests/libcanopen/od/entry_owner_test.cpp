#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libcanopen/od/dictionary.hpp"
#include "libcanopen/od/entry.hpp"

namespace {

using canopen::AbortCode;
using canopen::Access;
using canopen::Dictionary;
using canopen::Entry;
using canopen::EntryDescription;
using canopen::EntryOwner;
using canopen::OwnerRank;
using canopen::Result;
using Bytes = std::span<const std::uint8_t>;

constexpr std::array kTable{
    EntryDescription{.index = 0x2000, .type = canopen::DataType::Unsigned16, .access = Access::ReadWrite},
    EntryDescription{
        .index = 0x2001, .type = canopen::DataType::VisibleString, .access = Access::ReadWrite, .capacity = 8},
    EntryDescription{.index = 0x2002, .type = canopen::DataType::Domain, .access = Access::ReadWrite},
};

/// Notes what it is asked, and refuses if it is told to.
class Owner final : public EntryOwner {
 public:
  Owner(std::string name, std::vector<std::string>& asked) : name_{std::move(name)}, asked_{asked} {}
  Result<std::int64_t> read(const Entry&, std::int64_t stored) override {
    asked_.push_back(name_);
    return stored + offset;
  }
  Result<void> write(const Entry&, std::int64_t) override { return answer(); }
  Result<Bytes> read_text(const Entry&, Bytes) override { return Bytes{text}; }
  Result<void> write_text(const Entry&, Bytes) override { return answer(); }

  bool refuses = false;
  std::int64_t offset = 0;
  std::array<std::uint8_t, 2> text{'h', 'i'};

 private:
  Result<void> answer() {
    asked_.push_back(name_);
    return refuses ? canopen::refuse(AbortCode::LocalControl) : Result<void>{};
  }
  std::string name_;
  std::vector<std::string>& asked_;
};

class EntryOwners : public testing::Test {
 protected:
  const Entry& entry(std::uint16_t index) const { return *dictionary.lookup(index, 0); }
  std::vector<std::string> asked;
  Owner application{"application", asked};
  Owner service{"service", asked};
  Dictionary dictionary{kTable, 1};
};

TEST_F(EntryOwners, AreAskedBeforeAValueIsStored) {
  dictionary.own_write(0x2000, 0, application);

  EXPECT_TRUE(dictionary.write(entry(0x2000), 7));
  application.refuses = true;
  EXPECT_EQ(dictionary.write(entry(0x2000), 8).error(), AbortCode::LocalControl);

  EXPECT_EQ(dictionary.stored(entry(0x2000)), 7);
}

TEST_F(EntryOwners, HaveToAgreeAndTheServiceIsAskedLast) {
  dictionary.own_write(0x2000, 0, application);
  dictionary.own_write(0x2000, 0, service, OwnerRank::Service);

  EXPECT_TRUE(dictionary.write(entry(0x2000), 1));
  EXPECT_EQ(asked, (std::vector<std::string>{"application", "service"}));

  asked.clear();
  application.refuses = true;
  EXPECT_FALSE(dictionary.write(entry(0x2000), 2));
  EXPECT_EQ(asked, (std::vector<std::string>{"application"})) << "the service acts on what is refused";
}

TEST_F(EntryOwners, AreAskedInTheSameOrderHoweverTheyRegister) {
  dictionary.own_write(0x2000, 0, service, OwnerRank::Service);
  dictionary.own_write(0x2000, 0, application);

  EXPECT_TRUE(dictionary.write(entry(0x2000), 1));

  EXPECT_EQ(asked, (std::vector<std::string>{"application", "service"}));
}

TEST_F(EntryOwners, GiveTheValueThatIsRead) {
  application.offset = 100;
  dictionary.own_read(0x2000, 0, application);
  dictionary.own_read(0x2000, 0, service, OwnerRank::Service);
  dictionary.set(entry(0x2000), 1);

  EXPECT_EQ(dictionary.read(entry(0x2000)), 101);
  EXPECT_EQ(asked, (std::vector<std::string>{"application"}));
}

TEST_F(EntryOwners, GiveAndTakeStrings) {
  dictionary.own_read(0x2001, 0, application);
  dictionary.own_write(0x2001, 0, application);
  const std::array<std::uint8_t, 3> bytes{1, 2, 3};

  EXPECT_TRUE(std::ranges::equal(dictionary.read_text(entry(0x2001)).value(), application.text));
  EXPECT_TRUE(dictionary.write_text(entry(0x2001), bytes));
  EXPECT_TRUE(std::ranges::equal(dictionary.text(entry(0x2001)), bytes));

  application.refuses = true;
  EXPECT_EQ(dictionary.write_text(entry(0x2001), {}).error(), AbortCode::LocalControl);
  EXPECT_TRUE(std::ranges::equal(dictionary.text(entry(0x2001)), bytes));
}

TEST_F(EntryOwners, TakeCommandsThatAreNeverStored) {
  dictionary.set(entry(0x2000), 3);
  dictionary.own_command(0x2000, 0, service, OwnerRank::Service);
  dictionary.own_write(0x2000, 0, application);

  EXPECT_TRUE(dictionary.write(entry(0x2000), 7));
  EXPECT_EQ(asked, (std::vector<std::string>{"application", "service"}));
  EXPECT_EQ(dictionary.read(entry(0x2000)), 3);

  application.refuses = true;
  EXPECT_EQ(dictionary.write(entry(0x2000), 7).error(), AbortCode::LocalControl);
}

TEST_F(EntryOwners, CanOnlyOwnEntriesThatExist) {
  canopen::DomainOwner domain;

  EXPECT_THROW(dictionary.own_read(0x2009, 0, application), std::out_of_range);
  EXPECT_THROW(dictionary.own_write(0x2000, 1, application), std::out_of_range);
  EXPECT_THROW(dictionary.own_command(0x2000, 1, application), std::out_of_range);
  EXPECT_THROW(dictionary.own_command(0x2001, 0, application), std::invalid_argument);
  EXPECT_THROW(dictionary.own_domain(0x2000, 0, domain), std::invalid_argument);
  EXPECT_NO_THROW(dictionary.own_domain(0x2002, 0, domain));
}

}  // namespace
