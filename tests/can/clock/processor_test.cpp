#include "can/userbus/processor.hpp"

#include <gtest/gtest.h>

namespace clock_test {
namespace {

cpu_set_t processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  sched_getaffinity(0, sizeof set, &set);
  return set;
}

/// The first one that the thread may run on, and the last one; a machine may have but one.
int first_processor() {
  const cpu_set_t all = processors();
  unsigned first = 0;
  while (!CPU_ISSET(first, &all)) ++first;
  return static_cast<int>(first);
}
int last_processor() {
  const cpu_set_t all = processors();
  unsigned last = CPU_SETSIZE - 1;
  while (!CPU_ISSET(last, &all)) --last;
  return static_cast<int>(last);
}

class Stay : public testing::Test {
 protected:
  void TearDown() override { sched_setaffinity(0, sizeof before, &before); }

  cpu_set_t before = processors();
  userbus::Stay stay;
};

TEST_F(Stay, IsOnOneProcessorUntilItEnds) {
  const int last = last_processor();
  userbus::begin_stay(stay, last);
  cpu_set_t there = processors();
  EXPECT_EQ(CPU_COUNT(&there), 1);
  EXPECT_EQ(sched_getcpu(), last);

  userbus::end_stay(stay);
  there = processors();
  EXPECT_TRUE(CPU_EQUAL(&there, &before));
}

TEST_F(Stay, LeavesWhatOthersHaveSetMeanwhile) {
  const int first = first_processor();
  userbus::begin_stay(stay, last_processor());
  cpu_set_t wanted;
  CPU_ZERO(&wanted);
  CPU_SET(static_cast<unsigned>(first), &wanted);
  sched_setaffinity(0, sizeof wanted, &wanted);

  userbus::end_stay(stay);
  const cpu_set_t there = processors();
  EXPECT_TRUE(CPU_EQUAL(&there, &wanted));
}

TEST_F(Stay, IsOneWhereItBegan) {
  userbus::begin_stay(stay, last_processor());
  userbus::begin_stay(stay, first_processor());
  EXPECT_EQ(sched_getcpu(), last_processor());
  userbus::end_stay(stay);
  const cpu_set_t there = processors();
  EXPECT_TRUE(CPU_EQUAL(&there, &before));
}

TEST_F(Stay, DoesNotGoWhereTheThreadMayNot) {
  const int last = last_processor();
  cpu_set_t given = before;
  CPU_CLR(static_cast<unsigned>(last), &given);
  if (CPU_COUNT(&given) > 0) sched_setaffinity(0, sizeof given, &given);
  const cpu_set_t had = processors();
  userbus::begin_stay(stay, last);
  const cpu_set_t there = processors();
  EXPECT_TRUE(CPU_EQUAL(&there, &had));
}

TEST_F(Stay, IsNowhereTheThreadMayNotRun) {
  for (const int processor : {-1, CPU_SETSIZE}) {
    userbus::begin_stay(stay, processor);
    const cpu_set_t there = processors();
    EXPECT_TRUE(CPU_EQUAL(&there, &before)) << processor;
    userbus::end_stay(stay);
  }
}

}  // namespace
}  // namespace clock_test
