#pragma once

namespace swathplan {

/// Tells the allocator to keep freed memory for the next use instead of handing it back to the
/// system: planners score and mesh over and over, and taking pages anew costs more than filling
/// them (ten times as long for a skeleton over 100,000 faces on a virtual machine). To be called
/// once, at the start of a program; does nothing where the C library is not glibc.
void keep_freed_memory();

}  // namespace swathplan
