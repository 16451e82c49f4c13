// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_TEST_ALLOCATION_HOOKS_HPP
#define GMLPNP_TEST_ALLOCATION_HOOKS_HPP

#include <cstddef>
#include <vector>

// The program's own malloc and its kin, in front of glibc's for the whole process, shared libraries included: operator
// new and cv::fastMalloc end in them.

namespace allocation {

/** False under a sanitizer or without glibc: the allocator is not ours to stand in for. */
bool counted();

/** Allocations so far, failed ones included. */
long made();

/** Blocks that were allocated and not yet freed. */
long live();

/** The allocation this many from now fails (1: the next), and with `onwards` all after it; 0: none fails. */
void failAfter(long count, bool onwards = false);

/** Whether one has failed since failAfter(). */
bool failed();

/** A failure, and the block that its thread had got right before and since failAfter(). */
struct Failure
{
    size_t size;     //!< that was asked for, bytes
    bool keptBlock;  //!< whether there was such a block, is still there and was not that of an earlier failure
};

/** Those since failAfter(), as many as are kept. */
std::vector<Failure> failures();

}  // namespace allocation

#endif  // GMLPNP_TEST_ALLOCATION_HOOKS_HPP
