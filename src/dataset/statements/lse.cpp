// SPDX-License-Identifier: Apache-2.0
// LSE: a linear system by its matrices; GSE, which would be one by compiled code.
#include "base/format.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = LseStatement;

Field<S> array(std::string_view name, int S::*member, bool isRequired = false) {
    const ArgumentRule rule(name, Kind::Array, ExactOnly);
    return field(isRequired ? rule.required() : rule, member);
}

Field<S> matrix(std::string_view name, int S::*member, bool isRequired = false) {
    const ArgumentRule rule(name, Kind::Matrix, ExactOnly);
    return field(isRequired ? rule.required() : rule, member);
}

const FieldTable<S>& getFields() {
    static const FieldTable<S> fields = {array("X", &S::x, true),
                                         array("U", &S::u),
                                         array("Y", &S::y),
                                         array("IC", &S::ic),
                                         matrix("A", &S::a, true),
                                         matrix("B", &S::b),
                                         matrix("C", &S::c),
                                         matrix("D", &S::d),
                                         field({"STATIC_HOLD", Kind::Flag}, &S::staticHold)};
    return fields;
}

void check(StatementReader& reader, S& lse) {
    reader.checkNeeded("U", lse.b != 0 || lse.d != 0);
    reader.checkNeeded("Y", lse.c != 0 || lse.d != 0);
    const auto warn = [&](const char* name, const char* needed) {
        reader.addWarning(reader.getOffset(name),
                          fmt::format("{} of {} has no effect without {}", name, reader.getName(), needed));
    };
    if (lse.u != 0 && lse.b == 0 && lse.d == 0) warn("U", "B or D");
    if (lse.y != 0 && lse.c == 0 && lse.d == 0)
        reader.addError(reader.getOffset("Y"), fmt::format("Y of {} needs C or D", reader.getName()));
}

void refuse(StatementReader& reader) {
    reader.registerId();
    reader.addError(
        0, fmt::format("{} cannot be run: its equations are compiled code; write it as LSE or TFSISO",
                       reader.getName()));
}

}  // namespace

StatementKind describeLse() {
    return makeKind("LSE", 3, getFields(), &Dataset::lses, check);
}

StatementKind describeGse() {
    return {"GSE", 2, true, false, refuse, {}, {}};
}

}  // namespace jprim
