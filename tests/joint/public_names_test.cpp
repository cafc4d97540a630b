// SPDX-License-Identifier: Apache-2.0
// Users write both using-directives: then a public type of jprim must not have the name of one of SimTK's.
#include <gtest/gtest.h>
#include <jprim/jprim.h>

#include <set>
#include <string>
#include <tuple>

using namespace SimTK;
using namespace jprim;

namespace {

template <class Type>
struct Named {
    using Itself = Type;
};

// What CMake found in the public headers: each name unqualified, so that one that is ambiguous does not compile.
#define JPRIM_PUBLIC_TYPE(name) Named<name>::Itself*,
using PublicTypes = std::tuple<
#include "public_types.inc"
    void*>;
#undef JPRIM_PUBLIC_TYPE

#define JPRIM_PUBLIC_TYPE(name) #name,
const std::set<std::string> Names = {
#include "public_types.inc"
};
#undef JPRIM_PUBLIC_TYPE

TEST(PublicNames, AreNotAmbiguousBesideSimTK) {
    EXPECT_GT(std::tuple_size_v<PublicTypes>, 90u);
    // A class, a derived one, an enumeration and an alias: the search sees all ways to declare a type.
    for (const char* name : {"Marker", "AtPoint", "PrescribedMotion", "Coordinate", "Diagnostics"})
        EXPECT_TRUE(Names.count(name)) << name;
    EXPECT_FALSE(Names.count("FlexibleNode"));  // only declared
    EXPECT_FALSE(Names.count("Motion"));
    static_assert(std::is_same_v<Motion, SimTK::Motion>, "SimTK's is not hidden either");
}

}  // namespace
