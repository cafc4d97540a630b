// SPDX-License-Identifier: Apache-2.0
// TFSISO: a transfer function.
#include "base/format.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = TfsisoStatement;

constexpr std::size_t MostCoefficients = 30;

const FieldTable<S>& getFields() {
    const auto array = [](std::string_view name) {
        return ArgumentRule(name, Kind::Array, ExactOnly).required();
    };
    const auto coefficients = [](std::string_view name) {
        return ArgumentRule(name, Kind::Real, 3).of(1, NoLimit).required();
    };
    static const FieldTable<S> fields = {field(array("X"), &S::x),
                                         field(array("U"), &S::u),
                                         field(array("Y"), &S::y),
                                         field(coefficients("NUMERATOR"), &S::numerator),
                                         field(coefficients("DENOMINATOR"), &S::denominator),
                                         field({"STATIC_HOLD", Kind::Flag}, &S::staticHold)};
    return fields;
}

void check(StatementReader& reader, S& transfer) {
    const std::size_t above = transfer.numerator.size(), below = transfer.denominator.size();
    if (below > MostCoefficients)
        reader.addError(reader.getOffset("DENOMINATOR"),
                        fmt::format("DENOMINATOR of {} takes at most {} numbers, not {}", reader.getName(),
                                    MostCoefficients, below));
    if (below < 2)
        reader.addError(reader.getOffset("DENOMINATOR"),
                        fmt::format("DENOMINATOR of {} is a constant; a factor needs no transfer function",
                                    reader.getName()));
    if (above > below)
        reader.addError(
            reader.getOffset("NUMERATOR"),
            fmt::format("NUMERATOR of {} has {} coefficients; it takes no more than DENOMINATOR, {}",
                        reader.getName(), above, below));
    if (transfer.denominator.back() == 0)
        reader.addError(
            reader.getOffset("DENOMINATOR"),
            fmt::format("the last coefficient of DENOMINATOR of {}, that of the highest power, is 0; "
                        "leave it out",
                        reader.getName()));
}

}  // namespace

StatementKind describeTfsiso() {
    return makeKind("TFSISO", 2, getFields(), &Dataset::tfsisos, check);
}

}  // namespace jprim
