// SPDX-License-Identifier: Apache-2.0
#include "dataset/statements/connection_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

const SpellingTable<JprimType>& getTypes() {
    using T = JprimType;
    static const SpellingTable<T> types = {{T::AtPoint, "ATPOINT"},
                                           {T::InLine, "INLINE", 3},
                                           {T::InPlane, "INPLANE", 3},
                                           {T::Orientation, "ORIENTATION"},
                                           {T::ParallelAxes, "PARALLEL_AXES", 2},
                                           {T::Perpendicular, "PERPENDICULAR", 2}};
    return types;
}

}  // namespace

StatementKind describeJprim() {
    using S = JprimStatement;
    static const FieldTable<S> fields = {choice(getTypes(), &S::type, true), endMarkers<S>()};
    return makeKind("JPRIM", 2, fields, &Dataset::jprims);
}

const char* getAdamsName(JprimType type) {
    return getTypes().getName(type).data();
}

}  // namespace jprim
