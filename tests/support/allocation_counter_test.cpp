#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/fakes/child_process.hpp"
#include "tests/fakes/temporary_directory.hpp"
#include "tests/support/allocation_counts.hpp"

namespace support {
namespace {

constexpr int kCalls = 1000;

/// The calls that allocating_program makes when it allocates in the way @p form.
AllocationCounts::Calls calls_of(const std::string& form) {
  const fakes::TemporaryDirectory folder;
  const AllocationCounts counts{folder.path("counts"), ALLOCATION_COUNTER};
  const auto environment = counts.environment();
  const auto finished = fakes::run_program({ALLOCATING_PROGRAM, form, std::to_string(kCalls)},
                                           {environment.begin(), environment.end()});
  EXPECT_EQ(finished.status, 0) << finished.errors;
  return counts.calls();
}

/// A way to allocate, and the function in which it is counted.
struct Form {
  const char* name;
  allocation_form counted;
};
/// How GoogleTest names a case.
void PrintTo(const Form& c, std::ostream* out) {  // NOLINT(readability-identifier-naming): GoogleTest's name
  *out << c.name;
}

struct AllocationCounter : testing::TestWithParam<Form> {};

TEST_P(AllocationCounter, CountsEveryCall) {
  const auto idle = calls_of("nothing");

  const auto busy = calls_of(GetParam().name);

  for (std::size_t form = 0; form < busy.size(); ++form) {
    EXPECT_EQ(busy[form] - idle[form], form == GetParam().counted ? kCalls : 0) << "form " << form;
  }
}

INSTANTIATE_TEST_SUITE_P(OfEachForm, AllocationCounter,
                         testing::Values(Form{"malloc", ALLOCATION_MALLOC}, Form{"calloc", ALLOCATION_CALLOC},
                                         Form{"realloc", ALLOCATION_REALLOC},
                                         Form{"reallocarray", ALLOCATION_REALLOCARRAY},
                                         Form{"aligned_alloc", ALLOCATION_ALIGNED_ALLOC},
                                         Form{"posix_memalign", ALLOCATION_POSIX_MEMALIGN},
                                         Form{"memalign", ALLOCATION_MEMALIGN}, Form{"new", ALLOCATION_MALLOC},
                                         Form{"aligned new", ALLOCATION_ALIGNED_ALLOC}),
                         [](const auto& parameter) {
                           std::string name = parameter.param.name;
                           std::erase(name, ' ');
                           return name;
                         });

}  // namespace
}  // namespace support
