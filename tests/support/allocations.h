// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_ALLOCATIONS_H_
#define JPRIM_TESTS_SUPPORT_ALLOCATIONS_H_

namespace jprim::testing {

/// How often the whole of this program, libraries included, has asked operator new for memory so far.
int getNumAllocations();

}  // namespace jprim::testing

#endif
