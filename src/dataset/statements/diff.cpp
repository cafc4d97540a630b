// SPDX-License-Identifier: Apache-2.0
#include "dataset/statements/connection_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {

StatementKind describeDiff() {
    using Kind = ArgumentKind;
    using S = DiffStatement;
    static const FieldTable<S> fields = {
        field({"IMPLICIT", Kind::Flag, 2}, &S::implicit), field({"STATIC_HOLD", Kind::Flag}, &S::staticHold),
        field(ArgumentRule("IC", Kind::Real, ExactOnly).of(1, 2), &S::ic),
        ArgumentRule("DYNAMIC_HOLD", Kind::Unsupported), field(functionRule(), &S::function)};
    return makeKind("DIFF", 3, fields, &Dataset::diffs);
}

}  // namespace jprim
