// SPDX-License-Identifier: Apache-2.0
// ARRAY: constants, or the inputs, states or outputs of an LSE or TFSISO.
#include "base/format.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = ArrayStatement;

const SpellingTable<ArrayType>& getTypes() {
    using T = ArrayType;
    static const SpellingTable<T> types = {{T::Constants, "IC", ExactOnly},
                                           {T::Inputs, "U", ExactOnly},
                                           {T::States, "X", ExactOnly},
                                           {T::Outputs, "Y", ExactOnly}};
    return types;
}

// The type is written always.
std::vector<Field<S>> typeFields() {
    std::vector<Field<S>> fields = choice(getTypes(), &S::type);
    fields.front().write = [](StatementWriter& writer, const S& s) {
        writer.add(getTypes().getName(s.type));
    };
    return fields;
}

const FieldTable<S>& getFields() {
    static const FieldTable<S> fields = {
        typeFields(), field({"SIZE", Kind::Count}, &S::size),
        field(ArgumentRule("NUMBERS", Kind::Real).of(1, NoLimit), &S::numbers),
        field(ArgumentRule("VARIABLES", Kind::Variable).of(1, NoLimit), &S::variables)};
    return fields;
}

void check(StatementReader& reader, S& array) {
    constexpr int Largest = 1000000;
    const bool isConstant = array.type == ArrayType::Constants, isInput = array.type == ArrayType::Inputs;
    reader.checkAllowed("NUMBERS", isConstant, "an IC");
    reader.checkAllowed("VARIABLES", isInput, "a U");
    reader.checkNeeded("VARIABLES", isInput);
    if (isConstant && array.numbers.empty() && array.size == 0)
        reader.addError(0, reader.getName() + " needs NUMBERS or SIZE");
    const std::size_t given = isInput ? array.variables.size() : array.numbers.size();
    if (array.size > Largest)
        reader.addError(reader.getOffset("SIZE"), fmt::format("SIZE of {} is {}; the largest is {}",
                                                              reader.getName(), array.size, Largest));
    else if (array.size != 0 && given != 0 && given != std::size_t(array.size))
        reader.addError(reader.getOffset("SIZE"),
                        fmt::format("SIZE of {} is {}, but {} {} are given", reader.getName(), array.size,
                                    given, isInput ? "VARIABLES" : "NUMBERS"));
}

}  // namespace

StatementKind describeArray() {
    return makeKind("ARRAY", 2, getFields(), &Dataset::arrays, check);
}

}  // namespace jprim
