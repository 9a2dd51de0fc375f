#pragma once

#include <iosfwd>

#include "can/hub/server.hpp"
#include "tools/canhub/options.hpp"

namespace canhub {

/// Does what @p options ask of the faults of a bus that is served: injects, takes back, lists, in this order. What
/// is told goes to @p out, what is wrong to @p errors; the exit status.
int command_faults(const Options& options, std::ostream& out, std::ostream& errors);

/// Loads the faults with which @p options have @p server begin; UsageError names the one that is wrong.
void load_faults(hub::Server& server, const Options& options);

}  // namespace canhub
