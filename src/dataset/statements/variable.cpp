// SPDX-License-Identifier: Apache-2.0
#include "dataset/statements/connection_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {

StatementKind describeVariable() {
    using S = VariableStatement;
    static const FieldTable<S> fields = {field({"IC", ArgumentKind::Real, ExactOnly}, &S::ic),
                                         field(functionRule(), &S::function)};
    return makeKind("VARIABLE", 3, fields, &Dataset::variables);
}

}  // namespace jprim
