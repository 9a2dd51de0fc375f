#include "can/preload/descriptor.hpp"
#include "can/preload/next.hpp"

namespace {

/// Before the constructors of the program and of its libraries, which may have CAN sockets already.
[[gnu::constructor(101)]] void begin() {
  preload::next();
  preload::look_at_all();
}

}  // namespace
