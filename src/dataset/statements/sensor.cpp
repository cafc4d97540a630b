// SPDX-License-Identifier: Apache-2.0
// SENSOR: an event.
#include "base/format.h"
#include "dataset/statements/connection_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = SensorStatement;

const SpellingTable<SensorComparison>& getComparisons() {
    using C = SensorComparison;
    static const SpellingTable<C> comparisons = {
        {C::Equal, "EQ", ExactOnly}, {C::GreaterOrEqual, "GE", ExactOnly}, {C::LessOrEqual, "LE", ExactOnly}};
    return comparisons;
}

constexpr const char* WithoutEffect[] = {"PRINT", "RESTART", "CODGEN", "YYDUMP", "BISECTION"};

const FieldTable<S>& getFields() {
    static const FieldTable<S> fields = {choice(getComparisons(), &S::comparison),
                                         field(ArgumentRule("VALUE", Kind::Angle).required(), &S::value),
                                         field({"ERROR", Kind::Real, 2}, &S::error),
                                         field({"HALT", Kind::Flag}, &S::halt),
                                         field({"RETURN", Kind::Flag, 3}, &S::endsCommand),
                                         field(functionRule(), &S::function),
                                         field({"EVALUATE", Kind::Expression, 2}, &S::evaluate),
                                         ArgumentRule("PRINT", Kind::Flag),
                                         ArgumentRule("RESTART", Kind::Flag, 3),
                                         ArgumentRule("CODGEN", Kind::Flag),
                                         ArgumentRule("YYDUMP", Kind::Flag),
                                         ArgumentRule("BISECTION", Kind::Flag),
                                         ArgumentRule("ANGULAR", Kind::Unsupported),
                                         ArgumentRule("DT", Kind::Unsupported, ExactOnly),
                                         ArgumentRule("STEPSIZE", Kind::Unsupported)};
    return fields;
}

void check(StatementReader& reader, S& sensor) {
    if (sensor.error < 0)
        reader.addError(reader.getOffset("ERROR"), fmt::format("ERROR of {} is {}; it cannot be negative",
                                                               reader.getName(), sensor.error));
    for (const char* name : WithoutEffect)
        if (reader.has(name))
            reader.addWarning(reader.getOffset(name),
                              fmt::format("{} of {} has no effect", name, reader.getName()));
    if (!sensor.halt && !sensor.endsCommand && !sensor.evaluate)
        reader.addWarning(0,
                          fmt::format("{} has no effect without HALT, RETURN or EVALUATE", reader.getName()));
}

}  // namespace

StatementKind describeSensor() {
    return makeKind("SENSOR", 2, getFields(), &Dataset::sensors, check);
}

const char* getAdamsName(SensorComparison comparison) {
    return getComparisons().getName(comparison).data();
}

}  // namespace jprim
