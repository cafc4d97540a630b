// SPDX-License-Identifier: Apache-2.0
// VARIABLE, SPLINE and SENSOR: data for functions, and events.
#include <utility>

#include "base/format.h"
#include "dataset/connection_arguments.h"
#include "dataset/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using V = ArgumentValue;

const ArgumentTable<VariableStatement>& getVariableTable() {
    using S = VariableStatement;
    static const ArgumentTable<S> table = {
        {functionRule(), setFunction<S>},
        {{"IC", Kind::Real, ExactOnly}, [](S& s, const V& v) { s.ic = v.getNumber(); }}};
    return table;
}

// A SPLINE's lists as given; they are understood when all are known.
struct SplineArguments : SplineStatement {
    V xs;
    std::vector<V> ys;  ///< for each curve its y at each x, or z and then these
};

const ArgumentTable<SplineArguments>& getSplineTable() {
    using S = SplineArguments;
    constexpr std::size_t LeastPoints = 4;
    static const ArgumentTable<S> table = {
        {ArgumentRule("X", Kind::Real, ExactOnly).of(LeastPoints, NoLimit).required(),
         [](S& s, const V& v) { s.xs = v; }},
        {ArgumentRule("Y", Kind::Real, ExactOnly).of(LeastPoints, NoLimit).required().repeated(),
         [](S& s, const V& v) { s.ys.push_back(v); }},
        {{"LINEAR_EXTRAPOLATE", Kind::Flag}, [](S& s, const V&) { s.linearExtrapolate = true; }},
        {{"FILE", Kind::Unsupported, 2}, nullptr},
        {{"CHANNEL", Kind::Unsupported}, nullptr},
        {{"BLOCK", Kind::Unsupported}, nullptr},
        {{"FUNCTION", Kind::Subroutine, 2}, nullptr}};
    return table;
}

void checkIncreasing(StatementReader& reader, const char* name, double before, double value,
                     std::size_t offset) {
    if (!(value > before))
        reader.addError(offset, fmt::format("{} of {} must increase, but {} follows {}", name,
                                            reader.getName(), value, before));
}

void checkX(StatementReader& reader, const V& xs) {
    for (std::size_t k = 1; k < xs.numbers.size() && !reader.hasErrors(); ++k)
        checkIncreasing(reader, "X", xs.numbers[k - 1], xs.numbers[k], xs.offsets[k]);
}

// One list with as many numbers as x is the only curve. In a family z stands before the numbers of each.
void understandCurves(StatementReader& reader, SplineArguments& spline) {
    const std::size_t points = spline.x.size();
    const bool single = spline.ys.size() == 1 && spline.ys[0].numbers.size() == points;
    for (const V& given : spline.ys) {
        const std::size_t count = given.numbers.size();
        if (!single && count != points + 1) {
            reader.addError(
                given.offset,
                fmt::format("Y of {} takes {} numbers, one for each X, or in a family {}, z before "
                            "them, not {}",
                            reader.getName(), points, points + 1, count));
            continue;
        }
        const double z = single ? 0 : given.getNumber();
        if (!spline.curves.empty()) checkIncreasing(reader, "z", spline.curves.back().first, z, given.offset);
        spline.curves.emplace_back(
            z, std::vector<double>(given.numbers.begin() + (single ? 0 : 1), given.numbers.end()));
    }
}

constexpr const char* WithoutEffect[] = {"PRINT", "RESTART", "CODGEN", "YYDUMP", "BISECTION"};

const ArgumentTable<SensorStatement>& getSensorTable() {
    using S = SensorStatement;
    // These rows come first, in the order of SensorComparison.
    const auto setComparison = [](S& s, const V& v) { s.comparison = static_cast<SensorComparison>(v.row); };
    static const ArgumentTable<S> table = {
        {{"EQ", Kind::Choice, ExactOnly}, setComparison},
        {{"GE", Kind::Choice, ExactOnly}, setComparison},
        {{"LE", Kind::Choice, ExactOnly}, setComparison},
        {functionRule(), setFunction<S>},
        {ArgumentRule("VALUE", Kind::Angle).required(), [](S& s, const V& v) { s.value = v.getNumber(); }},
        {{"ERROR", Kind::Real, 2}, [](S& s, const V& v) { s.error = v.getNumber(); }},
        {{"HALT", Kind::Flag}, [](S& s, const V&) { s.halt = true; }},
        {{"RETURN", Kind::Flag, 3}, [](S& s, const V&) { s.endsCommand = true; }},
        {{"PRINT", Kind::Flag}, nullptr},
        {{"RESTART", Kind::Flag, 3}, nullptr},
        {{"CODGEN", Kind::Flag}, nullptr},
        {{"YYDUMP", Kind::Flag}, nullptr},
        {{"BISECTION", Kind::Flag}, nullptr},
        {{"ANGULAR", Kind::Unsupported}, nullptr},
        {{"DT", Kind::Unsupported, ExactOnly}, nullptr},
        {{"STEPSIZE", Kind::Unsupported}, nullptr},
        {{"EVALUATE", Kind::Unsupported, 2}, nullptr}};
    return table;
}

void checkSensor(StatementReader& reader, const SensorStatement& sensor) {
    if (sensor.error < 0)
        reader.addError(reader.getOffset("ERROR"), fmt::format("ERROR of {} is {}; it cannot be negative",
                                                               reader.getName(), sensor.error));
    for (const char* name : WithoutEffect)
        if (reader.has(name))
            reader.addWarning(reader.getOffset(name),
                              fmt::format("{} of {} has no effect", name, reader.getName()));
    if (!sensor.halt && !sensor.endsCommand)
        reader.addWarning(0, fmt::format("{} has no effect without HALT or RETURN", reader.getName()));
}

}  // namespace

void readVariable(StatementReader& reader) {
    VariableStatement variable;
    if (reader.readStatement(getVariableTable(), variable))
        reader.updState().dataset.variables.push_back(std::move(variable));
}

void readSpline(StatementReader& reader) {
    SplineArguments spline;
    if (!reader.readStatement(getSplineTable(), spline)) return;
    checkX(reader, spline.xs);
    spline.x = std::move(spline.xs.numbers);
    understandCurves(reader, spline);
    if (!reader.hasErrors()) reader.updState().dataset.splines.push_back(std::move(spline));
}

void readSensor(StatementReader& reader) {
    SensorStatement sensor;
    if (reader.readStatement(getSensorTable(), sensor)) checkSensor(reader, sensor);
    if (!reader.hasErrors()) reader.updState().dataset.sensors.push_back(std::move(sensor));
}

}  // namespace jprim
