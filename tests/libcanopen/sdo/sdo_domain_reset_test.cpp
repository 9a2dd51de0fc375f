#include "libcanopen/od/domain_owner.hpp"
#include "tests/libcanopen/fixture/node_fixture.hpp"
#include "tests/libcanopen/fixture/sdo_table.hpp"

namespace {

/// Resets its node as soon as it has got data, or all of them.
class Firmware final : public canopen::DomainOwner {
 public:
  enum class When { Write, End };
  Firmware(canopen::Node& node, canopen::TimePoint now, When when) : node_{node}, now_{now}, when_{when} {}
  canopen::Result<void> begin_write(const canopen::Entry&, std::optional<std::uint32_t>) noexcept override {
    return {};
  }
  canopen::Result<void> write(const canopen::Entry&, std::uint64_t,
                              std::span<const std::uint8_t>) noexcept override {
    if (when_ == When::Write) node_.command(canopen::NmtCommand::ResetNode, now_);
    return {};
  }
  canopen::Result<void> end_write(const canopen::Entry&, std::uint64_t) noexcept override {
    ++ended;
    if (when_ == When::End) node_.command(canopen::NmtCommand::ResetNode, now_);
    return {};
  }
  void cancel_write(const canopen::Entry&) noexcept override { ++cancelled; }
  int ended = 0, cancelled = 0;

 private:
  canopen::Node& node_;
  canopen::TimePoint now_;
  When when_;
};

class SdoDomainThatResets : public NodeTest {
 protected:
  SdoDomainThatResets() : NodeTest{{.extended_identifiers = false}, sdo_table()} { start(); }
};

TEST_F(SdoDomainThatResets, HasItsDataIfItWaitsForTheirEnd) {
  Firmware firmware{*node, now, Firmware::When::End};
  dictionary.own_domain(0x2100, 0, firmware);

  says("605#2000210000000000");
  EXPECT_EQ(says("605#0D01000000000000"), (Lines{"705#00", "585#2000000000000000"}));
  EXPECT_EQ(says("605#2F00210001000000"), (Lines{"705#00", "585#6000210000000000"}));  // in one frame too

  EXPECT_EQ(firmware.ended, 2);
  EXPECT_EQ(firmware.cancelled, 0);
}

TEST_F(SdoDomainThatResets, EndsItsTransferIfItDoesNotWait) {
  Firmware firmware{*node, now, Firmware::When::Write};
  dictionary.own_domain(0x2100, 0, firmware);

  says("605#2000210000000000");
  EXPECT_EQ(says("605#0D01000000000000"), (Lines{"705#00", "585#8000210022000008"}));
  EXPECT_EQ(firmware.cancelled, 1);
  EXPECT_EQ(firmware.ended, 0);
}

}  // namespace
