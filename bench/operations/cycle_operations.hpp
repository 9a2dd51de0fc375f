#pragma once

#include <vector>

#include "bench/operations/operation.hpp"

namespace bench {

/// Whole process-data cycles of a unit with eight axes and as many PDOs as it can have.
std::vector<OperationRow> cycle_operations();

}  // namespace bench
