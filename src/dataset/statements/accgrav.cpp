// SPDX-License-Identifier: Apache-2.0
#include "dataset/statements/statements.h"

namespace jprim {

StatementKind describeAccgrav() {
    using S = AccgravStatement;
    static const FieldTable<S> fields = {field({"IGRAV", ArgumentKind::Real}, element(&S::acceleration, 0)),
                                         field({"JGRAV", ArgumentKind::Real}, element(&S::acceleration, 1)),
                                         field({"KGRAV", ArgumentKind::Real}, element(&S::acceleration, 2))};
    return makeSingleKind("ACCGRAV", 3, fields, &Dataset::gravity);
}

}  // namespace jprim
