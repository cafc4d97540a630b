// SPDX-License-Identifier: Apache-2.0
// SPLINE: a table of numbers.
#include "base/format.h"
#include "dataset/statements/connection_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = SplineStatement;
using V = ArgumentValue;

constexpr std::size_t LeastPoints = 4;

// A single curve at z = 0 is written, and read, without its z.
Field<S> curvesField() {
    Field<S> curves(ArgumentRule("Y", Kind::Real, ExactOnly).of(LeastPoints, NoLimit).required().repeated());
    curves.write = [](StatementWriter& writer, const S& s) {
        for (const auto& [z, y] : s.curves) {
            std::vector<double> numbers = y;
            if (s.curves.size() > 1 || z != 0) numbers.insert(numbers.begin(), z);
            writer.add("Y", numbers);
        }
    };
    curves.equal = [](const S& a, const S& b) { return a.curves == b.curves; };
    return curves;
}

const FieldTable<S>& getFields() {
    static const FieldTable<S> fields = {
        field({"LINEAR_EXTRAPOLATE", Kind::Flag}, &S::linearExtrapolate),
        field(ArgumentRule("X", Kind::Real, ExactOnly).of(LeastPoints, NoLimit).required(), &S::x),
        curvesField(),
        ArgumentRule("FILE", Kind::Unsupported, 2),
        ArgumentRule("CHANNEL", Kind::Unsupported),
        ArgumentRule("BLOCK", Kind::Unsupported),
        subroutineRule()};
    return fields;
}

// The lists as given; they are understood when all are known.
struct SplineArguments : S {
    V xs;
    std::vector<V> ys;  ///< for each curve its y at each x, or z and then these
};

const FieldTable<SplineArguments>& getArguments() {
    using A = SplineArguments;
    static const FieldTable<A> arguments =
        FieldTable<A>{getFields()}
            .onRead("X", [](A& a, const V& given) { a.xs = given; })
            .onRead("Y", [](A& a, const V& given) { a.ys.push_back(given); });
    return arguments;
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

void read(StatementReader& reader) {
    SplineArguments spline;
    if (!reader.readStatement(getArguments(), spline)) return;
    checkX(reader, spline.xs);
    spline.x = std::move(spline.xs.numbers);
    understandCurves(reader, spline);
    if (!reader.hasErrors()) reader.updState().dataset.splines.push_back(std::move(spline));
}

}  // namespace

StatementKind describeSpline() {
    return readBy(read, makeKind("SPLINE", 3, getFields(), &Dataset::splines));
}

}  // namespace jprim
