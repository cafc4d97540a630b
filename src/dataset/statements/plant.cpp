// SPDX-License-Identifier: Apache-2.0
// PINPUT and POUTPUT: lists of VARIABLEs that functions read by PINVAL and POUVAL.
#include "base/format.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using S = PlantStatement;

const FieldTable<S>& getFields() {
    static const FieldTable<S> fields = {
        field(ArgumentRule("VARIABLES", ArgumentKind::Variable).of(1, NoLimit).required(), &S::variables)};
    return fields;
}

void warn(StatementReader& reader, const char* what, const char* function) {
    reader.addWarning(0, fmt::format("{} is connected to nothing: the {} that it lists for LINEAR and for "
                                     "control systems outside are read by functions alone, as {}",
                                     reader.getName(), what, function));
}

}  // namespace

StatementKind describePinput() {
    return makeKind<S>("PINPUT", 2, getFields(), &Dataset::plantInputs,
                       [](StatementReader& reader, S&) { warn(reader, "inputs", "PINVAL"); });
}

StatementKind describePoutput() {
    return makeKind<S>("POUTPUT", 3, getFields(), &Dataset::plantOutputs,
                       [](StatementReader& reader, S&) { warn(reader, "outputs", "POUVAL"); });
}

}  // namespace jprim
