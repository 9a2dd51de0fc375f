#pragma once

#include "libcanopen/base/cob_id.hpp"

namespace canopen {

/// Frames that a node must receive: those of one identifier, either data frames or remote frames.
struct Subscription {
  Identifier identifier = 0;  ///< with cob_id::kExtended if it is 29 bits long
  bool remote = false;

  friend constexpr bool operator==(const Subscription&, const Subscription&) = default;
};

}  // namespace canopen
