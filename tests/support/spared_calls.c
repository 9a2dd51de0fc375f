/* Functions of libraries in which no call fails: no program that uses them can help what comes of that. */
#define _GNU_SOURCE
#include "tests/support/spared_calls.h"

#include <dlfcn.h>
#include <stdint.h>

/* In these, libnats 3.4 ends the program if it gets no memory, or waits for itself for ever: natsMutex_Create()
   for the lock of the library, whose failure it tells by opening itself again, or of a connection, which
   natsConn_release() locks; natsStrHash_Create() for an object of JSON, which nats_JSONDestroy() walks through;
   natsHash_Set() for a subscription, which is freed and then delivered to; natsLib_msgDeliveryAssignWorker() for a
   worker, whose members are destroyed; js_GetLastMsg() for its options and its subject, without which it destroys
   a buffer that it has not begun; nats_doNotUpdateErrStack() for the state of a thread, without which it counts
   wrongly. */
#define SPARED(name, parameters, ...)                                             \
  int name parameters {                                                           \
    ++spared;                                                                     \
    const int status = ((int(*) parameters)dlsym(RTLD_NEXT, #name))(__VA_ARGS__); \
    --spared;                                                                     \
    return status;                                                                \
  }
SPARED(natsMutex_Create, (void** mutex), mutex)
SPARED(natsStrHash_Create, (void** hash, int size), hash, size)
SPARED(natsHash_Set, (void* hash, int64_t key, void* value, void** before), hash, key, value, before)
SPARED(natsLib_msgDeliveryAssignWorker, (void* subscription), subscription)
SPARED(js_GetLastMsg,
       (void** message, void* js, const char* stream, const char* subject, void* options, int* code), message, js,
       stream, subject, options, code)
void nats_doNotUpdateErrStack(_Bool on) {
  ++spared;
  ((void (*)(_Bool))dlsym(RTLD_NEXT, "nats_doNotUpdateErrStack"))(on);
  --spared;
}
