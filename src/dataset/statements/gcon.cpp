// SPDX-License-Identifier: Apache-2.0
#include "dataset/statements/connection_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {

StatementKind describeGcon() {
    using S = GconStatement;
    static const FieldTable<S> fields = {field({"I", ArgumentKind::MarkerOrZero, ExactOnly}, &S::i),
                                         field(functionRule(), &S::function)};
    return makeKind("GCON", 2, fields, &Dataset::gcons);
}

}  // namespace jprim
