// SPDX-License-Identifier: Apache-2.0
#include "dataset/statements/connection_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using S = SforceStatement;

const FieldTable<S>& getFields() {
    static const SpellingTable<bool> rotational = {{false, "TRANSLATIONAL", 2}, {true, "ROTATIONAL", 3}};
    static const FieldTable<S> fields = {choice(rotational, &S::rotational, true), endMarkers<S>(),
                                         field({"ACTIONONLY", ArgumentKind::Flag}, &S::actionOnly),
                                         field(functionRule(), &S::function)};
    return fields;
}

// Without a reaction J only says which way, and a force may turn with the body that it acts on.
void check(StatementReader& reader, S& force) {
    if (force.actionOnly) reader.allowAnyOwner();
}

}  // namespace

StatementKind describeSforce() {
    return makeKind("SFORCE", 2, getFields(), &Dataset::sforces, check);
}

}  // namespace jprim
