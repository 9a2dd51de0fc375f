/* What failing_calls.c and spared_calls.c share. */
#ifndef TESTS_SUPPORT_SPARED_CALLS_H
#define TESTS_SUPPORT_SPARED_CALLS_H

/* How many spared functions this thread is in: while there is one, no call fails and none is counted. */
extern _Thread_local int spared __attribute__((visibility("hidden")));

#endif
