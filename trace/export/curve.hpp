#pragma once

#include <cstddef>
#include <string>

#include "trace/export/result.hpp"
#include "trace/export/scale.hpp"

namespace trace {

/// Signal @p signal of @p result as the data of a path: of samples that fall on one column of pixels as many
/// points as can be seen, and a gap where samples are missing.
std::string curve_of(const Result& result, std::size_t signal, const Scale& time, const Scale& values);

/// The usual time between two samples (s); 0 of fewer than two.
double sample_interval(const Result& result);

}  // namespace trace
