#pragma once

#include "can/port/address.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {

/// Is @p slave as node @p node_id, 1..127, on the bus at @p address until SIGTERM or SIGINT; says on standard
/// error when it is there. A bus that goes down is waited for; the slave boots when it is back. Throws
/// bus::OpenError if the bus is not there or down at first.
void serve(const WrongSlave& slave, const bus::Address& address, std::uint8_t node_id);

}  // namespace zoo
