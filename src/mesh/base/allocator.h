#pragma once

namespace swathplan {

/// Tells the allocator to keep freed memory for later use and not to give it back to the system.
/// Planners score and mesh over and over. Taking new pages costs them more than filling these: a
/// skeleton over 100,000 faces took ten times as long on a virtual machine. Call it once, at the
/// start of a program. It does nothing where the C library is not glibc.
void keep_freed_memory();

}  // namespace swathplan
