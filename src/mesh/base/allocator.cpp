#include "mesh/base/allocator.h"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace swathplan {

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kAll = 1 << 30;
  constexpr int kStep = 16 << 20;  // bytes by which the heap grows
  mallopt(M_MMAP_MAX, 0);          // large blocks come from the heap too
  mallopt(M_TRIM_THRESHOLD, kAll);
  mallopt(M_TOP_PAD, kStep);
#endif
}

}  // namespace swathplan
