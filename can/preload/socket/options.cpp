#include "can/preload/socket/options.hpp"

#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <sys/socket.h>

namespace preload {

namespace {

using userbus::OptionName;

constexpr RawOption kRawOptions[] = {
    {CAN_RAW_ERR_FILTER, OptionName::ErrorFilter, CAN_ERR_MASK}, {CAN_RAW_LOOPBACK, OptionName::Loopback, 0},
    {CAN_RAW_RECV_OWN_MSGS, OptionName::OwnMessages, 0},         {CAN_RAW_FD_FRAMES, OptionName::FdFrames, 0},
    {CAN_RAW_JOIN_FILTERS, OptionName::JoinFilters, 0},
};

struct SocketOptionNumber {
  int number;
  SocketOption option;
};

constexpr SocketOptionNumber kSocketOptions[] = {
    {SO_DOMAIN, SocketOption::Domain},
    {SO_TYPE, SocketOption::Type},
    {SO_ERROR, SocketOption::Error},
    {SO_TIMESTAMP_OLD, SocketOption::SingleStamp},
    {SO_TIMESTAMPNS_OLD, SocketOption::SingleStamp},
    {SO_TIMESTAMP_NEW, SocketOption::SingleStamp},
    {SO_TIMESTAMPNS_NEW, SocketOption::SingleStamp},
    {SO_TIMESTAMPING_OLD, SocketOption::Stamping},
    {SO_TIMESTAMPING_NEW, SocketOption::Stamping},
    {SO_RXQ_OVFL, SocketOption::CountDropped},
};

}  // namespace

const RawOption* raw_option(int number) noexcept {
  for (const RawOption& option : kRawOptions)
    if (option.number == number) return &option;
  return nullptr;
}

SocketOption socket_option(int number) noexcept {
  for (const SocketOptionNumber& row : kSocketOptions)
    if (row.number == number) return row.option;
  return SocketOption::Other;
}

}  // namespace preload
