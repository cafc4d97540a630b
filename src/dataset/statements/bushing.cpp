// SPDX-License-Identifier: Apache-2.0
#include "dataset/statements/connection_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

constexpr ArgumentRule triple(std::string_view name, std::size_t minimum) {
    return ArgumentRule(name, ArgumentKind::Real, minimum).of(3);
}

}  // namespace

StatementKind describeBushing() {
    using S = BushingStatement;
    static const FieldTable<S> fields = {endMarkers<S>(),
                                         field(triple("K", ExactOnly), &S::k),
                                         field(triple("C", ExactOnly), &S::c),
                                         field(triple("KT", ExactOnly), &S::kt),
                                         field(triple("CT", ExactOnly), &S::ct),
                                         field(triple("FORCE", 1), &S::force),
                                         field(triple("TORQUE", 1), &S::torque)};
    return makeKind("BUSHING", 2, fields, &Dataset::bushings);
}

}  // namespace jprim
